#include "course/check/symbols.h"

#include <gtest/gtest.h>

namespace muelle {
namespace {

SymbolVerdict judge(std::string_view nmText) { return judgeSymbols(readSymbols(nmText)); }

TEST(Symbols, ReadsWhatNmWrites) {
  const Symbols symbols = readSymbols(
      "a.o:\n_Z5forced T 0 3f\n_ZL5helper t 40 8\ncos U         \n_Z4massd U         \n_ZSt3cin V 0 4\n"
      "b.o:\n_Z4massd T 0 8\n");
  EXPECT_EQ(symbols.undefined, std::vector<std::string>{"cos"});
  EXPECT_EQ(symbols.defined, (std::vector<std::string>{"_Z5forced", "_ZSt3cin", "_Z4massd"}));
}

TEST(Symbols, MainIsLeftOut) {
  const SymbolVerdict verdict = judge("main T 0 10\nsystem U\n");
  EXPECT_EQ(verdict.outcome, Outcome::Link);
  EXPECT_EQ(verdict.message, "your file defines main: leave it out");
}

TEST(Symbols, TheCauseIsNamedAsTheStudentWritesIt) {
  EXPECT_EQ(judge("_ZSt3cin U\n").message, "it reads the keyboard (std::cin): nobody types while it is tested");
  EXPECT_EQ(judge("__isoc99_scanf U\n").message, "it reads the keyboard (scanf): nobody types while it is tested");
  EXPECT_EQ(judge("_ZNSt14basic_ifstreamIcSt11char_traitsIcEEC1EPKcSt13_Ios_Openmode U\n").message,
            "it works with files (std::ifstream): what it needs comes as arguments");
  for (const char* name : {"system U\n", "fork U\n", "pthread_create U\n", "socket U\n", "nanosleep U\n", "kill U\n",
                           "mmap U\n", "feenableexcept U\n", "getenv U\n", "dlopen U\n", "syscall U\n", "unlink U\n"}) {
    EXPECT_EQ(judge(name).outcome, Outcome::Forbidden) << name;
  }
}

/// Each ends a worker of the grader by its filter of system calls.
TEST(Symbols, WhatTheGraderWouldEndIsRefusedByName) {
  for (const char* name : {"setlocale",
                           "_ZNSt6localeC1EPKc",
                           "newlocale",
                           "ctime",
                           "localtime",
                           "localtime_r",
                           "gmtime",
                           "mktime",
                           "timegm",
                           "strftime",
                           "tzset",
                           "sysconf",
                           "get_nprocs",
                           "getcwd",
                           "__getcwd_chk",
                           "chdir",
                           "realpath",
                           "isatty",
                           "ttyname",
                           "getrusage",
                           "getrlimit64",
                           "times",
                           "perror",
                           "dprintf",
                           "fseek",
                           "fclose",
                           "umask",
                           "gethostname",
                           "uname",
                           "getuid",
                           "popen",
                           "dlopen",
                           "getpwuid",
                           "statvfs",
                           "nice",
                           "usleep",
                           "sched_getaffinity",
                           "pthread_setname_np",
                           "_ZNSt6thread20hardware_concurrencyEv",
                           "_ZNSt13random_device7_M_initERKNSt7__cxx1112basic_stringIcSt11char_traitsIcESaIcEEE",
                           "_ZNSt10filesystem12current_pathB5cxx11Ev"}) {
    EXPECT_EQ(judge(std::string(name) + " U\n").outcome, Outcome::Forbidden) << name;
  }
  EXPECT_EQ(judge("localtime U\n").message,
            "it asks for the time of a place (localtime): what it needs comes as arguments");
  EXPECT_EQ(judge("__getcwd_chk U\n").message, "it works with files (getcwd): what it needs comes as arguments");
}

TEST(Symbols, AVersionHidesNoName) { EXPECT_EQ(judge("open@GLIBC_2.2.5 U\n").message, judge("open U\n").message); }

TEST(Symbols, TheProgramsMemoryIsNotReplaced) {
  for (const char* name : {"_Znwm", "_ZnamSt11align_val_t", "_ZnwmRKSt9nothrow_t"}) {
    const SymbolVerdict verdict = judge(std::string(name) + " T 0 5\n");
    EXPECT_EQ(verdict.outcome, Outcome::Forbidden) << name;
    EXPECT_EQ(verdict.message, "it replaces operator new for the whole program: leave it out");
  }
  for (const char* name : {"_ZdlPv", "_ZdaPvm", "_ZdlPvmSt11align_val_t", "malloc", "free", "realloc"}) {
    EXPECT_EQ(judge(std::string(name) + " T 0 5\n").outcome, Outcome::Forbidden) << name;
  }
  EXPECT_EQ(judge("_ZdlPv T 0 5\n_Znwm T 0 5\n").message,
            "it replaces operator new for the whole program: leave it out");
  // Placement, a pool's, a class's.
  EXPECT_EQ(judge("_ZnwmPv W 0 5\n_ZnwmR4Pool T 0 5\n_ZN4PoolnwEm T 0 5\n_ZdlPvR4Pool T 0 5\n").outcome,
            Outcome::Passed);
}

TEST(Symbols, ATableThatDoesNotFitIsNamed) {
  const SymbolVerdict verdict = judge("table B 0 47868c00\n_Z4massd T 0 8\n");
  EXPECT_EQ(verdict.outcome, Outcome::Crash);
  EXPECT_EQ(verdict.message,
            "it does not fit into memory: table takes 1144 MiB of memory before anything runs; all static variables "
            "together may take 512");
  EXPECT_NE(judge("_ZL5table b 0 ffffffffffffffff\n_ZL5other b 0 ffffffffffffffff\n").outcome, Outcome::Passed);
  EXPECT_EQ(judge("_ZL5table b 0 10000000\n_Z4massd T 0 80000000\n").outcome, Outcome::Passed);
}

TEST(Symbols, WhatComputingNeedsIsAllowed) {
  EXPECT_EQ(judge("_ZSt4cout U\nprintf U\nputs U\nabort U\nexit U\nmalloc U\nfree U\nmemcpy U\n_Znwm U\n_ZdlPvm U\n"
                  "__cxa_atexit U\n_ZNSt8ios_base4InitC1Ev U\nstderr U\nfprintf U\nclock U\ntime U\nrand U\n"
                  "clock_gettime U\n_ZNSt6chrono3_V212steady_clock3nowEv U\nsetvbuf U\nfflush U\ngetpagesize U\n"
                  "_ZNSt6localeC1Ev U\n_ZNSt6locale7classicEv U\n_ZNSt6localeC1ERKS_ U\n__sprintf_chk U\n"
                  "_ZNSt7__cxx1118basic_stringstreamIcSt11char_traitsIcESaIcEEC1Ev U\n__memcpy_chk U\nstrtod U\n"
                  "posix_memalign U\nlocaleconv U\nstrerror U\nasctime U\ndifftime U\n")
                .outcome,
            Outcome::Passed);
}

TEST(Symbols, AFunctionOfTheStudentsOwnIsNoOneElses) {
  EXPECT_EQ(judge("read T 0 4\n_Z4openv U\n").outcome, Outcome::Passed);
}

TEST(JudgeSymbols, RefusesNamesThatOthersLookUp) {
  const SymbolVerdict own = judgeSymbols(readSymbols("muelleServe T 0 5\n_Z10lumpedMassdi T 10 20\n"));
  EXPECT_EQ(own.outcome, Outcome::Link);
  EXPECT_EQ(own.message, "muelleServe is defined in your file: the course has a function of that name");
  const SymbolVerdict hook = judgeSymbols(readSymbols("__asan_on_error T 0 5\n"));
  EXPECT_EQ(hook.outcome, Outcome::Forbidden);
  EXPECT_EQ(hook.message, "it defines __asan_on_error, which is for the sanitizers to define");
  // Those of the harness, and what a sanitised object takes from elsewhere.
  EXPECT_EQ(judgeSymbols(readSymbols("_ZN6muelle5node3E W 0 5\n__asan_init U\n")).outcome, Outcome::Passed);
}

}  // namespace
}  // namespace muelle
