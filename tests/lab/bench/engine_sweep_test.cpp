/// \file
/// Errors known in closed form, and a sweep with contestants whose errors and times are made up.

#include "base/file.h"
#include "engine/integrators/catalogue.h"
#include "lab/bench/engine_contestant.h"
#include "lab/bench/sweep.h"

#include <gtest/gtest.h>
#include <cmath>

namespace muelle::bench {
namespace {

struct Oscillator {
  BenchScene scene = makeScene("oscillator");
  TemporaryFolder folder{std::filesystem::path(::testing::TempDir()) / "muelle_bench"};
  std::unique_ptr<engine::ModelSystem> system;
  std::unique_ptr<Reference> reference;

  explicit Oscillator(double duration = 2.0) {
    scene.duration = duration;
    scene.samples = 40;
    system = engine::build(scene.model);
    reference = std::make_unique<Reference>(scene, *system, folder.path() / "reference", "test");
  }
  double motion() const { return reference->motion().position; }
};

/// x = 1 + 0.2 cos 10 t: the exact motion, and at t shifted by `late` [s].
PathPoint exactly(double t, double late = 0.0) {
  return {t, {0.0, 1.0 + 0.2 * std::cos(10.0 * (t - late))}, {0.0, -2.0 * std::sin(10.0 * (t - late))}};
}

TEST(Reference, AgreesWithTheClosedFormAtAndBetweenItsTimes) {
  const Oscillator oscillator;
  Path path(2.0, 40);
  for (int i = 1; i <= 77; ++i) {
    const double t = 2.0 * i / 77.0;  // but for the last no sample of 40
    if (path.wants(t)) path.see(exactly(t));
  }
  // 1e-13 a step, some 30 steps, and rounding of positions near 1 in parts of a motion of 0.4 m: 6e-16 a step.
  EXPECT_LT(oscillator.reference->errorOf(path).position, 1e-11);
  EXPECT_LT(oscillator.reference->errorOf(path).velocity, 1e-11);
}

TEST(Reference, TellsAKnownErrorOfPhase) {
  const Oscillator oscillator;
  constexpr double late = 1e-6;
  Path path(2.0, 400);
  for (int i = 1; i <= 400; ++i) path.see(exactly(2.0 * i / 400.0, late));
  // |x(t - late) - x(t)| is at most 2 m/s * late; the motion y goes from 0 to 0.4 m. At 400 times over three periods a
  // sine's maximum is missed by a phase of at most 0.025: 3e-4.
  EXPECT_NEAR(oscillator.reference->errorOf(path).position, 2.0 * late / 0.4, 4e-4 * 5e-6);
  // Accelerations reach 20 m/s^2, speeds 2 m/s.
  EXPECT_NEAR(oscillator.reference->errorOf(path).velocity, 20.0 * late / 2.0, 4e-4 * 1e-5);
}

TEST(Reference, OfAnOscillatorLetsSmallErrorsGrowByNothing) {
  // A disturbed position swings with its own amplitude: never larger than it was.
  EXPECT_NEAR(Oscillator().reference->amplification(), 1.0, 1e-3);
}

TEST(Reference, IsReadAgainByTheSameProgramOnly) {
  const Oscillator oscillator;
  const auto file = oscillator.folder.path() / "reference";
  std::string content = readFile(file);
  content.back() = static_cast<char>(content.back() ^ 0x40);  // in the last state's z or v: it is seen to be read
  writeFile(file, content);
  const std::string before = readFile(file);
  const Reference same(oscillator.scene, *oscillator.system, file, "test");
  EXPECT_EQ(readFile(file), before);
  const Reference other(oscillator.scene, *oscillator.system, file, "another");
  EXPECT_NE(readFile(file), before);
}

TEST(EngineContestant, HasTheErrorThatItsRecurrencePredicts) {
  // Velocity Verlet turns by asin(w h / 2) * 2 a step instead of w h: cos(n theta) at step n, for a start at rest.
  Oscillator oscillator;
  std::vector<std::string> left;
  for (const auto& contestant : engineContestants(oscillator.scene, *oscillator.system, left)) {
    if (contestant->method() != "velocity_verlet") continue;
    constexpr int steps = 400;
    const double h = 2.0 / steps, theta = 2.0 * std::asin(0.5 * 10.0 * h);
    Path path(2.0, 40);
    const RunCost cost = contestant->run(h, &path);
    double worst = 0.0;
    for (int n = 10; n <= steps; n += 10) {
      worst = std::max(worst, std::abs(0.2 * std::cos(n * theta) - 0.2 * std::cos(10.0 * n * h)));
    }
    EXPECT_TRUE(cost.failure.empty());
    EXPECT_NEAR(oscillator.reference->errorOf(path).position, worst / oscillator.motion(), 1e-11);
    EXPECT_GE(cost.evaluations, steps);
    return;
  }
  FAIL() << "velocity_verlet does not run an oscillator";
}

TEST(EngineContestants, AreAllMethodsOfTheCatalogueOrSayWhyNot) {
  Oscillator oscillator;
  std::vector<std::string> left;
  const Contestants all = engineContestants(oscillator.scene, *oscillator.system, left);
  std::size_t fixed = 0;
  for (const auto& contestant : all) fixed += contestant->method().ends_with("_fixed") ? 1 : 0;
  EXPECT_EQ(all.size() - fixed + left.size(), engine::methodIds().size());
  EXPECT_EQ(fixed, 2u);  // nystrom8, nystrom12
}

/// Off by h^2 in phase, at a price of `perStep` seconds of a made-up clock a step; beyond h = `limit` it fails.
class MadeUp : public Contestant {
 public:
  MadeUp(Row row, std::string library, const BenchScene& scene, double& clock, double perStep, double limit)
      : row_(row), library_(std::move(library)), scene_(scene), clock_(clock), perStep_(perStep), limit_(limit) {}
  Row row() const override { return row_; }
  std::string library() const override { return library_; }
  std::string method() const override { return "made_up"; }
  bool takesTolerance() const override { return false; }
  RunCost run(double setting, Path* path) override {
    ++runs;
    const long long steps = scene_.stepsOf(setting);
    const double h = scene_.duration / static_cast<double>(steps);
    clock_ += perStep_ * static_cast<double>(steps);
    if (h > limit_) return {steps, 0, 0, "not finite"};
    for (long long i = 1; path != nullptr && i <= steps; ++i) {
      const double t = h * static_cast<double>(i);
      if (path->wants(t)) path->see(exactly(t, h * h));
    }
    return {steps, 0, 0, {}};
  }
  int runs = 0;

