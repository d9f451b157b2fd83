#include "course/check/compile_rules.h"

#include "course/check/sanitizer_report.h"

#include <gtest/gtest.h>
#include <algorithm>

namespace muelle {
namespace {

TEST(CompileRules, AListOfPartsKeepsAnyPath) {
  const std::vector<std::string> parts{"/a folder/o'brien \"x\"/\\b.o", "-pthread", "/mañana/c.o"};
  EXPECT_EQ(readParts("/a folder/o'brien \"x\"/\\b.o\n-pthread\n\n/mañana/c.o\n"), parts);
}

TEST(CompileRules, UninitialisedMemoryIsFilledInBothBuilds) {
  for (const auto& flags : {studentCompileFlags(), sanitizedCompileFlags()}) {
    EXPECT_NE(std::ranges::find(flags, "-DEIGEN_INITIALIZE_MATRICES_BY_NAN"), flags.end());
    EXPECT_EQ(std::ranges::find(flags, "-w"), flags.end());
  }
}

/// Or it could refuse to be compiled with them, or hide what they would find.
TEST(CompileRules, NoMacroTellsASourceOfTheSanitizers) {
  const std::vector<std::string> flags = sanitizedCompileFlags();
  EXPECT_NE(std::ranges::find(flags, "-U__SANITIZE_ADDRESS__"), flags.end());
}

TEST(SanitizerReport, NamesTheStudentsLine) {
  const std::vector<StudentFile> files{{"triangle.cpp", ""}};
  const SanitizerFinding gone = explainSanitizers(
      "printed\n=====\n==7==ERROR: AddressSanitizer: stack-use-after-return on address 0x7f\n"
      "READ of size 8\n    #0 0x5 in Eigen::x /usr/include/eigen3/Eigen/Core.h:3\n"
      "    #1 0x5 in triangleForce(double) /a/triangle.cpp:26\n",
      files);
  EXPECT_EQ(gone.sentence, "triangle.cpp:26 uses a local variable of a function that has returned");
  EXPECT_EQ(gone.outcome, Outcome::Crash);
  EXPECT_EQ(explainSanitizers("a/triangle.cpp:9:8: runtime error: execution reached the end of a value-returning "
                              "function without returning a value\n",
                              files)
                .sentence,
            "triangle.cpp:9 ends without returning a value");
}

TEST(SanitizerReport, SpeaksOfAutoOnlyWhereItStands) {
  const auto said = [](const std::string& source) {
    return explainSanitizers("==7==ERROR: AddressSanitizer: stack-use-after-scope\n #0 f /a/triangle.cpp:2\n",
                             {{"triangle.cpp", source}})
        .sentence;
  };
  const std::string gone = "triangle.cpp:2 uses a temporary or local variable that is gone";
  EXPECT_EQ(said("Vec3 f() { auto x = g() + g();\n return x; }\n"),
            gone + " ('auto' keeps no Eigen expression's values: write Vec3 or VecX)");
  EXPECT_EQ(said("auto y = 1;\nVec3 f() { return [&] { return g(); }(); }\n"), gone);
}

TEST(SanitizerReport, WhatStandsElsewhereIsNotTheStudents) {
  EXPECT_EQ(explainSanitizers("==7==ERROR: AddressSanitizer: heap-buffer-overflow\n #0 f /a/public_test.cpp:3\n",
                              {{"triangle.cpp", ""}})
                .sentence,
            "");
  EXPECT_EQ(explainSanitizers("", {{"triangle.cpp", ""}}).sentence, "");
}

/// The sanitizers themselves take several times as much of them.
TEST(SanitizerReport, StackAndMemoryThatRunOutConfirmNothing) {
  for (const char* finding : {"stack-overflow", "out-of-memory", "allocation-size-too-big", "hard rss limit", "SEGV"}) {
    EXPECT_EQ(confirmedOutcome(finding), Outcome::Passed) << finding;
    EXPECT_EQ(explainSanitizers(std::string("==7==ERROR: AddressSanitizer: ") + finding + "\n #0 f /a/triangle.cpp:3\n",
                                {{"triangle.cpp", ""}})
                  .sentence,
              "");
  }
  EXPECT_EQ(confirmedOutcome("stack-buffer-overflow"), Outcome::Crash);
  EXPECT_EQ(confirmedOutcome("missing-return spring_1d.cpp:3"), Outcome::Crash);
}

}  // namespace
}  // namespace muelle
