#include "contour.h"
#include "tools.h"

#include <gtest/gtest.h>
#include <cmath>

namespace muelle::plots {
namespace {

Field plane(int n, double (*value)(double, double)) {
  Field field;
  field.x = linear(-1.0, 1.0, n);
  field.y = linear(-2.0, 2.0, n);
  for (const double y : field.y) {
    for (const double x : field.x) field.values.push_back(value(x, y));
  }
  return field;
}

TEST(Contour, OfALinearFieldIsTheStraightLineItself) {
  const Segments line = contour(plane(7, [](double x, double y) { return 3.0 * x + y; }), 0.4);
  ASSERT_FALSE(line.x.empty());
  double length = 0.0;
  for (std::size_t i = 0; i < line.x.size(); i += 3) {
    for (const std::size_t end : {i, i + 1}) EXPECT_NEAR(3.0 * line.x[end] + line.y[end], 0.4, 1e-14);
    EXPECT_TRUE(std::isnan(line.x[i + 2]) && std::isnan(line.y[i + 2]));
    length += std::hypot(line.x[i + 1] - line.x[i], line.y[i + 1] - line.y[i]);
  }
  // From (0.8, -2) to (-8/15, 2): every cell on the way has its piece, none twice.
  EXPECT_NEAR(length, std::hypot(0.8 + 8.0 / 15.0, 4.0), 1e-13);
}

TEST(Contour, OfACircleClosesAndIsOffByTheSquareOfTheGrid) {
  const auto lengthAt = [](int n) {
    const Segments line = contour(plane(n, [](double x, double y) { return x * x + y * y; }), 0.64);
    double length = 0.0;
    for (std::size_t i = 0; i < line.x.size(); i += 3) {
      length += std::hypot(line.x[i + 1] - line.x[i], line.y[i + 1] - line.y[i]);
    }
    return length;
  };
  const double exact = 2.0 * M_PI * 0.8;
  // Two orders; that the grid meets the circle differently makes it less even than 4.
  const double coarse = std::abs(lengthAt(41) - exact), fine = std::abs(lengthAt(161) - exact);
  EXPECT_LT(coarse, 0.02 * exact);
  EXPECT_LT(fine, coarse / 8.0);
}

TEST(Contour, IsEmptyWhereTheLevelIsNotReached) {
  EXPECT_TRUE(contour(plane(5, [](double x, double) { return x; }), 2.0).x.empty());
}

TEST(AsPower, WritesPowersOfTenByHand) {
  EXPECT_EQ(asPower(3e-9), "3·10⁻⁹");
  EXPECT_EQ(asPower(5.2e-14), "5·10⁻¹⁴");
  EXPECT_EQ(asPower(-2e10), "-2·10¹⁰");
  EXPECT_EQ(asPower(9.7), "1·10¹");  // rounded up
  EXPECT_EQ(asPower(0.0), "0·10⁰");
  EXPECT_EQ(asPower(NAN), "nan");
}

}  // namespace
}  // namespace muelle::plots
