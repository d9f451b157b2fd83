#include "sample_models.h"

#include "support/allocation_count.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <cmath>
#include <Eigen/Geometry>
#include <functional>
#include <limits>

namespace muelle::engine::testing {
namespace {

using ::testing::HasSubstr;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

Model twoNodes() {
  Model model;
  model.nodes = {{.x = {0, 0, 0}}, {.x = {1, 0, 0}}};
  model.springs = {{.a = 0, .b = 1, .k = 10.0}};
  return model;
}

std::string complaint(const std::function<void(Model&)>& spoil) {
  Model model = twoNodes();
  spoil(model);
  try {
    build(model);
  } catch (const std::invalid_argument& fault) {
    return fault.what();
  }
  return "accepted";
}

TEST(BadInput, IsRejectedWithTheNameOfTheItem) {
  const std::vector<std::pair<std::function<void(Model&)>, std::string>> cases = {
      {[](Model& m) { m.nodes[1].m = 0.0; }, "node 1: mass is 0"},
      {[](Model& m) { m.nodes[1].m = -2.0; }, "node 1: mass is -2"},
      {[](Model& m) { m.nodes[0].m = nan; }, "node 0: mass is nan; a mass is positive and finite"},
      {[](Model& m) { m.nodes[1].x[1] = nan; }, "node 1: position"},
      {[](Model& m) { m.nodes[1].v[2] = infinity; }, "node 1: velocity"},
      {[](Model& m) { m.springs[0].k = nan; }, "spring 0: stiffness k is nan"},
      {[](Model& m) { m.springs[0].k = -1.0; }, "spring 0: stiffness k is -1"},
      {[](Model& m) { m.springs[0].k = infinity; }, "spring 0: stiffness k is inf"},
      {[](Model& m) { m.springs[0].k = 5e-324; }, "spring 0: stiffness k is"},
      {[](Model& m) { m.springs[0].L0 = -0.1; }, "spring 0: rest length L0 is -0.1"},
      {[](Model& m) { m.springs[0].L0 = nan; }, "spring 0: rest length L0 is nan"},
      {[](Model& m) { m.springs[0].dRelative = -1.0; }, "spring 0: relative damping is -1"},
      {[](Model& m) { m.springs[0].dProjected = -1.0; }, "spring 0: projected damping is -1"},
      {[](Model& m) { m.nodes[0].drag = -1.0; }, "node 0: drag is -1"},
      {[](Model& m) { m.springs[0].b = 0; }, "spring 0: joins node 0 with itself"},
      {[](Model& m) { m.springs[0].b = 2; }, "spring 0: there is no node 2; nodes are 0 to 1"},
      {[](Model& m) { m.springs[0].a = -1; }, "spring 0: there is no node -1"},
      {[](Model& m) { m.springs.push_back({.a = 1, .b = 0}); }, "spring 1: joins nodes 0 and 1, as spring 0 does"},
      {[](Model& m) { m.nodes.clear(); }, "model: has no nodes"},
      {[](Model& m) { m.nodes[0].pinned = m.nodes[1].pinned = true; }, "model: all nodes are pinned"},
      {[](Model& m) { m.dimension = 4; }, "model: dimension is 4"},
      {[](Model& m) { m.nodes[0].motion = 0; }, "node 0: there is no motion 0"},
      {[](Model& m) { m.gravity[0] = nan; }, "gravity"},
      {[](Model& m) {
         m.dimension = 1, m.gravity = {0, 0, -9.81};
       },
       "leaves the line of a 1D scene"},
      {[](Model& m) { m.dimension = 1, m.obstacles.emplace_back(); }, "obstacle 'ground': normal (0, 0, 1) leaves"},
      {[](Model& m) {
         m.angles = {{0, 1, 1}};
       },
       "angle 0: uses node 1 twice"},
      {[](Model& m) {
         m.dimension = 2, m.volumes = {{0, 1, 0, 1}};
       },
       "volume 0: volumes need a 3D scene"},
      {[](Model& m) {
         m.properties = {{{0}, {}}};
       },
       "property 0: has 1 node and 0 weights"},
      {[](Model& m) {
         m.externalForces = {{{0}, {}, {}}};
       },
       "external force 0: has no function"},
      {[](Model& m) { m.obstacles.emplace_back().material.mu = -1; }, "obstacle 'ground': friction mu is -1"},
  };
  for (const auto& [spoil, words] : cases) EXPECT_THAT(complaint(spoil), HasSubstr(words));
}

TEST(BadInput, WhatIsUnusualButRightIsAccepted) {
  EXPECT_EQ(complaint([](Model& m) { m.springs.clear(); }), "accepted") << "nodes without a spring";
  EXPECT_EQ(complaint([](Model& m) { m.nodes[1].x = m.nodes[0].x; }), "accepted") << "nodes at one place";
  EXPECT_EQ(complaint([](Model& m) { m.springs[0].k = 0.0; }), "accepted");
  EXPECT_EQ(complaint([](Model& m) { m.nodes[0].pinned = true, m.nodes[0].m = 0.0; }), "accepted");
}

TEST(Lengths, NeitherOverflowNorUnderflow) {
  for (const double scale : {1e200, 1e-200}) {
    Model model = twoNodes();
    model.nodes[1].x = scale * Vec3(3, 0, 4);
    model.springs[0] = {.a = 0, .b = 1, .k = 1.0, .L0 = 2.0 * scale};
    const auto system = build(model);
    const State s = system->initialState();
    const std::vector<double> f = forceOf(*system, s);
    // L = 5, so the spring pulls with 3 along (3, 0, 4) / 5.
    EXPECT_NEAR(f[static_cast<std::size_t>(system->lane(0, 0))] / scale, 1.8, 1e-15);
    EXPECT_NEAR(f[static_cast<std::size_t>(system->lane(0, 2))] / scale, 2.4, 1e-15);
  }
}

/// All forces at once, 3D.
Model everything() {
  Model model = sixNodes(3, 7);
  for (int a = 0; a < 6; ++a) {
    for (int b = a + 1; b < 6; ++b) model.springs.push_back({a, b, 10.0 + a + b, 0.8, 0.2, 0.3, a == 1});
  }
  model.angles = {{0, 1, 2, 3.0, 0.0}};
  model.dihedrals = {{0, 1, 2, 3, 3.0, 0.2}};
  model.areas = {{0, 1, 4, 3.0, 0.2, Vec3::UnitX()}};
  model.volumes = {{5, 1, 2, 3, 3.0, 0.2}};
  model.properties = {{{0, 1, 5}, {Vec3(1, 2, 3), Vec3(0, 1, 0), Vec3(1, 0, 1)}, 4.0, 0.5}};
  model.externalForces = {{{3, 5}, [](double t, int segment) { return Vec3(t, segment, 1); }, {0.5, 1.0}}};
  model.obstacles.emplace_back();
  model.obstacles.back().material = {50.0, 1.0, 0.4, 0.0, 0.1};
  model.obstacles.emplace_back();
  model.obstacles.back().kind = Obstacle::Kind::Box;
  model.obstacles.back().halfSize = {1.2, 1, 1};
  model.obstacles.emplace_back();
  model.obstacles.back().kind = Obstacle::Kind::Sphere;
  model.gravity = {0, 0, -9.81};
  model.motions = {{[](double t, int) { return Vec3(1 + t, 0, 0); }, [](double, int) { return Vec3(1, 0, 0); }}};
  model.nodes[4].motion = 0;
  for (ModelNode& node : model.nodes) node.drag = 0.3;
  return model;
}

TEST(Numbering, TheUsersNumbersGiveTheSameForces) {
  Model model = everything();
  const auto renumbered = build(model);
  model.renumber = false;
  const auto plain = build(model);
  State a = renumbered->initialState(), b = plain->initialState();
  ASSERT_EQ(renumbered->size(), 12) << "four free nodes";
  a.t = b.t = 0.7;
  renumbered->place(a.t, a.z, a.x, a.v);
  plain->place(b.t, b.z, b.x, b.v);
  const std::vector<double> fa = forceOf(*renumbered, a), fb = forceOf(*plain, b);
  EXPECT_NEAR(renumbered->totalEnergy(a), plain->totalEnergy(b), 1e-12);
  EXPECT_NEAR((renumbered->momentum(a) - plain->momentum(b)).norm(), 0.0, 1e-14);
  EXPECT_NEAR((renumbered->angularMomentum(a) - plain->angularMomentum(b)).norm(), 0.0, 1e-14);
  for (int node = 0; node < 6; ++node) {
    EXPECT_EQ(renumbered->position(a, node), plain->position(b, node));
    EXPECT_EQ(renumbered->velocity(a, node), plain->velocity(b, node));
    for (int axis = 0; axis < 3; ++axis) {
      const int i = renumbered->unknown(node, axis), j = plain->unknown(node, axis);
      if (node == 2 || node == 4) {
        EXPECT_EQ(i, -1) << "pinned or moved";
        continue;
      }
      EXPECT_NEAR(fa[laneOf(*renumbered, i)], fb[laneOf(*plain, j)], 1e-12);
      EXPECT_EQ(laneOf(*plain, j), static_cast<std::size_t>(plain->lane(node, axis)));
      EXPECT_EQ(renumbered->unknownName(i), plain->unknownName(j));
    }
  }
  EXPECT_THROW(renumbered->unknown(6, 0), std::out_of_range);
}

TEST(Numbering, ReverseCuthillMcKeeMakesAShuffledChainABand) {
  Model model;
  constexpr int n = 50;
  for (int i = 0; i < n; ++i) model.nodes.push_back({.x = Vec3(i, 0, 0)});
  for (int i = 0; i + 1 < n; ++i) model.springs.push_back({.a = (i * 17) % n, .b = ((i + 1) * 17) % n});
  const auto system = build(model);
  for (const ModelSpring& spring : model.springs) {
    EXPECT_EQ(std::abs(system->unknown(spring.a, 0) - system->unknown(spring.b, 0)), 3) << "neighbours in memory";
  }
}

TEST(Momentum, InternalForcesSumToZeroWithoutATorque) {
  Model model = sixNodes(3, 3);
  for (ModelNode& node : model.nodes) node.pinned = false;
  for (int a = 0; a < 6; ++a) {
    for (int b = a + 1; b < 6; ++b) model.springs.push_back({a, b, 10.0 + a + b, 0.8, 0.0, 0.3});
  }
  model.angles = {{0, 1, 2, 3.0, 0.0}, {3, 1, 5, 3.0, 0.4}};
  model.dihedrals = {{0, 1, 2, 3, 3.0, 0.2}};
  model.volumes = {{5, 1, 2, 3, 3.0, 0.2}};
  const auto system = build(model);
  State s = system->initialState();
  const std::vector<double> f = forceOf(*system, s);
  double size = 0.0;
  Vec3 sum = Vec3::Zero(), torque = Vec3::Zero();
  for (int node = 0; node < 6; ++node) {
    const Eigen::Map<const Vec3> F(f.data() + system->lane(node, 0));
    sum += F;
    torque += system->position(s, node).cross(F);
    size += F.norm();
  }
  EXPECT_LE(sum.norm(), 1e-14 * size);
  EXPECT_LE(torque.norm(), 1e-14 * size);
}

TEST(PrescribedMotion, MovesTheEndOfASpringAndDampsAgainstItsVelocity) {
  Model model = twoNodes();
  model.motions = {{[](double t, int) { return Vec3(2 * t - 3, 0, 0); }, [](double, int) { return Vec3(2, 0, 0); }}};
  model.nodes[0].motion = 0;
  model.springs[0] = {.a = 0, .b = 1, .k = 10.0, .L0 = 1.0, .dRelative = 0.5};
  const auto system = build(model);
  State s = system->initialState();
  s.t = 1.0;
  system->place(s.t, s.z, s.x, s.v);
  const std::vector<double> f = forceOf(*system, s);
  EXPECT_DOUBLE_EQ(f[static_cast<std::size_t>(system->lane(1, 0))], -10.0 * (2.0 - 1.0) + 0.5 * 2.0);
  EXPECT_FALSE(system->potential()->isComplete()) << "the mover does work";
}

TEST(Capabilities, AreThereOnlyWhereTheSceneHasThem) {
  const auto plain = build(twoNodes());
  EXPECT_EQ(plain->switching(), nullptr);
  EXPECT_EQ(plain->drag(), nullptr);
  EXPECT_FALSE(plain->forceUsesVelocity());
  EXPECT_TRUE(plain->potential()->isComplete());
  EXPECT_EQ(plain->constraints()->leftOut(), "");
  const auto all = build(everything());
  EXPECT_NE(all->switching(), nullptr);
  EXPECT_NE(all->drag(), nullptr);
  EXPECT_THAT(all->constraints()->leftOut(), HasSubstr("friction on 'ground'"));
}

TEST(ExternalForce, SeesTheNearSideOfADeclaredTime) {
  Model model;
  model.dimension = 1;
  model.nodes.emplace_back();
  model.externalForces = {{{0}, [](double, int segment) { return Vec3(segment == 1 ? 1000 : 0, 0, 0); }, {1.0, 1.001}}};
  const auto system = build(model);
  const Switching& switching = *system->switching();
  std::vector<double> times, f(1);
  switching.declaredTimes(0.0, 1.0, times);
  EXPECT_EQ(times, std::vector{1.0});
  State s = system->initialState();
  switching.commit(s, true);
  system->force(1.0, s.x, s.v, s.z, f);
  EXPECT_EQ(f[0], 0.0) << "the end of the step before the pulse";
  s.t = 1.0;
  EXPECT_TRUE(switching.commit(s, true));
  system->force(1.001, s.x, s.v, s.z, f);
  EXPECT_EQ(f[0], 1000.0) << "the end of the pulse";
  switching.commit(s, false);
  system->force(1.001, s.x, s.v, s.z, f);
  EXPECT_EQ(f[0], 0.0) << "live: as the time says";
}

TEST(Property, HasNoSparseEntriesAndOneColumn) {
  Model model;
  constexpr int n = 1000;
  ModelProperty property{{}, {}, 400.0, 1.0};
  for (int i = 0; i < n; ++i) {
    model.nodes.push_back({.x = Vec3(0, 0, i / 1000.0), .m = 0.001});
    property.nodes.push_back(i);
    property.weights.push_back(Vec3(0, 0, 1.0 / n));
  }
  model.properties = {property};
  const auto system = build(model);
  const State s = system->initialState();
  EXPECT_NEAR(system->totalEnergy(s), 50.10005, 1e-12);
  std::vector<double> f(s.x.size());
  system->force(0.0, s.x, s.v, s.z, f);
  EXPECT_NEAR(f[static_cast<std::size_t>(system->lane(5, 2))], 0.2002, 1e-15);
  SystemMatrix J;
  system->linearisation()->assemble(1.0, 0.0, 1.0, 0.0, s.x, s.v, s.z, Form::Exact, J);
  EXPECT_EQ(J.sparse.nonZeros(), 9 * n) << "diagonal blocks alone";
  ASSERT_EQ(J.lowRank.s.size(), 1);
  EXPECT_NEAR(J.lowRank.s[0] * J.lowRank.U.squaredNorm(), 0.4, 1e-14) << "the eigenvalue k / n";
  EXPECT_THAT(system->constraints()->leftOut(), HasSubstr("property 0"));
}

TEST(Allocation, NoneInForceOrEnergyAfterTheFirst) {
  const auto system = build(everything());
  State s = system->initialState();
  std::vector<double> f(s.x.size()), guards(static_cast<std::size_t>(system->switching()->guardCount()));
  SystemMatrix J;
  const auto round = [&] {
    system->force(0.1, s.x, s.v, s.z, f);
    system->drag()->accelerationWithoutDrag(0.1, s.x, s.v, s.z, f);
    system->potential()->energy(0.1, s.x, s.z);
    system->potential()->conservativeForce(0.1, s.x, s.z, f);
    system->potential()->discreteGradientForce(0.1, s.x, s.x, s.z, f);
    system->switching()->guards(0.1, s.x, s.v, s.z, guards);
    system->switching()->sweptBound(0.1, s.x, s.v, s.z, 0.1);
    system->switching()->commit(s, true);
    for (const Form form : {Form::Exact, Form::Symmetric}) {
      system->linearisation()->assemble(1.0, 1.0, 1.0, 0.1, s.x, s.v, s.z, form, J);
    }
  };
  round();
  const long before = allocationCount();
  round();
  EXPECT_EQ(allocationCount() - before, 0);
}

TEST(Forces, WithoutRoomForEveryLaneAreRefused) {
  Model model = twoNodes();
  model.nodes[0].pinned = true;
  const auto system = build(model);
  const State state = system->initialState();
  std::vector<double> ofUnknownsAlone(static_cast<std::size_t>(system->size()));
  EXPECT_THROW(system->force(0, state.x, state.v, state.z, ofUnknownsAlone), std::invalid_argument);
  EXPECT_THROW(system->acceleration(0, state.x, state.v, state.z, ofUnknownsAlone), std::invalid_argument);
  EXPECT_THROW(system->potential()->conservativeForce(0, state.x, state.z, ofUnknownsAlone), std::invalid_argument);
}

}  // namespace
}  // namespace muelle::engine::testing
