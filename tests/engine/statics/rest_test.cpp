#include "engine/statics/rest.h"

#include <gtest/gtest.h>
#include <cmath>
#include <numbers>

namespace muelle::engine {
namespace {

ModelNode free(const Vec3& x, double m = 1.0) {
  ModelNode node;
  node.x = x;
  node.m = m;
  return node;
}

ModelNode fixed(const Vec3& x) {
  ModelNode node;
  node.x = x;
  node.pinned = true;
  return node;
}

ModelSpring joined(int a, int b, double k, double L0) {
  ModelSpring spring;
  spring.a = a;
  spring.b = b;
  spring.k = k;
  spring.L0 = L0;
  return spring;
}

Model pendulum(double k, const Vec3& bob) {
  Model model;
  model.gravity = {0.0, 0.0, -9.81};
  model.nodes = {fixed(Vec3::Zero()), free(bob)};
  model.springs = {joined(0, 1, k, 1.0)};
  return model;
}

RestResult restOf(const Model& model, const RestOptions& options = {}) { return rest(*build(model), options); }

TEST(Rest, RefusesSpringsWhoseTensionIsNotThatOfALength) {
  Model rod = pendulum(0.0, Vec3(0.0, 0.0, -1.0));
  rod.springs[0].rod = true;
  EXPECT_THROW(rest(*build(rod)), std::invalid_argument);
  Model line;
  line.dimension = 1;
  line.nodes = {fixed(Vec3::Zero()), free(Vec3(1.0, 0.0, 0.0))};
  line.springs = {joined(0, 1, 10.0, 1.0)};
  line.springs[0].isSigned = true;
  EXPECT_THROW(rest(*build(line)), std::invalid_argument);
}

/// Standing, the spring is shortened by mg/k and pushes with mg; sideways the bob gains energy at mg / (L0 - mg/k).
TEST(Rest, ThePendulumStandsOnASaddleUpsideDown) {
  for (const double k : {100.0, 1e6, 1e12}) {
    for (const double aside : {0.0, 1e-9}) {
      const Model model = pendulum(k, {aside, 0.0, 1.0});
      const auto system = build(model);
      const RestResult result = rest(*system);
      ASSERT_EQ(result.verdict, Verdict::Saddle) << k;
      EXPECT_TRUE(result.isFound());
      EXPECT_EQ(result.negativeEigenvalues, 2) << k;
      EXPECT_NEAR(result.tensions[0], -9.81, 1e-12) << k;
      EXPECT_NEAR(system->position(result.state, 1)[2], 1.0 - 9.81 / k, 1e-15) << k;
      EXPECT_NEAR(result.smallestEigenvalue, -9.81 / (1.0 - 9.81 / k), 1e-7) << k;
    }
  }
}

TEST(Rest, ThePendulumGoesDownFromASaddleWhenAskedTo) {
  for (const double k : {100.0, 1e12}) {
    const Model model = pendulum(k, {0.0, 0.0, 1.0});
    const auto system = build(model);
    const RestResult result = rest(*system, {.leaveSaddles = true});
    ASSERT_EQ(result.verdict, Verdict::Stable) << k;
    EXPECT_EQ(result.saddlesLeft, 1);
    EXPECT_NEAR(system->position(result.state, 1)[2], -1.0 - 9.81 / k, 1e-12) << k;
    EXPECT_NEAR(result.smallestEigenvalue, 9.81 / (1.0 + 9.81 / k), 1e-7) << k;
  }
}

/// Beside the saddle it falls: only what stands there is said to.
TEST(Rest, ALeaningPendulumHangs) {
  for (const double k : {100.0, 1e12}) {
    for (const double aside : {0.02, 0.1}) {
      const RestResult result = restOf(pendulum(k, {aside, 0.0, 1.0}));
      EXPECT_EQ(result.verdict, Verdict::Stable) << k;
      EXPECT_NEAR(result.tensions[0], 9.81, 1e-12) << k;
      EXPECT_TRUE(result.isLowest);
    }
  }
}

TEST(Rest, CoincidentNodesAreACuspWhateverPullsOnThem) {
  Model model = pendulum(100.0, Vec3::Zero());
  EXPECT_EQ(restOf(model).verdict, Verdict::Cusp);
  EXPECT_EQ(restOf(model).nodes, std::vector<int>{1});
  model.gravity.setZero();
  EXPECT_EQ(restOf(model).verdict, Verdict::Cusp);
  model.nodes[1].x[1] = 1e-15;  // where the direction is round-off
  EXPECT_EQ(restOf(model).verdict, Verdict::Cusp);
  model.nodes[1].x[1] = 1e-5;
  EXPECT_NE(restOf(model).verdict, Verdict::Cusp);
  // Two free ones beside a chain that is all right.
  model.nodes = {fixed(Vec3::Zero()), free({0.0, 0.0, -1.0}), free({0.0, 0.0, -1.0})};
  model.springs = {joined(0, 1, 100.0, 1.0), joined(1, 2, 100.0, 0.5)};
  EXPECT_EQ(restOf(model).nodes, (std::vector<int>{1, 2}));
  model.gravity = {0.0, 0.0, -9.81};
  model.springs[1].L0 = 0.0;
  EXPECT_EQ(restOf(model).verdict, Verdict::Stable) << "a spring without rest length has no cusp";
}

TEST(Rest, TheCentreOfABallAndAStraightAngleThatShouldBendAreCusps) {
  Model model;
  model.gravity = {0.0, 0.0, -9.81};
  model.nodes = {free({0.0, 0.0, 2.0})};
  Obstacle ball;
  ball.kind = Obstacle::Kind::Sphere;
  ball.centre = {0.0, 0.0, 2.0};
  model.obstacles = {ball};
  EXPECT_EQ(restOf(model).verdict, Verdict::Cusp);

  Model bent;
  bent.nodes = {fixed(Vec3::Zero()), free({1.0, 0.0, 0.0}), free({2.0, 0.0, 0.0})};
  bent.springs = {joined(0, 1, 100.0, 1.0), joined(1, 2, 100.0, 1.0)};
  ModelAngle angle;
  angle.theta0 = 0.4;
  bent.angles = {angle};
  EXPECT_EQ(restOf(bent).verdict, Verdict::Cusp);
  bent.angles[0].theta0 = 0.0;
  EXPECT_EQ(restOf(bent).verdict, Verdict::Neutral) << "straight as it should be, it turns freely about its pin";
}

/// A contact that opens or closes is a kink of the force, and no cusp.
TEST(Rest, ANodeThatJustTouchesIsNoCusp) {
  Model model;
  model.nodes = {free(Vec3::Zero())};
  model.obstacles = {Obstacle{}};
  EXPECT_EQ(restOf(model).verdict, Verdict::Neutral);
}

TEST(Rest, AFreePairUnderGravityIsUnsupported) {
  Model model = pendulum(100.0, {0.0, 0.3, -1.0});
  model.nodes[0] = free(Vec3::Zero(), 2.0);
  const RestResult result = restOf(model);
  EXPECT_EQ(result.verdict, Verdict::Unsupported);
  EXPECT_FALSE(result.isFound());
  EXPECT_EQ(result.nodes, (std::vector<int>{0, 1}));
  EXPECT_NEAR(result.carried[2], -3.0 * 9.81, 1e-12);
  // The same beside a chain that hangs well: the pair is named, and not the chain.
  model.nodes.push_back(fixed({5.0, 0.0, 0.0}));
  model.nodes.push_back(free({5.0, 0.0, -1.0}));
  model.springs.push_back(joined(2, 3, 100.0, 1.0));
  EXPECT_EQ(restOf(model).nodes, (std::vector<int>{0, 1}));
}

TEST(Rest, WhatFallsBesideAnObstacleIsUnsupported) {
  Model model;
  model.gravity = {0.0, 0.0, -9.81};
  model.nodes = {free({3.0, 0.0, 0.0})};
  Obstacle ball;
  ball.kind = Obstacle::Kind::Sphere;
  model.obstacles = {ball};
  EXPECT_EQ(restOf(model).verdict, Verdict::Unsupported);
}

/// Six rigid motions cost nothing; two forces that cancel stretch it and hold two of its turns.
TEST(Rest, AFreePairWithoutWeightIsNeutral) {
  Model model = pendulum(100.0, {0.0, 0.3, -1.0});
  model.gravity.setZero();
  model.nodes[0] = free(Vec3::Zero());
  EXPECT_EQ(restOf(model).verdict, Verdict::Neutral);
  for (const double sign : {1.0, -1.0}) {
    ModelExternalForce force;
    force.nodes = {sign > 0.0 ? 1 : 0};
    force.force = [sign](double, int) { return Vec3(0.0, 0.0, -5.0 * sign); };
    model.externalForces.push_back(force);
  }
  const RestResult pulled = restOf(model);
  EXPECT_EQ(pulled.verdict, Verdict::Neutral);
  EXPECT_NEAR(pulled.tensions[0], 5.0, 1e-12);
}

/// Reference case H14: compressed between two pins a node stands on a saddle; off it, on a ring that is neutral.
TEST(Rest, ACompressedNodeStandsOnASaddleAndBucklesToANeutralRing) {
  Model model;
  model.nodes = {fixed({-0.8, 0.0, 0.0}), fixed({0.8, 0.0, 0.0}), free(Vec3::Zero())};
  model.springs = {joined(0, 2, 100.0, 1.0), joined(1, 2, 100.0, 1.0)};
  const RestResult saddle = restOf(model);
  EXPECT_EQ(saddle.verdict, Verdict::Saddle);
  EXPECT_NEAR(saddle.smallestEigenvalue, -50.0, 1e-7);
  EXPECT_EQ(saddle.negativeEigenvalues, 2);
  EXPECT_NEAR(saddle.tensions[0], -20.0, 1e-12);
  const RestResult ring = restOf(model, {.leaveSaddles = true});
  EXPECT_EQ(ring.verdict, Verdict::Neutral);
  EXPECT_LE(ring.energy, 1e-20);
}

/// Friction holds nothing here: a block on a floor may slide, though its sticking friction has a stiffness.
TEST(Rest, FrictionIsLeftOutOfTheVerdict) {
  Model model;
  model.gravity = {0.0, 0.0, -9.81};
  model.nodes = {free({0.0, 0.0, 0.1}, 2.0)};
  Obstacle ground;
  ground.material.mu = 0.8;
  model.obstacles = {ground};
  const RestResult result = restOf(model);
  EXPECT_EQ(result.verdict, Verdict::Neutral);
  EXPECT_NEAR(result.state.x[2], -2.0 * 9.81 / 1e4, 1e-15);
}

/// Loads are those of the time that is asked for: a force that begins at 1 s, a pin that has moved by then.
TEST(Rest, TimeDependentDataAreTakenAtTheTimeAskedFor) {
  Model model = pendulum(100.0, {0.0, 0.0, -1.0});
  ModelExternalForce force;
  force.nodes = {1};
  force.times = {1.0};
  force.force = [](double, int segment) { return Vec3(0.0, 0.0, segment == 0 ? 0.0 : -3.0); };
  model.externalForces = {force};
  model.nodes[0].pinned = false;
  model.nodes[0].motion = 0;
  Motion motion;
  motion.position = [](double t, int) { return Vec3(2.0 * t, 0.0, 0.0); };
  motion.velocity = [](double, int) { return Vec3(2.0, 0.0, 0.0); };
  model.motions = {motion};
  const auto system = build(model);
  EXPECT_NEAR(rest(*system).tensions[0], 9.81, 1e-12);
  const RestResult later = rest(*system, {.time = 1.5});
  EXPECT_NEAR(later.tensions[0], 12.81, 1e-12);
  EXPECT_NEAR(system->position(later.state, 1)[0], 3.0, 1e-12);
}

/// A tripod of stiff bars: statics alone says what each carries, mg / (3 cos) each, at EA / weight of 1e12 too.
TEST(Rest, ATripodOfStiffBarsCarriesWhatStaticsSays) {
  for (const double k : {1e3, 1e8, 1e13}) {
    Model model;
    model.gravity = {0.0, 0.0, -9.81};
    model.nodes = {free({0.0, 0.0, 1.0})};
    for (int i = 0; i < 3; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / 3.0;
      model.nodes.push_back(fixed({std::cos(angle), std::sin(angle), 0.0}));
      model.springs.push_back(joined(0, i + 1, k, std::numbers::sqrt2));
    }
    const RestResult result = restOf(model);
    ASSERT_EQ(result.verdict, Verdict::Stable) << k;
    // The apex sinks by about mg / k, and the bars lean by as much.
    for (const double T : result.tensions) {
      EXPECT_NEAR(T, -9.81 * std::numbers::sqrt2 / 3.0, 1e-11 + 100.0 / k) << k;
    }
    EXPECT_LE(result.residual, 1e-13) << k;
    EXPECT_FALSE(result.isLowest) << "bars that push promise nothing of other shapes";
  }
}

}  // namespace
}  // namespace muelle::engine
