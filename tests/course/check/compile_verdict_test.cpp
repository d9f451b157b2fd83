/// \file
/// Recorded words of compilers and linkers that fail, and who is to blame.

#include "course/check/compile_verdict.h"

#include "course/check/probe.h"

#include <gtest/gtest.h>
#include <csignal>

namespace muelle {
namespace {

const std::vector<StudentFile> files{
    {"spring.cpp",
     "#include \"spring.h\"\n#include <vector>\n#include \"secret.h\"\n#include <../../x>\n"
     "double stretch(double);\ndouble f(double x) { return stretch(x); }\n"}};
const std::string contract = "double f(double x);\ndouble g(double x);\n";

CompileVerdict compiled(const std::string& words) { return judgeCompilation({.words = words}, files, {}); }
CompileVerdict linked(const std::string& words) { return judgeLink({.words = words}, files, contract, "spring.h", {}); }

TEST(CompileVerdict, AnErrorInTheStudentsLineIsTheStudents) {
  const CompileVerdict verdict = compiled("spring.cpp:6:10: error: 'e' was not declared in this scope\n");
  EXPECT_TRUE(verdict.isDecided);
  EXPECT_EQ(verdict.outcome, Outcome::Compile);
  EXPECT_EQ(verdict.message, "it does not compile: spring.cpp:6: 'e' was not declared in this scope");
}

TEST(CompileVerdict, WhatOnlyAToolSaysDecidesNothing) {
  for (const char* words :
       {"g++: fatal error: Killed signal terminated program cc1plus\ncompilation terminated.\n",
        "spring.cpp:6:1: internal compiler error: Segmentation fault\n",
        "spring.cpp:6:1: fatal error: error writing to /tmp/ccA.s: No space left on device\n",
        "cc1plus: out of memory allocating 65536 bytes after a total of 1396736 bytes\n",
        "g++: fatal error: CPU time limit exceeded signal terminated program cc1plus\n",
        "g++: fatal error: cannot execute 'cc1plus': execvp: No such file or directory\n",
        "/framework/harness/types.h:7:10: fatal error: Eigen/Core: No such file or directory\n", ""}) {
    const CompileVerdict verdict = compiled(words);
    EXPECT_FALSE(verdict.isDecided) << words;
    EXPECT_NE(verdict.outcome, Outcome::Passed) << words;
    EXPECT_TRUE(afterProbe(verdict, false).isOurs) << words;
    EXPECT_FALSE(afterProbe(verdict, true).isOurs) << words;
  }
}

TEST(CompileVerdict, ALimitIsNamed) {
  const CompileVerdict time = compiled("g++: fatal error: CPU time limit exceeded signal terminated program cc1plus\n");
  EXPECT_EQ(time.outcome, Outcome::Cpu);
  EXPECT_EQ(time.message, "compiling took more than 20 s of processor time");
  EXPECT_EQ(compiled("cc1plus: out of memory allocating 1 bytes\n").message,
            "compiling took more than 2048 MiB of memory");
  EXPECT_EQ(judgeCompilation({.signal = SIGXFSZ}, files, {}).message, "the compiled file is larger than 64 MiB");
}

TEST(CompileVerdict, WhatIsSeenToEndFromOutsideIsNeverTheStudents) {
  for (const ToolRun& run : {ToolRun{.signal = SIGKILL}, ToolRun{.signal = SIGTERM}, ToolRun{.endedFromOutside = true},
                             ToolRun{.words = "spring.cpp:6:10: error: half a wo", .endedFromOutside = true}}) {
    for (const CompileVerdict& verdict :
         {judgeCompilation(run, files, {}), judgeLink(run, files, contract, "spring.h", {})}) {
      EXPECT_FALSE(verdict.isDecided);
      EXPECT_TRUE(verdict.wasKilled);
      EXPECT_TRUE(afterProbe(verdict, true).isOurs);
    }
  }
  EXPECT_FALSE(afterProbe(judgeCompilation({.signal = SIGSEGV}, files, {}), true).isOurs);
  const ToolRun atLimit{.signal = SIGKILL, .processorSeconds = 22.0};
  EXPECT_FALSE(afterProbe(judgeCompilation(atLimit, files, {}), true).isOurs);
}

TEST(CompileVerdict, WhatWasKilledIsWorthOneMoreTry) {
  EXPECT_TRUE(compiled("g++: fatal error: Killed signal terminated program cc1plus\n").wasKilled);
  EXPECT_TRUE(judgeCompilation({.signal = SIGKILL}, files, {}).wasKilled);
  EXPECT_FALSE(compiled("spring.cpp:6:10: error: no\n").wasKilled);
}

TEST(CompileVerdict, ThePassedWallLimitIsTheMachinesEvenWhenTheProbeBuilds) {
  const CompileVerdict verdict = judgeCompilation({.timedOut = true}, files, {});
  EXPECT_EQ(verdict.outcome, Outcome::Wall);
  EXPECT_TRUE(afterProbe(verdict, true).isOurs);
}

TEST(CompileVerdict, TheLinkersWordsBlameOnlyForAKnownName) {
  for (const char* words :
       {"mold: error: undefined symbol: g(double)\n", "ld: undefined reference to `g(double)'\n",
        "mold: error: undefined symbol: stretch(double)\n", "mold: error: duplicate symbol: a.o: b.o: f(double)\n"}) {
    EXPECT_TRUE(linked(words).isDecided) << words;
    EXPECT_EQ(linked(words).outcome, Outcome::Link);
  }
  for (const char* words : {"collect2: fatal error: cannot find 'ld'\ncompilation terminated.\n",
                            "/usr/bin/ld: final link failed: No space left on device\n",
                            "mold: error: undefined symbol: muelle::eigenMessage(double)\n",
                            "collect2: fatal error: ld terminated with signal 9 [Killed]\n"}) {
    EXPECT_FALSE(linked(words).isDecided) << words;
  }
}

TEST(Probe, IncludesWhatTheFileIncludesAndNothingElse) {
  const std::string source = probeSource(files, "spring.h");
  EXPECT_NE(source.find("#include <vector>"), std::string::npos);
  EXPECT_LT(source.find("#include \"spring.h\""), source.find("#include <vector>"));
  EXPECT_EQ(source.find("secret.h"), std::string::npos);
  EXPECT_EQ(source.find("../x"), std::string::npos);
}

}  // namespace
}  // namespace muelle