 private:
  Row row_;
  std::string library_;
  const BenchScene& scene_;
  double& clock_;
  double perStep_, limit_;
};

struct MadeUpSweep : Oscillator {
  double clock = 0.0;
  Contestants contestants;
  SweepOptions options;

  MadeUpSweep() {
    for (const auto& [row, price] :
         {std::pair(Row::Ours, 1e-3), std::pair(Row::Plain, 2e-3), std::pair(Row::Kernel, 3e-3)}) {
      contestants.push_back(std::make_unique<MadeUp>(row, "made", scene, clock, price, 0.03));
    }
    options.now = [this] { return clock; };
    options.longestRun = 4.0;
    reference->judgeBy("nobody", {1e-12, 1e-12});
  }
  SceneResult run() {
    Record record(folder.path() / "runs.tsv", "test");
    return sweep(scene, contestants, *reference, record, options);
  }
  int runs() const {
    int sum = 0;
    for (const auto& contestant : contestants) sum += static_cast<MadeUp&>(*contestant).runs;
    return sum;
  }
};

TEST(Sweep, FindsTheRatioAndTheTimeAtAKnownError) {
  MadeUpSweep made;
  const SceneResult result = made.run();
  EXPECT_EQ(result.curves[0].points.front().cost.failure, "not finite");  // 10 steps of 0.2 s
  const auto crossing = crossingAt(result.curves[0], 1e-4);
  ASSERT_TRUE(crossing);
  // The error is 2 m/s h^2 / 0.4 m = 5 h^2 (seen to 1e-3 at 40 times): 1e-4 at h = sqrt(2e-5), 447 steps of 1 ms.
  EXPECT_NEAR(secondsAt(result.curves[0], *crossing, 0), 0.4472, 0.02 * 0.4472);
  EXPECT_NEAR(evaluationsAt(result.curves[0], *crossing), 447.2, 0.02 * 447.2);
  EXPECT_NEAR(secondsAt(result.curves[1], *crossing, 0) / secondsAt(result.curves[0], *crossing, 0), 2.0, 1e-9);
  EXPECT_EQ(result.rounds, 15);
  EXPECT_EQ(roundsAt(result.curves[0], *crossing), 15u);
}

TEST(Sweep, EndsACurveBeforeARunThatWouldTakeTooLong) {
  MadeUpSweep made;
  const SceneResult result = made.run();
  EXPECT_LE(result.curves[0].points.back().seconds.front(), 4.0);
  EXPECT_EQ(result.curves[0].ended.substr(0, 13), "the next run ");
}

TEST(Sweep, FindsTheLargestStepThatStands) {
  MadeUpSweep made;
  const SceneResult result = made.run();
  double largest = 0.0;
  for (const CurvePoint& point : result.curves[0].points) {
    if (!point.failed()) largest = std::max(largest, point.setting);
  }
  // Steps fall on the 40 samples: 2/80 s is the largest of these below 0.03 s.
  EXPECT_DOUBLE_EQ(largest, 2.0 / 80.0);
}

TEST(Sweep, RunsNothingAgainThatTheRecordHas) {
  MadeUpSweep made;
  const SceneResult first = made.run();
  const int runs = made.runs();
  const SceneResult second = made.run();
  EXPECT_EQ(made.runs(), runs);
  ASSERT_EQ(second.curves[2].points.size(), first.curves[2].points.size());
  for (std::size_t i = 0; i < first.curves[2].points.size(); ++i) {
    EXPECT_EQ(second.curves[2].points[i].seconds, first.curves[2].points[i].seconds);
    EXPECT_EQ(second.curves[2].points[i].error.position, first.curves[2].points[i].error.position);
  }
}

}  // namespace
}  // namespace muelle::bench
