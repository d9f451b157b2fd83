#include "course/check/dependencies.h"

#include <gtest/gtest.h>

namespace muelle {
namespace {

const std::vector<StudentFile> theirFile{{"spring.cpp", ""}};
const CompilePlace inSandbox{"/tmp", {"/submission", "/contract", "/framework/harness", "/eigen"}};

std::string refused(const std::string& list) { return judgeDependencies(list, inSandbox, theirFile).message; }

TEST(Dependencies, AreReadAsMakeReadsThem) {
  EXPECT_EQ(readDependencies("a.o: a.cpp \\\n /usr/my\\ folder/x.h\nb.o: /tmp/$$x\\#1.h\n"),
            (std::vector<std::string>{"a.cpp", "/usr/my folder/x.h", "/tmp/$x#1.h"}));
}

TEST(Dependencies, AStandardHeaderIsTheLibrarysTheCompilersOrTheSystems) {
  for (const char* file :
       {"/usr/include/c++/12/vector", "/usr/include/x86_64-linux-gnu/c++/12/bits/os_defines.h", "/usr/include/math.h",
        "/usr/include/x86_64-linux-gnu/bits/types.h", "/usr/lib/gcc/x86_64-linux-gnu/12/include/stddef.h",
        "/Library/Developer/CommandLineTools/SDKs/MacOSX14.sdk/usr/include/mach/boolean.h",
        "/Library/Developer/CommandLineTools/usr/lib/clang/15/include/stddef.h",
        "/opt/homebrew/Cellar/gcc/13/include/c++/13/vector"}) {
    EXPECT_TRUE(isStandardHeader(file)) << file;
  }
  for (const char* file : {"/usr/include/fmt/format.h", "/usr/include/boost/array.hpp", "/etc/passwd",
                           "/elsewhere/helpers.h", "/opt/homebrew/include/fmt/format.h", "/usr/local/include/mine.h"}) {
    EXPECT_FALSE(isStandardHeader(file)) << file;
  }
}

TEST(Dependencies, WhatTheGraderShowsMayBeRead) {
  EXPECT_EQ(
      refused("a.o: ../submission/spring.cpp ../contract/spring.h ../framework/harness/types.h ../eigen/Eigen/Core "
              "/usr/include/c++/12/cmath\na.o: spring.cpp /tmp/ccEPWJCf.s\n"),
      "");
}

TEST(Dependencies, AnythingElseIsRefusedByName) {
  EXPECT_EQ(refused("a.o: /elsewhere/helpers.h\n"),
            "it does not compile: spring.cpp reads /elsewhere/helpers.h, which is not there when it is graded");
  EXPECT_EQ(refused("a.o: /usr/include/fmt/format.h\n"),
            "it does not compile: spring.cpp reads fmt/format.h, which is not there when it is graded");
  EXPECT_NE(refused("a.o: ../framework/harness/../figures/write.h\n"), "");
  EXPECT_NE(refused("a.o: /submissions/x.h\n"), "");
  EXPECT_EQ(judgeDependencies("a.o: /etc/passwd\n", inSandbox, theirFile).outcome, Outcome::Compile);
}

}  // namespace
}  // namespace muelle
