#include "support/allocation_count.h"
#include "test_systems.h"

#include <gtest/gtest.h>
#include <cmath>
#include <limits>

namespace muelle {
namespace {

const State threeNodesAtRest{0.0, std::vector<double>(9, 0.0), std::vector<double>(9, 0.0), {}};

/// Three nodes of 1 kg; entry `bad` of the force becomes `value` at t = 0.35 s.
FunctionSystem spoiltForce(std::size_t bad, double value) {
  return {std::vector<double>(9, 1.0), [bad, value](double t, In, In, Out f) {
            for (double& entry : f) entry = 0.0;
            if (t > 0.35 - 1e-9) f[bad] = value;
          }};
}

/// Stands still, and spoils a position, or a velocity, in the seventh step.
Step faultyStep(bool position) {
  return [position, steps = 0](const DynamicalSystem&, const State& from, double, State& to) mutable {
    to.x = from.x;
    to.v = from.v;
    if (++steps == 7) (position ? to.x : to.v)[7] = std::numeric_limits<double>::infinity();
  };
}

TEST(MarchStops, NamesTimeNodeAndAxisOfAForceThatIsNotFinite) {
  for (const double value : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    const Trajectory path = run(spoiltForce(7, value), threeNodesAtRest, {.h = 0.05, .duration = 1.0});
    EXPECT_TRUE(path.stop.stopped);
    EXPECT_NEAR(path.stop.t, 0.35, 1e-12);
    EXPECT_EQ(path.stop.unknown, 7);
    EXPECT_EQ(path.stop.message, "t = 0.35 s, node 2 (y): the force is not finite");
    ASSERT_EQ(path.t.size(), 8u);  // t = 0, 0.05 ... 0.35
    for (const double x : path.last().x) EXPECT_TRUE(std::isfinite(x));
  }
}

TEST(MarchStops, NamesTimeNodeAndAxisOfAPositionOrVelocityThatIsNotFinite) {
  const FunctionSystem system(std::vector<double>(9, 1.0), [](double, In, In, Out f) {
    for (double& entry : f) entry = 0.0;
  });
  const MarchOptions options{.h = 0.05, .duration = 1.0};
  EXPECT_EQ(march(system, threeNodesAtRest, options, faultyStep(true)).stop.message,
            "t = 0.35 s, node 2 (y): the position is not finite");
  EXPECT_EQ(march(system, threeNodesAtRest, options, faultyStep(false)).stop.message,
            "t = 0.35 s, node 2 (y): the velocity is not finite");
}

TEST(MarchStops, NamesNodesOfOtherDimensions) {
  MarchOptions options{.h = 0.05, .duration = 1.0};
  options.dimension = 1;
  EXPECT_EQ(run(spoiltForce(7, NAN), threeNodesAtRest, options).stop.message,
            "t = 0.35 s, node 7: the force is not finite");
  const FunctionSystem two({1.0, 2.0}, [](double, In, In, Out f) { f[0] = 0.0, f[1] = NAN; });
  EXPECT_EQ(run(two, {0.0, {0, 0}, {0, 0}, {}}, {}).stop.message, "t = 0 s, node 1: the force is not finite");
  options.dimension = 2;
  EXPECT_EQ(run(two, {0.0, {0, 0}, {0, 0}, {}}, options).stop.message, "t = 0 s, node 0 (y): the force is not finite");
}

TEST(MarchStops, AtTheStartWhenTheStateIsNotFinite) {
  const Trajectory path = run(oscillator(1.0), {0.0, {NAN}, {0.0}, {}}, {});
  EXPECT_TRUE(path.stop.stopped);
  EXPECT_EQ(path.stop.message, "t = 0 s, node 0: the position is not finite");
  EXPECT_EQ(path.t.size(), 1u);
}

TEST(MarchStops, RecordsTheLastGoodStateBetweenOutputs) {
  const Trajectory path = run(spoiltForce(7, NAN), threeNodesAtRest, {.h = 0.05, .duration = 1.0, .outputEvery = 5});
  ASSERT_EQ(path.t.size(), 3u);
  EXPECT_NEAR(path.t[1], 0.25, 1e-12);
  EXPECT_NEAR(path.t[2], 0.35, 1e-12);
}

// Symplectic Euler is unstable beyond h w = 2.
TEST(MarchStops, WhenTheEnergyExplodes) {
  for (const double w : {2.1, 3.0, 1e3, 1e6}) {
    const Trajectory path = run(oscillator(w), {0.0, {1e-3}, {0.0}, {}}, {.h = 1.0, .duration = 1000.0});
    EXPECT_TRUE(path.stop.stopped) << w;
    EXPECT_EQ(path.stop.unknown, 0);
    EXPECT_NE(path.stop.message.find("node 0: the energy explodes"), std::string::npos) << path.stop.message;
    EXPECT_LT(std::abs(path.last().v[0]), 1e100) << "caught only near overflow, w = " << w;
  }
}

TEST(MarchStops, WhenAForceWithTheWrongSignDrivesTheMotion) {
  const FunctionSystem wrong({1.0}, [](double, In x, In, Out f) { f[0] = 100.0 * x[0]; });
  EXPECT_TRUE(run(wrong, {0.0, {0.1}, {0.0}, {}}, {.h = 1e-3, .duration = 100.0}).stop.stopped);
}

TEST(MarchGoesOn, ThroughAFallFromRest) {
  const Trajectory path = run(projectile(1e-3, Vec3(0, 0, -9.81e-3)), {0.0, {0, 0, 0}, {0, 0, 0}, {}},
                              {.h = 1.0, .duration = 1e5, .outputEvery = 1000});
  EXPECT_FALSE(path.stop.stopped) << path.stop.message;
  // 1e5 additions, each rounded by at most eps / 2 of 1e6 m/s.
  EXPECT_NEAR(path.last().v[2], -9.81e5, 1e5 * 0.5 * std::numeric_limits<double>::epsilon() * 1e6);
}

TEST(MarchGoesOn, NearTheLimitOfStability) {
  EXPECT_FALSE(run(oscillator(1.99), {0.0, {1.0}, {0.0}, {}}, {.h = 1.0, .duration = 1e4}).stop.stopped);
}

TEST(MarchGoesOn, WhenALoadComesAfterAStartInBalance) {
  const FunctionSystem late({1.0}, [](double t, In, In, Out f) { f[0] = t > 0.5 ? 100.0 : 0.0; });
  EXPECT_FALSE(run(late, {0.0, {0.0}, {0.0}, {}}, {.h = 1e-2, .duration = 2.0}).stop.stopped);
}

TEST(MarchSteps, ShortensTheLastOne) {
  const Trajectory path = run(oscillator(1.0), {2.0, {1.0}, {0.0}, {}}, {.h = 0.3, .duration = 1.0});
  ASSERT_EQ(path.t.size(), 5u);
  EXPECT_EQ(path.t.back(), 3.0);
  const double h = 1.0 - 3 * 0.3;
  EXPECT_NEAR(path.v[4][0], path.v[3][0] - h * path.x[3][0], 1e-15);
}

TEST(MarchSteps, MakesNoStepOutOfRounding) {
  // 0.07 / 0.01 rounds to just above 7, 0.6 / 0.2 to just below 3.
  EXPECT_EQ(run(oscillator(1.0), {0.0, {1.0}, {0.0}, {}}, {.h = 0.01, .duration = 0.07}).t.size(), 8u);
  EXPECT_EQ(run(oscillator(1.0), {0.0, {1.0}, {0.0}, {}}, {.h = 0.2, .duration = 0.6}).t.size(), 4u);
}

TEST(MarchSteps, TakesOneStepWhenTheStepIsLongerThanTheRun) {
  const Trajectory path = run(oscillator(1.0), {0.0, {1.0}, {0.0}, {}}, {.h = 5.0, .duration = 0.5});
  ASSERT_EQ(path.t.size(), 2u);
  EXPECT_EQ(path.t.back(), 0.5);
  EXPECT_DOUBLE_EQ(path.v.back()[0], -0.5);
}

TEST(MarchOutput, KeepsFirstAndLastState) {
  const Trajectory path = run(oscillator(1.0), {0.0, {1.0}, {0.0}, {}}, {.h = 0.1, .duration = 1.0, .outputEvery = 4});
  ASSERT_EQ(path.t.size(), 4u);
  EXPECT_EQ(path.t[0], 0.0);
  EXPECT_DOUBLE_EQ(path.t[1], 0.4);
  EXPECT_DOUBLE_EQ(path.t[2], 0.8);
  EXPECT_EQ(path.t[3], 1.0);
}

TEST(MarchOutput, HasAValueOfEachProbeForEachState) {
  const FunctionSystem system = oscillator(1.0);
  const MarchOptions options{
      .h = 0.1,
      .duration = 1.0,
      .probes = {kineticEnergy(system), {"position", "m", [](const State& s) { return s.x[0]; }}}};
  const Trajectory path = run(system, {0.0, {1.0}, {0.5}, {}}, options);
  ASSERT_EQ(path.tracks.size(), 2u);
  EXPECT_EQ(path.track("position"), path.position(0));
  ASSERT_EQ(path.track("kinetic energy").size(), path.t.size());
  EXPECT_DOUBLE_EQ(path.track("kinetic energy")[0], 0.125);
}

TEST(MarchOutput, IsReproducible) {
  const Trajectory a = run(oscillator(1.7), {0.0, {1.0}, {0.0}, {}}, {.h = 0.01, .duration = 3.0});
  const Trajectory b = run(oscillator(1.7), {0.0, {1.0}, {0.0}, {}}, {.h = 0.01, .duration = 3.0});
  EXPECT_EQ(a.x, b.x);
  EXPECT_EQ(a.v, b.v);
}

long allocationsOfARun(double steps) {
  const FunctionSystem system = oscillator(1.0);
  const long before = allocationCount();
  run(system, {0.0, {1.0}, {0.0}, {}}, {.h = 1.0, .duration = steps, .outputEvery = 1'000'000});
  return allocationCount() - before;
}

TEST(MarchSteps, AllocateNothing) { EXPECT_EQ(allocationsOfARun(10), allocationsOfARun(10000)); }

TEST(MarchArguments, ThatMakeNoSenseAreRefused) {
  const FunctionSystem system = oscillator(1.0);
  const State start{0.0, {1.0}, {0.0}, {}};
  const auto refused = [&](const MarchOptions& options) {
    EXPECT_THROW(run(system, start, options), std::invalid_argument);
  };
  refused({.h = 0.0});
  refused({.h = -1.0});
  refused({.h = NAN});
  refused({.duration = 0.0});
  refused({.duration = HUGE_VAL});
  refused({.h = 1e-300});
  refused({.outputEvery = 0});
  refused({.probes = {{"nothing", "J", nullptr}}});
  refused({.explosion = 0.0});
  refused({.dimension = 4});
  EXPECT_THROW(run(system, {0.0, {1.0, 2.0}, {0.0, 0.0}, {}}, {}), std::invalid_argument);
  EXPECT_THROW(run(system, {0.0, {1.0}, {}, {}}, {}), std::invalid_argument);
}

TEST(MarchArguments, WhatAForceThrowsPassesThrough) {
  const FunctionSystem system({1.0}, [](double, In, In, Out) { throw std::domain_error("from the force"); });
  EXPECT_THROW(run(system, {0.0, {1.0}, {0.0}, {}}, {}), std::domain_error);
}

}  // namespace
}  // namespace muelle
