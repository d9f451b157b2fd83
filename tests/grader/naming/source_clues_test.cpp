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

TEST(SourceClues, FindSinglePrecision) {
  const auto found = singlePrecision("// float\ndouble f() {\n  float x = 1;\n}");
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->line, 3);
  EXPECT_FALSE(singlePrecision("double floating = 1;").has_value());
}

}  // namespace
}  // namespace muelle::grader
