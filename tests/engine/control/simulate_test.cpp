#include "engine/control/simulate.h"

#include "support/linear_system.h"
#include "test_methods.h"
#include "test_systems.h"

#include <gtest/gtest.h>
#include <cmath>
#include <numbers>

namespace muelle::engine {
namespace {

using testing::LinearSystem;
using testing::oscillatorAt;

TEST(FixedStep, EndsExactlyAndShortensOnlyTheLastStep) {
  const LinearSystem system(1.0, 0.0);
  const auto method = testing::classicalRungeKutta();
  RunOptions options;
  options.h = 0.1;
  options.duration = 1.05;
  const RunResult run = simulate(system, *method, oscillatorAt(1.0, 0.0), options);
  ASSERT_FALSE(run.failed());
  ASSERT_EQ(run.trajectory.t.size(), 12U);
  for (int n = 0; n <= 10; ++n) EXPECT_EQ(run.trajectory.t[static_cast<std::size_t>(n)], n * 0.1);
  EXPECT_EQ(run.last.t, 1.05);
  EXPECT_EQ(run.work.steps, 11);
  EXPECT_EQ(run.work.forceEvaluations, 44);
  EXPECT_NEAR(run.last.x[0], std::cos(1.05), 1e-6);
  EXPECT_NEAR(run.smallestStep, 0.05, 1e-15);
}

TEST(FixedStep, TheRoundingOfTheGridMakesNoStepOfItsOwn) {
  const LinearSystem system(1.0, 0.0);
  const auto method = testing::classicalRungeKutta();
  RunOptions options;
  options.h = 1.0 / 60.0;
  options.duration = 100.0;
  options.outputInterval = 0.5;
  const RunResult run = simulate(system, *method, oscillatorAt(1.0, 0.0), options);
  EXPECT_EQ(run.work.steps, 6000);
  EXPECT_EQ(run.work.forceEvaluations, 24000) << "outputs at grid points need no dense output";
  EXPECT_EQ(run.trajectory.t.size(), 201U);
  EXPECT_EQ(run.smallestStep, options.h);
}

TEST(Outputs, ThatWouldTakeTooMuchMemoryAreThinnedEvenly) {
  const LinearSystem system(1.0, 0.0);
  const auto method = testing::classicalRungeKutta();
  RunOptions options;
  options.h = 0.01;
  options.duration = 50.0;
  options.mostMemory = 1.0;  // at least a thousand rows are kept
  options.probes.push_back({"position", "m", [](const State& state) { return state.x[0]; }});
  const RunResult run = simulate(system, *method, oscillatorAt(1.0, 0.0), options);
  const Trajectory& path = run.trajectory;
  ASSERT_EQ(path.t.size(), 626U);  // 5001 outputs, every eighth, and the last that is one of them
  for (std::size_t i = 0; i < path.t.size(); ++i) {
    EXPECT_NEAR(path.t[i], 0.08 * static_cast<double>(i), 1e-12);
    EXPECT_NEAR(path.x[i][0], std::cos(path.t[i]), 1e-8);
    EXPECT_EQ(path.tracks[0].values[i], path.x[i][0]);
  }
  ASSERT_EQ(run.warnings.size(), 1U);
  EXPECT_NE(run.warnings[0].find("every 8th is kept"), std::string::npos) << run.warnings[0];
}

TEST(Outputs, AtGivenTimesAreThoseOfTheMotionAndEndNoStep) {
  const LinearSystem system(1.0, 0.0);
  const auto method = testing::classicalRungeKutta();
  RunOptions options;
  options.h = 0.01;
  options.duration = 1.0;
  options.sampleTimes = {0.123, 0.5, 0.5049, 1.0};
  const RunResult run = simulate(system, *method, oscillatorAt(1.0, 0.0), options);
  ASSERT_EQ(run.trajectory.t, (std::vector<double>{0.0, 0.123, 0.5, 0.5049, 1.0}));
  EXPECT_EQ(run.work.steps, 100);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(run.trajectory.x[i][0], std::cos(run.trajectory.t[i]), 1e-9);
}

// Two runs are compared at the times of one of them, which may lie a rounding apart.
TEST(Outputs, AtTimesThatDifferByRoundingAreEachRecorded) {
  const LinearSystem system(1.0, 0.0);
  const auto method = testing::classicalRungeKutta();
  RunOptions options;
  options.h = 0.01;
  options.duration = 1.0;
  const double next = std::nextafter(0.5, 1.0);
  options.sampleTimes = {0.5, next, 0.505, std::nextafter(0.505, 1.0), std::nextafter(1.0, 0.0), 1.0};
  const RunResult run = simulate(system, *method, oscillatorAt(1.0, 0.0), options);
  EXPECT_EQ(run.trajectory.t.size(), 7U);
  for (std::size_t i = 0; i < run.trajectory.t.size(); ++i) {
    EXPECT_NEAR(run.trajectory.x[i][0], std::cos(run.trajectory.t[i]), 1e-9);
  }
}

TEST(AdaptiveStep, KeepsTheToleranceAndHitsTheOutputTimes) {
  const LinearSystem system(3.0, 0.2);
  const auto method = testing::bogackiShampine();
  RunOptions options;
  options.duration = 5.0;
  options.tolerance = {.relative = 1e-9};
  options.outputTimes = {0.7, 1.3000000000000003, 4.0};
  options.outputInterval = 100.0;
  const RunResult run = simulate(system, *method, oscillatorAt(1.0, 0.0), options);
  ASSERT_FALSE(run.failed()) << run.trajectory.stop.message;
  ASSERT_EQ(run.trajectory.t, (std::vector<double>{0.0, 0.7, 1.3000000000000003, 4.0, 5.0}));
  const double w = std::sqrt(9.0 - 0.01);
  for (std::size_t i = 0; i < run.trajectory.t.size(); ++i) {
    const double t = run.trajectory.t[i];
    const double exact = std::exp(-0.1 * t) * (std::cos(w * t) + 0.1 / w * std::sin(w * t));
    EXPECT_NEAR(run.trajectory.x[i][0], exact, 2e-7);
  }
  EXPECT_GT(run.work.steps, 100);
}

}  // namespace
}  // namespace muelle::engine
