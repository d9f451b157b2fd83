#include "lab/bench/curve.h"

#include <gtest/gtest.h>
#include <cmath>

namespace muelle::bench {
namespace {

CurvePoint point(double error, double seconds, long long evaluations = 10) {
  CurvePoint p;
  p.cost.evaluations = evaluations;
  p.error.position = error;
  p.seconds = {seconds};
  return p;
}

CurvePoint failedPoint() {
  CurvePoint p = point(0.0, 1e-3);
  p.cost.failure = "not finite at 0.1 s";
  return p;
}

Curve curveWith(std::vector<CurvePoint> points) {
  Curve curve;
  curve.points = std::move(points);
  return curve;
}

TEST(Crossing, OfAPowerLawIsExact) {
  // A method of order 4: time = error^(-1/4), a straight line in logarithms, so that interpolation is exact but for
  // rounding.
  std::vector<CurvePoint> points;
  for (const double error : {1e-1, 1e-3, 1e-5, 1e-9}) {
    points.push_back(point(error, std::pow(error, -0.25), std::llround(1e6 * std::pow(error, -0.25))));
  }
  const Curve curve = curveWith(points);
  for (const double target : {1e-2, 1e-4, 1e-6, 1e-8}) {
    const std::optional<Crossing> crossing = crossingAt(curve, target);
    ASSERT_TRUE(crossing);
    EXPECT_NEAR(secondsAt(curve, *crossing, 0) / std::pow(target, -0.25), 1.0, 1e-13);
    // Counts are whole numbers of 1.8e6 and more: rounding them is below 3e-7.
    EXPECT_NEAR(evaluationsAt(curve, *crossing) / (1e6 * std::pow(target, -0.25)), 1.0, 3e-7);
  }
}

TEST(Crossing, AnErrorThatIsSmallByLuckEarnsNothing) {
  const Curve curve = curveWith({point(1e-1, 1.0), point(1e-7, 2.0), point(1e-2, 4.0), point(1e-4, 8.0)});
  const std::optional<Crossing> crossing = crossingAt(curve, 1e-3);
  ASSERT_TRUE(crossing);
  EXPECT_EQ(crossing->coarse, 2u);
  EXPECT_EQ(crossing->fine, 3u);
  EXPECT_NEAR(secondsAt(curve, *crossing, 0), std::sqrt(32.0), 1e-12);  // half way from 4 to 8 in logarithms
}

TEST(Crossing, BehindAFailedRunTheCoarsestThatStandsCounts) {
  const Curve curve = curveWith({failedPoint(), point(1e-5, 3.0), point(1e-6, 4.0)});
  const std::optional<Crossing> crossing = crossingAt(curve, 1e-2);
  ASSERT_TRUE(crossing);
  EXPECT_EQ(crossing->coarse, 1u);
  EXPECT_EQ(crossing->fine, 1u);
  EXPECT_EQ(secondsAt(curve, *crossing, 0), 3.0);
}

TEST(Crossing, ThereIsNoneWhereTheFinestRunIsTooCoarseOrFails) {
  EXPECT_FALSE(crossingAt(curveWith({point(1e-1, 1.0), point(1e-2, 2.0)}), 1e-3));
  EXPECT_FALSE(crossingAt(curveWith({point(1e-5, 1.0), failedPoint()}), 1e-3));
  EXPECT_FALSE(crossingAt(curveWith({}), 1e-3));
}

TEST(Crossing, TimesAreTakenRoundByRound) {
  Curve curve = curveWith({point(1e-2, 0.0), point(1e-4, 0.0)});
  curve.points[0].seconds = {1.0, 4.0, 2.0};
  curve.points[1].seconds = {4.0, 9.0};  // one round less: its median 6.5 stands in
  const std::optional<Crossing> crossing = crossingAt(curve, 1e-3);
  ASSERT_TRUE(crossing);
  EXPECT_EQ(roundsAt(curve, *crossing), 2u);
  EXPECT_NEAR(secondsAt(curve, *crossing, 0), 2.0, 1e-12);
  EXPECT_NEAR(secondsAt(curve, *crossing, 1), 6.0, 1e-12);
  EXPECT_NEAR(secondsAt(curve, *crossing, 2), std::sqrt(13.0), 1e-12);
}

}  // namespace
}  // namespace muelle::bench
