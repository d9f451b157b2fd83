#include "grader/matrix/mutation.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <set>

namespace {

using muelle::grader::mutated;
using muelle::grader::Mutation;
using muelle::grader::mutations;

/// All mutated sources, as a set: the order and the places are another test's matter.
std::set<std::string> mutants(const std::string& source) {
  std::set<std::string> result;
  for (const Mutation& mutation : mutations(source)) result.insert(mutated(source, mutation));
  return result;
}

using Sources = std::set<std::string>;

TEST(Mutations, ExchangeArithmetic) {
  EXPECT_EQ(mutants("a + b;"), (Sources{"a - b;"}));
  EXPECT_EQ(mutants("a * b;"), (Sources{"a / b;"}));
  EXPECT_EQ(mutants("a % b;"), (Sources{"a * b;", "a / b;"}));
  EXPECT_EQ(mutants("a += b;"), (Sources{"a -= b;", "a = b;"}));
}

TEST(Mutations, DropAndAddASign) {
  EXPECT_EQ(mutants("return -a;"), (Sources{"return a;"}));
  EXPECT_EQ(mutants("return a;"), (Sources{"return - a;"}));
  EXPECT_EQ(mutants("x = a;"), (Sources{"x = - a;"}));
  EXPECT_EQ(mutants("f(-a);"), (Sources{"f(a);"}));
}

TEST(Mutations, GiveNoSignToZero) {
  EXPECT_EQ(mutants("return Vec3::Zero();"), (Sources{"return Vec3::Ones();"}));
  EXPECT_EQ(mutants("double E = 0.0;"), (Sources{"double E = 1.0;"}));
}

TEST(Mutations, TryEveryOtherComparison) {
  EXPECT_EQ(mutants("if (a < b)"), (Sources{"if (a <= b)", "if (a > b)", "if (a >= b)", "if (a == b)", "if (a != b)"}));
}

TEST(Mutations, ShiftNumbers) {
  EXPECT_EQ(mutants("f(0);"), (Sources{"f(1);"}));
  EXPECT_EQ(mutants("f(1);"), (Sources{"f(2);", "f(0);"}));
  EXPECT_EQ(mutants("f(0.5);"), (Sources{"f(1.0);", "f(0.25);"}));
  EXPECT_EQ(mutants("f(1e-9);"), (Sources{"f(2e-09);", "f(5e-10);"}));
}

TEST(Mutations, LeaveTypesAlone) {
  EXPECT_EQ(mutants("const Vec3& f(const std::vector<std::array<double, 3>>& a, double* b, auto&& c);"), Sources{});
  EXPECT_EQ(mutants("using X = Eigen::Matrix<double, 9, 1>;\nnamespace a::b {\n}"), Sources{});
  EXPECT_EQ(mutants("x.segment<3>(i);"), Sources{});
}

TEST(Mutations, SwapParametersOfOneType) {
  const std::string source = "double f(double a, double b, int n) { g(a, n, s.b, a::b); }";
  EXPECT_EQ(mutants(source), (Sources{"double f(double a, double b, int n) { g(b, n, s.b, a::b); }",
                                      "double f(double a, double b, int n) { g(a, n, s.b, b::b); }"}));
}

TEST(Mutations, SwapNoParametersOfAnotherFunction) {
  EXPECT_EQ(mutants("void f(int a) { g(a); }\nvoid h(int a, int b) { g(b); }"),
            (Sources{"void f(int a) { g(a); }\nvoid h(int a, int b) { g(a); }"}));
}

TEST(Mutations, ExchangeAndDropFunctions) {
  EXPECT_EQ(mutants("std::max(a, b);"), (Sources{"std::min(a, b);"}));
  EXPECT_EQ(mutants("std::abs(a);"), (Sources{"(a);"}));
  EXPECT_EQ(mutants("v.norm();"), (Sources{"v.squaredNorm();"}));
  EXPECT_EQ(mutants("v.head<3>();"), (Sources{"v.tail<3>();"}));
}

TEST(Mutations, LeaveCommentsAndTextsAlone) {
  EXPECT_EQ(mutants("// a - b\n/* 1 + 2 */ f(\"a - 1\");\n#include <a-b>\n"), Sources{});
}

TEST(Mutations, KnowTheirPlace) {
  const std::string source = "void f() {\n  x = y;\n  a += 1;\n}\nvoid g() {\n  a += 1;\n}\n";
  std::vector<Mutation> found = mutations(source);
  std::erase_if(found, [](const Mutation& mutation) { return mutation.text() != "+= -> -="; });
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].place(), "3:5 += -> -=");
  EXPECT_EQ(found[0].lineText, "a += 1;");
  EXPECT_EQ(found[0].occurrence, 1);
  EXPECT_EQ(found[1].place(), "6:5 += -> -=");
  EXPECT_EQ(found[1].occurrence, 2);
}

TEST(Mutations, CountTheSameTokenOfALine) {
  std::vector<Mutation> found = mutations("z = - a - b - c;");
  std::erase_if(found, [](const Mutation& mutation) { return mutation.replacement != "+"; });
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].occurrence, 2);  // the first minus is the sign
  EXPECT_EQ(found[1].occurrence, 3);
}

TEST(Mutations, AreAllDifferent) {
  const std::string source =
      "double f(double a, double b) {\n  if (a <= b) return -a;\n  return std::abs(a - b) / 2;\n}\n";
  const std::vector<Mutation> found = mutations(source);
  EXPECT_EQ(mutants(source).size(), found.size());
  EXPECT_FALSE(mutants(source).contains(source));
}

}  // namespace
