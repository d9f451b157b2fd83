#include "sample_models.h"

#include <gtest/gtest.h>
#include <cmath>
#include <Eigen/Geometry>
#include <functional>
#include <numbers>

namespace muelle::engine::testing {
namespace {

constexpr double g = 9.81;

/// Velocity Verlet with a commit after each step, modes live: the plainest way to run a scene.
void run(const DynamicalSystem& system, State& s, double h, int steps, const std::function<void()>& after = {}) {
  std::vector<double> f = forceOf(system, s);
  for (int n = 0; n < steps; ++n) {
    for (std::size_t i = 0; i < s.x.size(); ++i) {
      s.v[i] += 0.5 * h * f[i] * system.inverseMass()[i];
      s.x[i] += h * s.v[i];
    }
    s.t += h;
    f = forceOf(system, s);
    for (std::size_t i = 0; i < s.x.size(); ++i) s.v[i] += 0.5 * h * f[i] * system.inverseMass()[i];
    if (system.switching()->commit(s, false)) f = forceOf(system, s);
    f = forceOf(system, s);
    if (after) after();
  }
}

Model fallingOn(Obstacle obstacle, double x, double v) {
  Model model;
  model.dimension = 1;
  model.nodes = {{.x = {x, 0, 0}, .v = {v, 0, 0}}};
  obstacle.normal = Vec3::UnitX();
  model.obstacles = {std::move(obstacle)};
  return model;
}

Obstacle slab(double k) {
  Obstacle box;
  box.kind = Obstacle::Kind::Box;
  box.name = "slab";
  box.centre = {0.005, 0, 0};
  box.halfSize = Vec3(0.005, INFINITY, INFINITY);
  box.material.k = k;
  return box;
}

double guardOf(const DynamicalSystem& system, const State& s) {
  std::vector<double> guards(static_cast<std::size_t>(system.switching()->guardCount()));
  system.switching()->guards(s.t, s.x, s.v, s.z, guards);
  return guards[0];
}

TEST(Penalty, CarriesTheWeightAtDepthMgOverK) {
  Model model = fallingOn({}, -g / 1e4, 0.0);
  model.gravity = {-g, 0, 0};
  const auto system = build(model);
  EXPECT_NEAR(forceOf(*system, system->initialState())[0], 0.0, 1e-12);
}

TEST(Penalty, FrozenModesAreSmoothAcrossTheSurface) {
  const auto system = build(fallingOn({}, 0.1, -1.0));
  const Switching& switching = *system->switching();
  State s = system->initialState();
  switching.commit(s, true);
  s.x[0] = -1e-3;
  EXPECT_EQ(forceOf(*system, s)[0], 0.0) << "open: nothing a little inside";
  EXPECT_LT(guardOf(*system, s), 0.0);
  switching.cross(0, s);
  EXPECT_NEAR(forceOf(*system, s)[0], 10.0, 1e-12);
  s.x[0] = 1e-3, s.v[0] = 1.0;
  EXPECT_NEAR(forceOf(*system, s)[0], -10.0, 1e-12) << "closed: goes on pulling a little beyond";
  switching.cross(0, s);
  EXPECT_EQ(forceOf(*system, s)[0], 0.0);
  s.x[0] = -1e-18;
  EXPECT_FALSE(switching.commit(s, true)) << "rounding after an event changes no mode";
}

TEST(Penalty, ANodeThatTouchesAtRestIsClosed) {
  Model model = fallingOn({}, 0.0, 0.0);
  model.gravity = {-g, 0, 0};
  const auto system = build(model);
  State s = system->initialState();
  system->switching()->commit(s, true);
  s.x[0] = -1e-3;
  EXPECT_NEAR(forceOf(*system, s)[0], 10.0 - g, 1e-12);
}

TEST(DampedContact, NeverPullsAndLetsGoWhereItsForceIsZero) {
  Obstacle ground;
  ground.material.d = 100.0;
  const auto system = build(fallingOn(ground, -1e-3, 0.05));
  State s = system->initialState();
  EXPECT_NEAR(forceOf(*system, s)[0], 10.0 - 5.0, 1e-12);
  system->switching()->commit(s, true);
  EXPECT_FALSE(system->switching()->commit(s, true)) << "stays closed while it pushes";
  s.v[0] = 0.2;  // k depth - d v = 10 - 20
  EXPECT_GT(guardOf(*system, s), 0.0) << "released while still inside";
  system->switching()->cross(0, s);
  EXPECT_EQ(forceOf(*system, s)[0], 0.0);
  system->switching()->commit(s, false);
  EXPECT_EQ(forceOf(*system, s)[0], 0.0);
  s.v[0] = -0.2;
  EXPECT_NEAR(forceOf(*system, s)[0], 30.0, 1e-12);
}

TEST(Box, PushesBackThroughTheFaceOfEntryBeyondItsMiddle) {
  const auto system = build(fallingOn(slab(4e8), -1.0, 100.0));
  State s = system->initialState();
  s.x[0] = 0.007;
  EXPECT_NEAR(forceOf(*system, s)[0], -4e8 * 0.007, 1e-3);
  s.x[0] = 0.02;
  EXPECT_EQ(forceOf(*system, s)[0], 0.0) << "outside on the other side";
}

TEST(Obstacle, MovesUntilItsStopTime) {
  Obstacle wall;
  wall.velocity = {0.5, 0, 0};
  wall.stopTime = 2.0;
  const auto system = build(fallingOn(wall, 0.9, 0.0));
  State s = system->initialState();
  s.t = 1.0;
  EXPECT_EQ(forceOf(*system, s)[0], 0.0);
  s.t = 3.0;
  EXPECT_NEAR(forceOf(*system, s)[0], 1e4 * 0.1, 1e-9);
  std::vector<double> times;
  system->switching()->declaredTimes(0.0, 10.0, times);
  EXPECT_EQ(times, std::vector{2.0});
}

TEST(SweptBound, StopsJustShortOfAThinSlabAtAnySpeed) {
  for (const double speed : {1.0, 100.0, 1e4}) {
    const auto system = build(fallingOn(slab(4e8), -1.0, speed));
    const State s = system->initialState();
    const double bound = system->switching()->sweptBound(0.0, s.x, s.v, s.z, 10.0);
    EXPECT_LT(-1.0 + speed * bound, 0.0);
    EXPECT_GE(-1.0 + speed * bound, -0.1 * 0.01);
  }
}

TEST(SweptBound, LeavesAlone) {
  const auto bound = [](const Model& model) {
    const auto system = build(model);
    const State s = system->initialState();
    return system->switching()->sweptBound(0.0, s.x, s.v, s.z, 10.0);
  };
  EXPECT_EQ(bound(fallingOn({}, 0.1, -1e3)), 10.0) << "a half space, which nothing passes";
  EXPECT_EQ(bound(fallingOn(slab(4e8), -1.0, -100.0)), 10.0) << "a node that flies away";
  Model resting = fallingOn(slab(981.0), 0.01 - 1e-2 * 0.1, 0.0);
  resting.gravity = {-981.0 * 1e-3, 0, 0};
  EXPECT_GT(bound(resting), 1.0) << "a node that rests";
}

TEST(SweptBound, NoStepCarriesANodeThroughASlab) {
  const auto system = build(fallingOn(slab(4e8), -1.0, 100.0));
  State s = system->initialState();
  while (s.t < 0.1) {
    double h = std::min(1.0 / 60.0, 0.1 - s.t + 1e-12);
    h = system->switching()->sweptBound(s.t, s.x, s.v, s.z, h);
    run(*system, s, h, 1);
  }
  EXPECT_NEAR(s.v[0], -100.0, 1.0);
  EXPECT_NEAR(s.x[0], -8.984292, 0.1) << "rebounds";
}

/// A node on an incline, at rest at the depth at which the plane carries it.
Model onIncline(double degrees, double mu, double speed = 0.0, double damping = 0.0) {
  const double angle = degrees * std::numbers::pi / 180.0, k = 1e6;
  Model model;
  model.dimension = 2;
  model.gravity = {0, 0, -g};
  Obstacle plane;
  plane.normal = {std::sin(angle), 0, std::cos(angle)};
  plane.material = {k, 0.0, mu, 0.0, damping};
  const Vec3 along(std::cos(angle), 0, -std::sin(angle));
  model.nodes = {{.x = -g * std::cos(angle) / k * plane.normal, .v = speed * along}};
  model.obstacles = {plane};
  return model;
}

double slid(const ModelSystem& system, const State& from, const State& to) {
  return (system.position(to, 0) - system.position(from, 0)).norm();
}

TEST(Friction, SticksBelowItsAngleWithoutCreep) {
  const auto system = build(onIncline(26.5, 0.5));
  State s = system->initialState();
  const State start = s;
  run(*system, s, 2e-4, 50'000);
  EXPECT_LE(slid(*system, start, s), 1e-6) << "10 s at tan(26.5 degrees) = 0.4986 < 0.5";
}

TEST(Friction, SlidesAboveItsAngleAsCoulombSays) {
  const auto system = build(onIncline(26.6, 0.5));
  State s = system->initialState();
  const State start = s;
  run(*system, s, 2e-4, 50'000);
  const double angle = 26.6 * std::numbers::pi / 180.0;
  const double expected = 0.5 * g * (std::sin(angle) - 0.5 * std::cos(angle)) * 100.0;  // 0.334506 m
  EXPECT_NEAR(slid(*system, start, s), expected, 1e-3 * expected);
}

TEST(Friction, StopsASlidingNodeWithoutReversal) {
  const auto system = build(onIncline(0.0, 0.5, 3.0, 1e3));  // damped while it sticks
  State s = system->initialState();
  double farthest = 0.0, backwards = 0.0;
  run(*system, s, 1e-4, 20'000, [&] {
    farthest = std::max(farthest, s.x[0]);
    backwards = std::max(backwards, farthest - s.x[0]);
  });
  EXPECT_NEAR(s.x[0], 9.0 / (2.0 * 0.5 * g), 1e-4 * 0.917);  // v^2 / (2 mu g) = 0.9174312 m
  EXPECT_LE(backwards, 1e-6);
  EXPECT_LE(std::abs(s.v[0]), 1e-9);
}

TEST(Friction, TheStopIsAnEvent) {
  const auto system = build(onIncline(0.0, 0.5, 3.0));
  const Switching& switching = *system->switching();
  State s = system->initialState();
  switching.commit(s, true);
  s.x[0] += 1e-3;
  switching.commit(s, true);  // slips
  std::vector<double> guards(2);
  switching.guards(s.t, s.x, s.v, s.z, guards);
  EXPECT_NEAR(guards[1], 3.0, 1e-12) << "the speed of the slip";
  EXPECT_NEAR(forceOf(*system, s)[0], -0.5 * g, 1e-9);
  s.v[0] = 0.0;
  switching.cross(1, s);
  EXPECT_NEAR(forceOf(*system, s)[0], 0.0, 1e-12) << "at rest nothing is asked of friction";
}

}  // namespace
}  // namespace muelle::engine::testing
