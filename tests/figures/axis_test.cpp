#include "figures/axis.h"

#include <gtest/gtest.h>
#include <cmath>
#include <initializer_list>

namespace muelle {
namespace {

AxisRange rangeOf(std::initializer_list<double> values, double margin = 0.0, bool logarithmic = false) {
  AxisFitter fitter(logarithmic);
  for (const double value : values) fitter.include(value);
  return fitter.range(margin);
}

TEST(AxisRange, ShowsAllNumbersWithAMargin) {
  const AxisRange range = rangeOf({3.0, -1.0, 2.0}, 0.1);
  EXPECT_DOUBLE_EQ(range.low, -1.4);
  EXPECT_DOUBLE_EQ(range.high, 3.4);
}

TEST(AxisRange, PassesOverWhatCannotBeDrawn) {
  const AxisRange range = rangeOf({0.0, NAN, HUGE_VAL, -HUGE_VAL, 1e101, -1e200, 1.0});
  EXPECT_EQ(range.low, 0.0);
  EXPECT_EQ(range.high, 1.0);
}

TEST(AxisRange, IsNeverEmpty) {
  for (const double value : {0.0, 1.0, -5.0, 1e-300, 1e99, -1e-5}) {
    const AxisRange range = rangeOf({value, value});
    EXPECT_LT(range.low, value);
    EXPECT_GT(range.high, value);
  }
  EXPECT_LT(rangeOf({}).low, rangeOf({}).high);
  EXPECT_LT(rangeOf({}, 0.0, true).low, rangeOf({}, 0.0, true).high);
}

TEST(AxisRange, DoesNotBlowUpRoundOff) {
  EXPECT_GT(rangeOf({5.0, 5.0 + 1e-13}).span(), 0.5);
  EXPECT_GT(rangeOf({1e-17, -1e-17}).span(), 1.0);
  EXPECT_NEAR(rangeOf({5.0, 5.0 + 1e-6}).span(), 1e-6, 1e-12);  // a small change is no round-off
}

TEST(AxisRange, EndsAtPowersOfTenWhenLogarithmic) {
  const AxisRange range = rangeOf({0.02, 300.0, 0.0, -1.0}, 0.0, true);
  EXPECT_DOUBLE_EQ(range.low, 0.01);
  EXPECT_DOUBLE_EQ(range.high, 1000.0);
  EXPECT_DOUBLE_EQ(rangeOf({1.0}, 0.0, true).high, 10.0);
}

}  // namespace
}  // namespace muelle
