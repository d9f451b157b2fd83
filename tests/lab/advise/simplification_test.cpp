/// \file
/// What may be left out of a model, and for each kind a trap in which it must stay.

#include "lab/advise/simplification.h"

#include "engine/scene/generators.h"
#include "engine/scene/time_functions.h"
#include "lab/advise/advice.h"

#include <gmock/gmock.h>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace muelle::lab {

using namespace engine;
namespace {

using ::testing::HasSubstr;

Scene sceneOf(Model model, double duration) {
  Scene scene;
  scene.name = "test";
  scene.model = std::move(model);
  scene.method = "velocity_verlet";
  scene.step = duration / 1000.0;
  scene.duration = duration;
  return scene;
}

ModelNode nodeAt(const Vec3& x, bool pinned = false) {
  ModelNode node;
  node.x = x;
  node.pinned = pinned;
  return node;
}

const PartTrial* find(const Advice& advice, const std::string& name) {
  const auto place = std::ranges::find(advice.parts, name, [](const PartTrial& trial) { return trial.part.name; });
  return place == advice.parts.end() ? nullptr : &*place;
}

Advice adviceOn(const Scene& scene, double tolerance = 1e-3) {
  return advise(scene, {.tolerance = tolerance, .budget = 60.0});
}

/// Two pins 2 m apart along x, a node between them that springs of rest length L0 hold, and a second one that hangs and
/// swings below it, near the 0.99 m at which its spring carries it.
Scene between(double L0) {
  Model model;
  model.nodes = {nodeAt({-1, 0, 0}, true), nodeAt({1, 0, 0}, true), nodeAt({0.1, 0, 0}), nodeAt({0.0, 0, -1.0})};
  model.nodes[3].v = {0.5, 0.0, 0.0};
  model.gravity = {0.0, 0.0, -9.81};
  model.springs = {{0, 2, 100.0, L0}, {1, 2, 100.0, L0}, {2, 3, 20.0, 0.5}};
  return sceneOf(model, 2.0);
}

/// Springs that pull: across the plane each holds its node by tension over length.
TEST(Axis, IsLeftOutWhereSpringsPullTheNodesIntoThePlane) {
  const Advice advice = adviceOn(between(0.5));
  ASSERT_NE(advice.chosen(), nullptr) << advice.refusal;
  const PartTrial* axis = find(advice, "the y axis");
  ASSERT_NE(axis, nullptr);
  EXPECT_TRUE(axis->leftOut) << axis->why;
  EXPECT_LT(axis->error, 1e-4);
  EXPECT_EQ(advice.scene.model.dimension, 2);
}

/// Trap: springs longer than their room push. In the plane nothing shows, for nothing disturbs; across it the stiffness
/// is 2 k (1 - L0 / L) < 0, and the least push makes the node jump out.
TEST(Axis, StaysWhereTheModelWouldBuckle) {
  const Advice advice = adviceOn(between(1.3));
  ASSERT_NE(advice.chosen(), nullptr) << advice.refusal;
  const PartTrial* axis = find(advice, "the y axis");
  ASSERT_NE(axis, nullptr);
  EXPECT_FALSE(axis->leftOut);
  EXPECT_THAT(axis->why, HasSubstr("buckle along y"));
  EXPECT_EQ(advice.scene.model.dimension, 3);
}

/// Trap: a late pulse across the plane: until then nothing leaves it.
TEST(Axis, IsNotOfferedWhereAPulseComesLate) {
  Scene scene = between(0.5);
  scene.model.externalForces.push_back(externalForce({2}, Vec3(0.0, 5.0, 0.0), 1.9, 1.95, 0.0));
  EXPECT_THAT(leavesPlane(scene, 1, 2), HasSubstr("a force pushes out of it at 1.9"));
  EXPECT_TRUE(std::ranges::none_of(simplificationsOf(scene),
                                   [](const Simplification& p) { return p.kind == Simplification::Kind::Axis; }));
}

TEST(Axis, IsNotOfferedWhereAnythingLeavesThePlane) {
  const Scene flat = between(0.5);
  EXPECT_EQ(leavesPlane(flat, 1, 2), "");
  Scene scene = flat;
  scene.model.nodes[3].v[1] = 1e-6;
  EXPECT_THAT(leavesPlane(scene, 1, 2), HasSubstr("node 3 flies"));
  scene = flat;
  scene.model.nodes[3].x[1] = 1e-6;
  EXPECT_THAT(leavesPlane(scene, 1, 2), HasSubstr("node 3 does not lie"));
  scene = flat;
  scene.model.gravity = {0.0, -1.0, 0.0};
  EXPECT_THAT(leavesPlane(scene, 1, 2), HasSubstr("gravity"));
  scene = flat;
  Obstacle ball;
  ball.kind = Obstacle::Kind::Sphere;
  ball.centre = {0.0, 0.1, -5.0};
  scene.model.obstacles = {ball};
  EXPECT_THAT(leavesPlane(scene, 1, 2), HasSubstr("pushes out"));
}

/// A mass on a spring above a floor: x = 1 + 0.2 cos 10 t reaches 0.8 m.
Scene aboveFloor(double floor, double duration) {
  Model model;
  model.dimension = 1;
  model.nodes = {nodeAt({0, 0, 0}, true), nodeAt({1.2, 0, 0})};
  model.springs = {{0, 1, 100.0, 1.0}};
  Obstacle ground;
  ground.normal = Vec3::UnitX();
  ground.centre = {floor, 0.0, 0.0};
  ground.material.k = 1e4;
  model.obstacles = {ground};
  return sceneOf(model, duration);
}

/// The pin lies at 0 and is no matter: it cannot touch.
TEST(Contact, IsLeftOutWhereNoNodeComesNear) {
  const Advice advice = adviceOn(aboveFloor(0.7, 3.0));
  const PartTrial* contact = find(advice, "contact with 'ground'");
  ASSERT_NE(contact, nullptr);
  EXPECT_TRUE(contact->leftOut) << contact->why;
  EXPECT_THAT(contact->why, HasSubstr("nearer than"));
  EXPECT_TRUE(advice.scene.model.obstacles.empty());
}

/// The energy k 0.2^2 / 2 = 2 J makes at most 2 m/s, and so 6 m in 3 s.
TEST(Contact, TheEnergyTellsWhereTheFloorIsFar) {
  const Advice advice = adviceOn(aboveFloor(-10.0, 3.0));
  EXPECT_THAT(find(advice, "contact with 'ground'")->why, HasSubstr("by its energy no node comes farther than 6 m"));
}

/// Trap: the node reaches the floor only once a force in step has built up its amplitude.
TEST(Contact, StaysWhereItIsTouchedLate) {
  Scene scene = aboveFloor(0.75, 6.0);
  scene.model.nodes[1].x = {0.95, 0.0, 0.0};
  // In step with the spring: 0.05 m grows by F t / (2 m w) = t / 20, past 0.25 m after 4 s.
  scene.model.externalForces.push_back(
      externalForce({1}, Vec3(1.0, 0.0, 0.0), 0.0, 1e9, 10.0 / (2.0 * std::numbers::pi)));
  const Advice advice = adviceOn(scene);
  ASSERT_NE(advice.chosen(), nullptr) << advice.refusal;
  const PartTrial* contact = find(advice, "contact with 'ground'");
  ASSERT_NE(contact, nullptr);
  EXPECT_FALSE(contact->leftOut);
  EXPECT_THAT(contact->why, HasSubstr("it is touched at"));
  const double touch = std::stod(contact->why.substr(std::string("it is touched at ").size()));
  EXPECT_NEAR(touch, 4.0, 0.5);  // the half period in which it is passed
}

/// Damping of d = 1e-6 kg/s takes exp(-d t / 2m) = 1 - 3e-6 of the amplitude in 6 s: nothing at 1e-3. Without it the
/// force does not depend on the velocity, and a Nystroem method may run.
TEST(Damping, IsLeftOutWhereItDoesNothing) {
  Scene scene = aboveFloor(0.7, 6.0);
  scene.model.obstacles.clear();
  scene.model.springs[0].dProjected = 1e-6;
  const Advice advice = adviceOn(scene);
  const PartTrial* damping = find(advice, "damping of springs");
  ASSERT_NE(damping, nullptr);
  EXPECT_TRUE(damping->leftOut) << damping->why;
  EXPECT_LT(damping->error, 1e-5);
  EXPECT_EQ(advice.scene.model.springs[0].dProjected, 0.0);
  EXPECT_TRUE(advice.chosen()->estimate.refusal.empty());
}

/// Trap: at resonance. Over the first periods damping changes little; later it alone bounds the amplitude at
/// F / (d w): at d = 0.05 a rate of d / 2m = 0.025 1/s takes 14 % of what builds up in 12 s.
TEST(Damping, StaysAtResonance) {
  Scene scene = aboveFloor(0.7, 12.0);
  scene.model.obstacles.clear();
  scene.model.nodes[1].x = {1.01, 0.0, 0.0};
  scene.model.springs[0].dProjected = 0.05;
  scene.model.externalForces.push_back(
      externalForce({1}, Vec3(0.1, 0.0, 0.0), 0.0, 1e9, 10.0 / (2.0 * std::numbers::pi)));
  const Advice advice = adviceOn(scene, 1e-2);
  const PartTrial* damping = find(advice, "damping of springs");
  ASSERT_NE(damping, nullptr) << advice.refusal;
  EXPECT_FALSE(damping->leftOut);
  EXPECT_GT(damping->error, 0.05);
}

/// A grid of 6 x 6 that is stretched in its plane, and so pulls and swings without turning.
Scene grid(bool isHung) {
  Model model;
  GridShape shape;
  shape.nu = shape.nv = 6;
  shape.spacing = 0.2;
  shape.structural.k = 200.0;
  shape.bendStiffness = 20.0;
  shape.shearStiffness = 100.0;
  const Part part = addGrid(model, shape, "cloth");
  lumpMass(model, part, 0.36);
  if (isHung) {
    model.gravity = {0.0, 0.0, -9.81};
    model.nodes[0].pinned = model.nodes[5].pinned = true;
  } else {
    for (ModelNode& node : model.nodes) node.v = {1.0, 0.0, 0.5};
    model.nodes[0].v = {1.0, 0.0, 0.5001};
  }
  Scene scene = sceneOf(model, isHung ? 0.3 : 0.2);
  scene.parts = {part};
  return scene;
}

TEST(Springs, OfTheKeysOfAGridMayGoAndTheOthersStay) {
  const Scene scene = grid(true);
  const std::vector<Simplification> parts = simplificationsOf(scene);
  std::vector<std::string> names;
  for (const Simplification& part : parts) names.push_back(part.name);
  EXPECT_THAT(names, ::testing::IsSupersetOf({"cloth.shear", "cloth.bend"}));
  EXPECT_THAT(names, ::testing::Not(::testing::Contains("cloth.structural")));
  const Scene rest = without(scene, parts);
  EXPECT_EQ(rest.model.springs.size(), 2U * 6U * 5U);
  EXPECT_EQ(rest.model.nodes.size(), 36U);
}

/// Trap: a cloth that falls and folds needs its bending springs.
TEST(Springs, StayWhereTheClothFolds) {
  const Advice advice = adviceOn(grid(true));
  ASSERT_NE(advice.chosen(), nullptr) << advice.refusal;
  for (const char* name : {"cloth.shear", "cloth.bend"}) {
    const PartTrial* part = find(advice, name);
    ASSERT_NE(part, nullptr);
    EXPECT_FALSE(part->leftOut) << name;
    EXPECT_GT(part->error, 1e-3) << name;
  }
}

/// It flies as one: no spring does anything that could be seen. (Speeds are measured against those of all.)
TEST(Springs, AreLeftOutWhereTheyDoNothing) {
  Scene scene = grid(false);
  scene.model.nodes[0].v = {1.0, 0.0, 0.5};
  scene.model.nodes[35].pinned = false;
  // One node far off swings by itself and is what moves.
  scene.model.nodes.push_back(nodeAt({9, 0, 0}, true));
  scene.model.nodes.push_back(nodeAt({10.2, 0, 0}));
  scene.model.springs.push_back({36, 37, 100.0, 1.0});
  const Advice advice = adviceOn(scene);
  ASSERT_NE(advice.chosen(), nullptr) << advice.refusal;
  EXPECT_TRUE(find(advice, "cloth.bend")->leftOut) << find(advice, "cloth.bend")->why;
  EXPECT_TRUE(find(advice, "cloth.shear")->leftOut) << find(advice, "cloth.shear")->why;
}

/// Two oscillators side by side; the second is at rest, until a pulse comes.
Scene sleeper(bool isWoken) {
  Scene scene = aboveFloor(0.7, 4.0);
  scene.model.obstacles.clear();
  scene.model.nodes.push_back(nodeAt({5, 0, 0}, true));
  scene.model.nodes.push_back(nodeAt({6, 0, 0}));
  scene.model.springs.push_back({2, 3, 400.0, 1.0});
  if (isWoken) scene.model.externalForces.push_back(externalForce({3}, Vec3(50.0, 0.0, 0.0), 3.8, 3.85, 0.0));
  return scene;
}

TEST(StillNodes, ArePinnedWhereNothingWakesThem) {
  const Advice advice = adviceOn(sleeper(false));
  const PartTrial* still = find(advice, "motion of node 3");
  ASSERT_NE(still, nullptr);
  EXPECT_TRUE(still->leftOut) << still->why;
  EXPECT_TRUE(advice.scene.model.nodes[3].pinned);
}

/// Trap: a pulse in the last twentieth of the run.
TEST(StillNodes, AreNotStillWhereAPulseComesLate) {
  const Advice advice = adviceOn(sleeper(true));
  ASSERT_NE(advice.chosen(), nullptr) << advice.refusal;
  EXPECT_EQ(find(advice, "motion of node 3"), nullptr);
  EXPECT_FALSE(advice.scene.model.nodes[3].pinned);
}

/// A spring along its line is linear: the closed form is exact, whatever the amplitude.
TEST(LinearModes, DescribeASpringAlongItsLine) {
  Scene scene = aboveFloor(0.7, 3.0);
  scene.model.obstacles.clear();
  const Advice advice = adviceOn(scene, 1e-6);
  ASSERT_EQ(advice.forms.size(), 1U);
  EXPECT_EQ(advice.forms[0].name, "linear modes");
  EXPECT_TRUE(advice.forms[0].holds) << advice.forms[0].error;
}

/// An elastic pendulum whose bounce, 2 sqrt(g / L), has twice the frequency of its swing: k = 4 m g / L. It bounces
/// with 0.05 m and is hardly off the plumb line.
Scene resonant(double duration) {
  Model model;
  model.dimension = 2;
  model.gravity = {0.0, 0.0, -9.81};
  constexpr double L = 1.0, k = 4.0 * 9.81 / L;
  model.nodes = {nodeAt({0, 0, 0}, true), nodeAt({1e-3, 0, -L - 0.05})};
  model.springs = {{0, 1, k, L - 9.81 / k}};
  return sceneOf(model, duration);
}

/// Trap: at first the bounce is linear to second order; then it turns into a swing, which no linear mode has.
TEST(LinearModes, DoNotHoldWhereAResonanceWakesTheSwing) {
  const Advice shortly = adviceOn(resonant(0.5), 0.1), late = adviceOn(resonant(40.0), 0.1);
  ASSERT_EQ(shortly.forms.size(), 1U);
  ASSERT_EQ(late.forms.size(), 1U);
  EXPECT_TRUE(shortly.forms[0].holds) << shortly.forms[0].error;
  EXPECT_FALSE(late.forms[0].holds) << late.forms[0].error;
}

TEST(FreeFlight, HoldsUntilTheGroundIsTouched) {
  Scene scene;
  scene.model.dimension = 1;
  scene.model.gravity = {-9.81, 0.0, 0.0};
  scene.model.nodes = {nodeAt({1, 0, 0})};
  scene = sceneOf(scene.model, 0.4);
  Obstacle ground;
  ground.normal = Vec3::UnitX();
  scene.model.obstacles = {ground};
  const Advice flight = adviceOn(scene, 1e-6);
  ASSERT_EQ(flight.forms.size(), 1U);
  EXPECT_TRUE(flight.forms[0].holds);
  scene.duration = 0.6;  // it falls for 0.45 s
  const Advice bounce = adviceOn(scene, 1e-2);
  ASSERT_EQ(bounce.forms.size(), 1U);
  EXPECT_FALSE(bounce.forms[0].holds);
}

TEST(Islands, WhatIsHeldPassesNothingOn) {
  Model model;
  model.nodes = {nodeAt({0, 0, 0}), nodeAt({1, 0, 0}, true), nodeAt({2, 0, 0}), nodeAt({3, 0, 0})};
  model.springs = {{0, 1, 1.0, 1.0}, {1, 2, 1.0, 1.0}, {2, 3, 1.0, 1.0}};
  EXPECT_EQ(islandsOf(model), (std::vector<std::vector<int>>{{0}, {2, 3}}));
}

}  // namespace
}  // namespace muelle::lab
