#include "course/testing/print_value.h"

#include <gtest/gtest.h>
#include <cmath>
#include <Eigen/SparseCore>
#include <limits>

struct SpringEnd {
  muelle::Vec3 other;
  double k;
  double L0;
};
MUELLE_STRUCT(SpringEnd, other, k, L0)

namespace muelle {
namespace {

// Each line prints a value that was written as C++ and asserts that the text is that same C++.
#define EXPECT_PRINTS(...) EXPECT_EQ(printValue(__VA_ARGS__), #__VA_ARGS__)

TEST(PrintValue, WritesNumbersThatReadBackTheSame) {
  for (const double value : {0.1, 1.0 / 3.0, 1e-300, -2.5, 1e22, 5e-324, 1.7976931348623157e308, 123456789.123456789}) {
    EXPECT_EQ(std::strtod(printValue(value).c_str(), nullptr), value);
  }
  EXPECT_EQ(printValue(std::nan("")), "NAN");
  EXPECT_EQ(printValue(HUGE_VAL), "INFINITY");
  EXPECT_EQ(printValue(-HUGE_VAL), "-INFINITY");
  EXPECT_EQ(printValue(-0.0), "-0");
  EXPECT_EQ(std::strtof(printValue(0.1f).c_str(), nullptr), 0.1f);
}

TEST(PrintValue, WritesVectorsAndMatricesAsSource) {
  EXPECT_PRINTS(Vec2(1, 2.5));
  EXPECT_PRINTS(Vec3(1, -2, 0.001));
  EXPECT_PRINTS(Vec6{{1, 2, 3, 4, 5, 6}});
  EXPECT_PRINTS(VecX{{1.5, 2.5, 3.5, 4.5}});
  EXPECT_PRINTS(VecX{{7}});
  EXPECT_PRINTS(VecX(0));
  EXPECT_PRINTS(Mat2{{1, 2}, {3, 4}});
  EXPECT_PRINTS(MatX{{1, 2, 3}, {4, 5, 6}});
  EXPECT_PRINTS(MatX{{1, 2}});
  EXPECT_PRINTS(MatX(0, 3));
  const VecX two{{2, 3}};
  EXPECT_EQ(printValue(two), "VecX{{2, 3}}");
  EXPECT_EQ(two.size(), 2);
}

TEST(PrintValue, WritesListsStructsAndWords) {
  EXPECT_EQ(printValue(std::vector<double>{1, 2.5}), "{1, 2.5}");
  EXPECT_EQ(printValue(std::vector<int>{}), "{}");
  EXPECT_EQ(printValue(std::array<Vec2, 2>{Vec2(1, 2), Vec2(3, 4)}), "{Vec2(1, 2), Vec2(3, 4)}");
  EXPECT_PRINTS(SpringEnd{Vec3(1, 2, 3), 100, 0.5});
  EXPECT_EQ(printValue(true), "true");
  EXPECT_EQ(printValue(-3), "-3");
  EXPECT_EQ(printValue(std::function<double(double)>()), "/* a function of the test */");
}

TEST(PrintValue, WritesAFunctionThatHasItsSource) {
  const TestFunction<double(double)> twice("[](double x) { return 2 * x; }", [](double x) { return 2 * x; });
  const std::function<double(double)> passed = twice;
  EXPECT_EQ(printValue(passed), "[](double x) { return 2 * x; }");
  EXPECT_EQ(passed(3), 6);
  EXPECT_EQ(twice.calls(), 1) << "copies count together";
}

TEST(PrintValue, ShowsTheBeginningOfLongLists) {
  std::vector<int> list(300, 7);
  EXPECT_EQ(printValue(list).size(), 900U);  // "{7, 7, ... 7}"
  list.push_back(8);
  EXPECT_EQ(printValue(list), "{7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, /* and 289 more */}");
  EXPECT_EQ(printValue(VecX(VecX::Constant(301, 7))), "VecX{{7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, /* and 289 more */}}");
}

TEST(PrintValue, WritesSparseMatrices) {
  Eigen::SparseMatrix<double> m(2, 2);
  m.insert(1, 0) = 2.5;
  EXPECT_EQ(printValue(m), "MatX{{0, 0}, {2.5, 0}}.sparseView()");
  const Eigen::SparseMatrix<double> again = MatX{{0, 0}, {2.5, 0}}.sparseView();
  EXPECT_EQ(MatX(again), MatX(m));
}

TEST(PrintCall, JoinsTheArguments) {
  EXPECT_EQ(printCall("f", Vec3(1, 2, 3), 0.5, true), "f(Vec3(1, 2, 3), 0.5, true)");
  EXPECT_EQ(printCall("f"), "f()");
}

}  // namespace
}  // namespace muelle
