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
                           "mmap U\n", "getenv U\n", "dlopen U\n", "syscall U\n", "unlink U\n"}) {
    EXPECT_EQ(judge(name).outcome, Outcome::Forbidden) << name;
  }
}

TEST(Symbols, WhatComputingNeedsIsAllowed) {
  EXPECT_EQ(judge("_ZSt4cout U\nprintf U\nputs U\nabort U\nexit U\nmalloc U\nfree U\nmemcpy U\n_Znwm U\n_ZdlPvm U\n"
                  "__cxa_atexit U\n_ZNSt8ios_base4InitC1Ev U\nstderr U\nfprintf U\nclock U\ntime U\nrand U\n")
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
