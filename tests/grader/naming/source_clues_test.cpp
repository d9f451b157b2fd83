#include "grader/naming/source_clues.h"

#include <gtest/gtest.h>

namespace muelle::grader {
namespace {

TEST(SourceClues, FindADivisionOfWholeNumbersInTheFunction) {
  const std::string source = "double f(double x) {\n  return 1/2 * x;\n}\ndouble g(double x) { return 1.0 / 2 * x; }\n";
  const auto found = integerDivision(source, "f");
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->line, 2);
  EXPECT_EQ(found->token, "1/2");
  EXPECT_FALSE(integerDivision(source, "g").has_value());
  EXPECT_FALSE(integerDivision("double f(double x) { return x * 1 / 2.5; }", "f").has_value());
  EXPECT_FALSE(integerDivision("// 1/2\ndouble f(double x) { return x; }", "f").has_value());
}

TEST(SourceClues, FindASumThatStartsFromAWholeNumber) {
  EXPECT_TRUE(integerDivision("double f(V m) { return std::accumulate(m.begin(), m.end(), 0); }", "f").has_value());
  EXPECT_FALSE(integerDivision("double f(V m) { return std::accumulate(m.begin(), m.end(), 0.0); }", "f").has_value());
}

TEST(SourceClues, LookIntoWhatTheFunctionCalls) {
  const std::string source = "double half(double x) {\n  return 1/2 * x;\n}\ndouble f(double x) { return half(x); }\n";
  const auto found = integerDivision(source, "f");
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->line, 2);
  EXPECT_FALSE(
      integerDivision("double g(double x) { return 1/2; }\ndouble f(double x) { return x; }", "f").has_value());
}

TEST(SourceClues, FindANumberWithAFractionInAVariableOfWholeNumbers) {
  const auto found = wholeVariable("double f(double x) {\n  const int rate = 2 * x;\n  return rate;\n}", "f");
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->line, 2);
  EXPECT_EQ(found->token, "rate");
  EXPECT_TRUE(wholeVariable("double f(double x) { int s = 0; s += 2 * x; return s; }", "f").has_value());
  EXPECT_TRUE(wholeVariable("Vec3 f(const Vec3& v) { int s = v.norm(); return s * v; }", "f").has_value());
  EXPECT_TRUE(wholeVariable("double f(double x) { double y = x; long z{y}; return z; }", "f").has_value());
  for (const char* right :
       {"double f(double x) { int i = 3; return i * x; }", "double f(V m) { int n = m.size(); return n; }",
        "double f(V m) { for (int i = 0; i < 3; ++i) {} return m[0]; }",
        "double f(double x, S s) { const int j = (s.a + 1) % 3; return x * j; }",
        "Vec3 f(const Vec3& a, S s) { Vec3 F = Vec3::Zero(); const int other = s.i == 1 ? s.j : s.a; return other * F; "
        "}"}) {
    EXPECT_FALSE(wholeVariable(right, "f").has_value()) << right;
  }
}

TEST(SourceClues, FindSinglePrecision) {
  const auto found = singlePrecision("// float\ndouble f() {\n  float x = 1;\n}");
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->line, 3);
  EXPECT_FALSE(singlePrecision("double floating = 1;").has_value());
}

}  // namespace
}  // namespace muelle::grader
