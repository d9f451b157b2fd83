#include "lab/bench/plane.h"

#include "lab/bench/bars.h"

#include <gtest/gtest.h>
#include <cmath>

namespace muelle::bench {
namespace {

/// Points at errors 1e-1 and 1e-9 whose times follow seconds * error^(-1/4) in each of `rounds` rounds, each round
/// slower than the one before: a machine that is getting busy.
Curve powerLaw(Row row, const std::string& library, double seconds, double evaluations, int rounds = 15) {
  Curve curve;
  curve.row = row;
  curve.library = library;
  curve.method = "method";
  for (const double error : {1e-1, 1e-9}) {
    CurvePoint point;
    point.error.position = error;
    point.cost.evaluations = std::llround(evaluations * std::pow(error, -0.25));
    for (int round = 0; round < rounds; ++round) {
      point.seconds.push_back(seconds * std::pow(error, -0.25) * (1.0 + round));
    }
    curve.points.push_back(point);
  }
  return curve;
}

SceneResult pendulumWith(double peerSeconds) {
  SceneResult scene{.name = "pendulum", .title = "Pendulum"};
  scene.doubt.position = 1e-9;
  scene.curves = {powerLaw(Row::Ours, "muelle", 1.0, 1e6), powerLaw(Row::Ours, "muelle", 7.0, 1e5),
                  powerLaw(Row::Plain, "peer", peerSeconds, 3e5), powerLaw(Row::Kernel, "peer", 0.9, 3e5)};
  return scene;
}

TEST(Plane, RatiosAreTakenRoundByRoundSoThatABusyMachineCancels) {
  const Entry entry = entriesOf(pendulumWith(1.7))[0];
  ASSERT_TRUE(entry.toPlain);
  // Every round is slower than the last for both; the ratio is 1.7 in each, but for rounding.
  EXPECT_NEAR(entry.toPlain->least, 1.7, 1e-12);
  EXPECT_NEAR(entry.toPlain->high, 1.7, 1e-12);
  EXPECT_NEAR(entry.toKernel->median, 0.9, 1e-12);
  EXPECT_NEAR(entry.ours->seconds.median, 8.0 * std::sqrt(10.0), 1e-10);  // (1e-2)^(-1/4) in the 8th round of 15
}

TEST(Plane, FewestEvaluationsMayBeAnotherMethodsThanTheFastest) {
  const Entry entry = entriesOf(pendulumWith(1.7))[0];
  EXPECT_NEAR(entry.fewestOurs, 1e5 * std::sqrt(10.0), 1.0);
  EXPECT_NEAR(entry.fewestPlain, 3e5 * std::sqrt(10.0), 1.0);
}

TEST(Plane, ThereIsNoEntryWhereTheReferenceIsNotAHundredTimesBetter) {
  const std::vector<Entry> entries = entriesOf(pendulumWith(1.7));  // good to 1e-9
  EXPECT_TRUE(entries[2].allowed);                                  // 1e-6
  EXPECT_FALSE(entries[3].allowed);                                 // 1e-8 would need 1e-10
  EXPECT_FALSE(entries[3].ours);
}

TEST(Plane, AMissingOrCrashedCurveIsNamed) {
  SceneResult scene = pendulumWith(1.7);
  EXPECT_TRUE(missingCurves(scene).empty());
  scene.curves[1].crash = "bad luck";
  scene.curves[3].points.clear();
  const std::vector<std::string> lines = missingCurves(scene);
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0], "pendulum: ours:muelle:method crashed: bad luck");
  EXPECT_EQ(lines[1], "pendulum: B:peer:method has no curve");
  EXPECT_EQ(lines[2], "pendulum: no run of row B has reached the end");
}

TEST(Bars, TellMetFromMissedAtTheRatioThatIsPromised) {
  // A small scene promises 1 at 1e-2, 1.5 at 1e-4, 2.5 at 1e-6.
  const auto verdict = [](double ratio, const std::string& where) {
    for (const Bar& bar : barsOf(pendulumWith(ratio))) {
      const bool toPlain = bar.promise.ends_with("behind A") || bar.promise.ends_with("as fast as A");
      if (bar.where == where && (toPlain || bar.promise.starts_with("an entry"))) {
        return bar.verdict;
      }
    }
    return Bar::Verdict::NotMeasured;
  };
  EXPECT_EQ(verdict(1.7, "pendulum, 1e-02"), Bar::Verdict::Met);
  EXPECT_EQ(verdict(1.7, "pendulum, 1e-04"), Bar::Verdict::Met);
  EXPECT_EQ(verdict(1.7, "pendulum, 1e-06"), Bar::Verdict::Missed);
  EXPECT_EQ(verdict(1.4, "pendulum, 1e-04"), Bar::Verdict::Missed);
  EXPECT_EQ(verdict(0.9, "pendulum, 1e-02"), Bar::Verdict::Missed);
  EXPECT_EQ(verdict(1.7, "pendulum, 1e-08"), Bar::Verdict::NotMeasured);
}

TEST(Bars, ANaiveLoopIsTakenAtItsLargestStepThatStands) {
  SceneResult scene = pendulumWith(1.7);
  scene.name = "cloth_32";
  Curve naive = powerLaw(Row::Plain, "plain", 100.0, 1e6);
  naive.method = "symplectic_euler";
  ASSERT_EQ(naive.key(), naiveEulerKey);
  naive.points.insert(naive.points.begin(), naive.points.front());
  naive.points[0].cost.failure = "not finite";
  scene.curves.push_back(naive);
  const std::optional<AgainstNaive> against = againstNaive(scene, 1e-2);
  ASSERT_TRUE(against);
  EXPECT_EQ(against->error, 1e-1);
  // Ours at 1e-2 takes (1e-2)^(-1/4), the loop at 1e-1 a hundred times (1e-1)^(-1/4).
  EXPECT_NEAR(against->ratio.median, std::pow(10.0, 0.25) / 100.0, 1e-12);
}

}  // namespace
}  // namespace muelle::bench
