#include "sample_models.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <optional>

namespace muelle::engine::testing {
namespace {

/// A damped chain of twelve nodes that bends, its first node pinned, half of it below the ground: enough springs for
/// the kernels' groups of eight.
Model bentChain() {
  Model model;
  Random random(5);
  for (int i = 0; i < 12; ++i) {
    ModelNode node;
    node.x = Vec3(0.3 * i, 0.0, 0.0) + 0.1 * random.vector();
    node.m = 0.5 + 0.1 * i;
    node.pinned = i == 0;
    model.nodes.push_back(node);
  }
  for (int i = 0; i + 1 < 12; ++i) {
    model.springs.push_back({.a = i, .b = i + 1, .k = 200.0 + i, .L0 = 0.3, .dProjected = 0.2});
  }
  for (int i = 0; i + 2 < 12; ++i) model.angles.push_back({i, i + 1, i + 2, 0.5});
  model.obstacles = {{.material = {.k = 300.0}}};
  return model;
}

/// Constraint j at x, where it acts.
std::optional<Constraint> constraintAt(const DynamicalSystem& system, int j, const State& at) {
  std::optional<Constraint> found;
  system.constraints()->evaluate(at.t, at.x, at.z, [&](std::span<const Constraint> some) {
    for (const Constraint& c : some) {
      if (c.index == j) found = c;
    }
  });
  return found;
}

TEST(ConstraintSweep, ProjectsEachInTurnAtWhatThoseBeforeItHaveMoved) {
  const auto system = build(bentChain());
  State swept = system->initialState();
  system->switching()->commit(swept, false);
  State turned = swept;
  std::vector<double> before = swept.x;
  for (std::size_t i = 0; i < before.size(); ++i) before[i] -= 0.01 * system->inverseMass()[i];  // as after a motion
  const double* inverseMass = system->inverseMass().data();
  const double h = 0.02;
  system->constraints()->project(0.0, swept.z, {h, inverseMass, before.data(), swept.x.data(), swept.v.data()});
  const ConstraintProjection projection{h, inverseMass, before.data(), turned.x.data(), turned.v.data()};
  int acting = 0;
  for (int j = 0; j < system->constraints()->count(); ++j) {
    const auto constraint = constraintAt(*system, j, turned);
    if (!constraint) continue;
    projection(*constraint);
    ++acting;
  }
  EXPECT_GT(acting, 11 + 10);  // springs, angles and some contacts
  for (std::size_t i = 0; i < swept.x.size(); ++i) {
    // The same formulas, other orders of sums: some ten roundings in each of the three constraints or so that move a
    // node. Corrections are below 1 m, and velocities take them over h.
    EXPECT_NEAR(swept.x[i], turned.x[i], 1e-14);
    EXPECT_NEAR(swept.v[i], turned.v[i], 1e-14 / h);
  }
}

}  // namespace
}  // namespace muelle::engine::testing
