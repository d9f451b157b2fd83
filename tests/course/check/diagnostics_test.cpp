/// \file
/// What g++ 12 wrote for usual mistakes, and what the student reads of it.

#include "course/check/diagnostics.h"

#include <gtest/gtest.h>

namespace muelle {
namespace {

const std::vector<StudentFile> springFiles{{"spring.cpp",
                                            "#include \"spring.h\"\n"
                                            "\n"
                                            "Vec3 f(const Vec3& a, const Vec3& b) {\n"
                                            "  const Vec3 d = a - b\n"
                                            "  return d - 1.0;\n"
                                            "}\n"}};

TEST(Diagnostics, ShowsTheStudentsLineWithACaret) {
  EXPECT_EQ(cutDiagnostics("spring.cpp: In function 'Vec3 f(const Vec3&, const Vec3&)':\n"
                           "dir/spring.cpp:5:10: error: 'e' was not declared in this scope\n"
                           "    5 |   return e - 1.0;\n"
                           "      |          ^\n",
                           springFiles),
            "spring.cpp:5:10: error: 'e' was not declared in this scope\n"
            "    5 |   return d - 1.0;\n"
            "      |          ^\n");
}

TEST(Diagnostics, LeadsFromInsideEigenToTheStudentsLine) {
  const auto found = parseDiagnostics(
      "In file included from /usr/include/eigen3/Eigen/Core:164,\n"
      "                 from spring.cpp:1:\n"
      "/usr/include/eigen3/Eigen/src/Core/AssignEvaluator.h: In instantiation of 'void "
      "Eigen::internal::call_assignment_no_alias(Dst&, const Src&, const Func&) [with Dst = Eigen::Matrix<double, 2, "
      "1>; "
      "Src = Eigen::CwiseBinaryOp<Eigen::internal::scalar_difference_op<double, double>, const Eigen::Matrix<double, "
      "3, 1>, "
      "const Eigen::Matrix<double, 3, 1> >]':\n"
      "/usr/include/eigen3/Eigen/src/Core/Matrix.h:423:29:   required from 'Eigen::Matrix<...>::Matrix(...)'\n"
      "spring.cpp:4:18:   required from here\n"
      "/usr/include/eigen3/Eigen/src/Core/AssignEvaluator.h:887:3: error: static assertion failed: "
      "YOU_MIXED_MATRICES_OF_DIFFERENT_SIZES\n"
      "/usr/include/eigen3/Eigen/src/Core/AssignEvaluator.h:887:3: note: '(((((int)...' evaluates to false\n",
      springFiles);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].file, "spring.cpp");
  EXPECT_EQ(found[0].line, 4);
  EXPECT_EQ(found[0].column, 18);
  EXPECT_EQ(found[0].message, "vectors or matrices of different sizes are mixed in this line (a Vec2 and a Vec3)");
}

TEST(Diagnostics, ANumberTypeMixedInEigenIsTranslated) {
  const auto found = parseDiagnostics(
      "/usr/E.h: In instantiation of 'void g()':\n"
      "spring.cpp:4:18:   required from here\n"
      "/usr/E.h:888:3: error: static assertion failed: "
      "YOU_MIXED_DIFFERENT_NUMERIC_TYPES__YOU_NEED_TO_USE_THE_CAST_METHOD\n",
      springFiles);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NE(found[0].message.find("float, int and double do not mix"), std::string::npos);
}

TEST(Diagnostics, OperatorsNameTheirOperands) {
  const auto found = parseDiagnostics(
      "spring.cpp:5:12: error: no match for 'operator-' in 'Eigen::MatrixBase<Derived>::operator-(x) [with Derived = "
      "Eigen::Matrix<double, 3, 1>] - 1' (operand types are 'const muelle::Vec3' {aka 'const Eigen::Matrix<double, 3, "
      "1>'} "
      "and 'double')\n"
      "/usr/E.h:19:1: note: candidate: 'template<class OtherDerived> ...'\n"
      "spring.cpp:5:12: note:   mismatched types 'const Eigen::MatrixBase<Derived>' and 'double'\n",
      springFiles);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].message, "no match for 'operator-' (operand types are 'const Vec3' and 'double')");
  EXPECT_NE(found[0].explanation.find("a number and a vector do not add up"), std::string::npos);
}

TEST(Diagnostics, ASemicolonIsMissingWhereTheLineBeforeEnds) {
  const auto found = parseDiagnostics("spring.cpp:5:3: error: expected ',' or ';' before 'return'\n", springFiles);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].explanation, "a semicolon is missing, most likely at the end of line 4");
}

TEST(Diagnostics, AVectorForANumberIsExplained) {
  const auto found = parseDiagnostics(
      "spring.cpp:4:20: error: cannot convert 'const "
      "Eigen::CwiseBinaryOp<Eigen::internal::scalar_difference_op<double, "
      "double>, const Eigen::Matrix<double, 3, 1>, const Eigen::Matrix<double, 3, 1> >' to 'double' in "
      "initialization\n",
      springFiles);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].message, "cannot convert 'Eigen expression' to 'double' in initialization");
  EXPECT_NE(found[0].explanation.find(".norm()"), std::string::npos);
}

