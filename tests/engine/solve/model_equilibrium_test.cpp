#include "engine/model/model_system.h"
#include "engine/statics/equilibrium.h"
#include "expect_balanced.h"

#include <gtest/gtest.h>
#include <cmath>
#include <limits>

namespace muelle::engine {
namespace {

ModelNode node(const Vec3& x, double m) {
  ModelNode result;
  result.x = x;
  result.m = m;
  return result;
}

ModelNode pin(const Vec3& x) {
  ModelNode result;
  result.x = x;
  result.pinned = true;
  return result;
}

ModelSpring spring(int a, int b, double k, double L0) {
  ModelSpring result;
  result.a = a;
  result.b = b;
  result.k = k;
  result.L0 = L0;
  return result;
}

/// Reference case H16: the planar hang is a saddle with 14 negative eigenvalues at E = -0.441773 J; a minimum lies
/// lower.
TEST(ModelEquilibrium, OfACornerHungClothIsBelowThePlanarSaddle) {
  Model cloth;
  cloth.gravity = {0.0, 0.0, -9.81};
  for (int q = 0; q < 100; ++q) {
    const Vec3 x(0.1 * (q % 10), 0.1 * (q / 10), 0.0);
    cloth.nodes.push_back(q == 0 || q == 9 ? pin(x) : node(x, 0.001));
  }
  const auto join = [&](int i, int j, int p, int q) {
    if (p < 0 || p > 9 || q > 9) return;
    const int a = 10 * j + i, b = 10 * q + p;
    cloth.springs.push_back(spring(a, b, 1000.0, (p != i && q != j ? std::sqrt(2.0) : 1.0) * 0.1));
  };
  for (int j = 0; j < 10; ++j) {
    for (int i = 0; i < 10; ++i) {
      join(i, j, i + 1, j);
      join(i, j, i, j + 1);
      join(i, j, i + 1, j + 1);
      join(i, j, i - 1, j + 1);
    }
  }
  const auto system = build(cloth);
  const StaticResult result = equilibrium(*system, system->initialState());
  expectBalanced(result);
  EXPECT_LE(result.energy, -0.441773);
  EXPECT_GT(result.smallestEigenvalue, 0.0);

  // From the plane y = 0: symmetry keeps a search without curvature on the saddle.
  State planar = system->initialState();
  for (int q = 0; q < 100; ++q) {
    if (q == 0 || q == 9) continue;
    planar.x[static_cast<std::size_t>(system->lane(q, 1))] = 0.0;
    planar.x[static_cast<std::size_t>(system->lane(q, 2))] = -0.1 * (q / 10);
  }
  StaticOptions stay;
  stay.leaveSaddles = false;
  const StaticResult saddle = equilibrium(*system, planar, stay);
  EXPECT_NE(saddle.message.find("saddle"), std::string::npos) << saddle.message;
  EXPECT_NEAR(saddle.energy, -0.44177308878147279685, 1e-12);
  const StaticResult left = equilibrium(*system, planar);
  expectBalanced(left);
  EXPECT_LE(left.energy, -0.441773);
  EXPECT_GE(left.saddlesLeft, 1);
}

/// Reference case H18, static: load j of a stack carries what stands on it.
TEST(ModelEquilibrium, OfAStackCarriesTheLoadsAbove) {
  const auto stack = [](double top, double k) {
    Model model;
    model.dimension = 1;
    model.gravity = {-9.81, 0.0, 0.0};
    Obstacle ground;
    ground.normal = Vec3::UnitX();
    ground.material.k = k;
    model.obstacles = {ground};
    for (int i = 0; i < 10; ++i) model.nodes.push_back(node({0.1 * i, 0.0, 0.0}, i == 9 ? top : 1.0));
    for (int i = 0; i < 9; ++i) {
      model.springs.push_back(spring(i, i + 1, k, 0.1));
      model.springs.back().unilateral = true;
    }
    return model;
  };
  const auto even = build(stack(1.0, 1e4));
  const StaticResult result = equilibrium(*even, even->initialState());
  expectBalanced(result);
  EXPECT_NEAR(even->position(result.state, 0)[0], -0.00981, 1e-12);
  EXPECT_NEAR(even->position(result.state, 9)[0], 0.846045, 1e-11);
  const auto heavy = build(stack(1000.0, 1e6));
  const StaticResult loaded = equilibrium(*heavy, heavy->initialState());
  expectBalanced(loaded);
  EXPECT_NEAR(heavy->position(loaded.state, 0)[0], -0.00989829, 1e-12);
  EXPECT_NEAR(heavy->position(loaded.state, 9)[0], 0.80145855, 1e-11);
}

/// Reference case H15: springs alone leave the triangle inverted, which is correct; the signed area turns it back, from
/// the stationary point y = -1 of the springs too.
TEST(ModelEquilibrium, SignedAreaTurnsATriangleBack) {
  Model triangle;
  triangle.dimension = 2;
  triangle.nodes = {pin({-0.75, 0.0, 0.0}), pin({0.75, 0.0, 0.0}), node({0.0, 0.0, -1.0}, 1.0)};
  triangle.springs = {spring(0, 2, 10.0, 1.25), spring(1, 2, 10.0, 1.25)};
  auto system = build(triangle);
  StaticResult result = equilibrium(*system, system->initialState());
  expectBalanced(result);
  EXPECT_NEAR(result.state.x[1], -1.0, 1e-12);

  ModelArea area;
  area.k = 100.0;
  area.A0 = 0.75;
  triangle.areas = {area};
  system = build(triangle);
  result = equilibrium(*system, system->initialState());
  expectBalanced(result);
  EXPECT_NEAR(result.state.x[0], 0.0, 1e-9);
  EXPECT_NEAR(result.state.x[1], 1.0, 1e-12);
  EXPECT_LE(result.energy, 1e-20);
}

/// A property has rank one: without springs the rest of the nodes' motions cost nothing.
TEST(ModelEquilibrium, OfAPropertyAloneIsAMechanism) {
  Model model;
  ModelProperty mean;
  mean.k = 400.0;
  mean.p0 = 1.0;
  for (int i = 0; i < 50; ++i) {
    model.nodes.push_back(node({0.0, 0.0, i / 50.0}, 0.02));
    mean.nodes.push_back(i);
    mean.weights.push_back({0.0, 0.0, 1.0 / 50.0});
  }
  model.properties = {mean};
  const auto system = build(model);
  const StaticResult result = equilibrium(*system, system->initialState());
  EXPECT_TRUE(result.converged) << result.message;
  EXPECT_NEAR(result.smallestEigenvalue, 0.0, 1e-6);
  double height = 0.0;
  for (int i = 0; i < 50; ++i) height += system->position(result.state, i)[2] / 50.0;
  EXPECT_NEAR(height, 1.0, 1e-12);
  EXPECT_LE(result.energy, 1e-20);
}

}  // namespace
}  // namespace muelle::engine