TEST(Diagnostics, AnotherReturnTypeQuotesTheContract) {
  const auto found = parseDiagnostics(
      "spring.cpp:3:8: error: ambiguating new declaration of 'double f(const muelle::Vec3&)'\n"
      "spring.h:4:6: note: old declaration 'muelle::Vec3 f(const muelle::Vec3&)'\n",
      springFiles);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].explanation, "the contract gives this function another return type: Vec3 f(const Vec3&)");
}

TEST(Diagnostics, WhatIsDefinedTwiceIsSaidToBeWhereTheFirstStands) {
  const auto explained = [](const std::string& first) {
    return parseDiagnostics("spring.cpp:3:8: error: redefinition of 'struct S'\n" + first +
                                ":11:8: note: previous definition of 'struct S'\n",
                            springFiles)
        .at(0)
        .explanation;
  };
  EXPECT_EQ(explained("spring.cpp"), "it is written twice in the file: keep one (the first stands in line 11)");
  EXPECT_EQ(explained("/a/spring.h"), "the contract spring.h already defines it, in line 11: take yours out");
  EXPECT_EQ(explained("/a/types.h"), "types.h already defines it, in line 11: take yours out");
}

TEST(Diagnostics, WarningsInsideEigenSpeakOfAutoOnlyWhereItStands) {
  const auto explained = [](const std::string& source) {
    return parseDiagnostics(
               "In function 'f',\n    inlined from 'Vec3 f()' at spring.cpp:2:3:\n"
               "/e/Core.h:7:9: warning: '*(double*)x' is used uninitialized [-Wuninitialized]\n",
               {{"spring.cpp", source}})
        .at(0)
        .explanation;
  };
  EXPECT_TRUE(explained("Vec3 f() { auto x = g() + g();\n  return x; }\n").starts_with("'auto' does not keep"));
  EXPECT_EQ(explained("Vec3 f() { Vec3 x;\n  return x + x; }\n"),
            "it is read before a value was given to it, or a temporary or local variable that is gone is used");
}

TEST(Diagnostics, OneErrorALineAndWarningsOnlyWhenNothingIsWrong) {
  const std::string warning = "spring.cpp:3:12: warning: unused parameter 'a' [-Wunused-parameter]\n";
  const std::string errors = "spring.cpp:5:3: error: one\nspring.cpp:5:9: error: two\nspring.cpp:6:1: error: three\n";
  EXPECT_EQ(parseDiagnostics(warning, springFiles).size(), 1U);
  EXPECT_FALSE(parseDiagnostics(warning, springFiles)[0].isError);
  const auto found = parseDiagnostics(warning + errors, springFiles);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].message, "one");
  EXPECT_EQ(found[1].message, "three");
}

TEST(Diagnostics, ManyErrorsAreCut) {
  std::string text;
  std::vector<StudentFile> longFile{{"spring.cpp", std::string(50, '\n')}};
  for (int line = 1; line <= 9; ++line) text += "spring.cpp:" + std::to_string(line) + ":1: error: e\n";
  const std::string shown = cutDiagnostics(text, longFile);
  EXPECT_NE(shown.find("spring.cpp:3:1"), std::string::npos);
  EXPECT_EQ(shown.find("spring.cpp:4:1"), std::string::npos);
  EXPECT_NE(shown.find("and 6 more errors"), std::string::npos);
}

TEST(Diagnostics, QuotesNoFileButTheStudents) {
  const std::string shown = cutDiagnostics(
      "/hidden/secret_test.cpp:3:1: error: expected unqualified-id before numeric constant\n"
      "    3 | 42 is the answer\n"
      "      | ^~\n",
      springFiles);
  EXPECT_EQ(shown, "secret_test.cpp:3: error: expected unqualified-id before numeric constant\n");
}

TEST(Diagnostics, EscapesWhatATerminalWouldObey) {
  EXPECT_EQ(cutDiagnostics("spring.cpp:2:1: error: #error \x1b[2J\n", springFiles).find('\x1b'), std::string::npos);
}

TEST(Diagnostics, SurvivesNonsense) {
  EXPECT_EQ(cutDiagnostics("", springFiles), "");
  EXPECT_EQ(cutDiagnostics(": error: \n:::\n   required from here\n", springFiles), ":0: error: \n");
  EXPECT_NE(cutDiagnostics("spring.cpp:99999999:1: error: x\n", springFiles), "");
  EXPECT_NE(cutDiagnostics("spring.cpp:-5:-1: error: x\n", springFiles), "");
}

TEST(Diagnostics, AnErrorOfTheAssemblersIsAnError) {
  const auto found = parseDiagnostics("spring.cpp: Assembler messages:\nspring.cpp:2: Error: file not found: /x\n",
                                      {{"spring.cpp", "\nasm(\"\");\n"}});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].message, "file not found: /x");
  EXPECT_EQ(found[0].line, 2);
}

}  // namespace
}  // namespace muelle
