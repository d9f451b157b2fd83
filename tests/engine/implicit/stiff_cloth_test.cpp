/// \file
/// Cloth whose springs are far too stiff for the step: what TR-BDF2 is for.

#include "engine/control/simulate.h"
#include "engine/integrators/implicit/methods.h"
#include "engine/model/model_system.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace muelle::engine {
namespace {

/// A cloth of side x side nodes of 1 g, 0.1 m apart, hung by two corners: springs along both axes and both diagonals.
Model hungCloth(int side, double k, double d) {
  Model model;
  model.gravity = Vec3(0, 0, -9.81);
  for (int j = 0; j < side; ++j) {
    for (int i = 0; i < side; ++i) {
      ModelNode node;
      node.x = Vec3(0.1 * i, 0.1 * j, 0);
      node.m = 0.001;
      node.pinned = j == 0 && (i == 0 || i == side - 1);
      model.nodes.push_back(node);
    }
  }
  const auto join = [&](int a, int b, double L0) {
    model.springs.push_back({.a = a, .b = b, .k = k, .L0 = L0, .dProjected = d});
  };
  for (int j = 0; j < side; ++j) {
    for (int i = 0; i < side; ++i) {
      const int q = side * j + i;
      if (i + 1 < side) join(q, q + 1, 0.1);
      if (j + 1 < side) join(q, q + side, 0.1);
      if (i + 1 == side || j + 1 == side) continue;
      join(q, q + side + 1, 0.1 * std::numbers::sqrt2);
      join(q + 1, q + side, 0.1 * std::numbers::sqrt2);
    }
  }
  return model;
}

struct Hung {
  RunResult result;
  double scale = 0.0;    ///< S [J]: sum of |F_i| at the start times the extent; nothing moves and nothing is stretched
  double highest = 0.0;  ///< energy above the start [J]
  double end = 0.0;      ///< energy at the end less that at the start [J]
};

Hung hang(Integrator& method, int side, double k, double d, double duration) {
  const auto system = build(hungCloth(side, k, d));
  const State start = system->initialState();
  RunOptions options;
  options.duration = duration;
  options.h = 1.0 / 60.0;
  options.fixedStep = true;
  options.checkStability = options.checkNumericalDamping = false;
  Hung hung;
  hung.result = simulate(*system, method, start, options);
  hung.scale = 0.001 * (side * side - 2) * 9.81 * 0.1 * (side - 1);
  for (std::size_t i = 0; i < hung.result.trajectory.t.size(); ++i) {
    State state = start;
    state.x = hung.result.trajectory.x[i];
    state.v = hung.result.trajectory.v[i];
    hung.end = system->totalEnergy(state) - system->totalEnergy(start);
    hung.highest = std::max(hung.highest, hung.end);
  }
  return hung;
}

/// Past the lowest point of the fall, where the springs are pulled hardest [s].
constexpr double duration = 0.7;

/// |R(i h omega)| of TR-BDF2.
double shrinking(double z) {
  const double d = 1.0 - std::sqrt(0.5);
  return std::hypot(1.0, (1.0 - 2.0 * d) * z) / (1.0 + d * d * z * z);
}

long long solverWork(const Work& work) { return work.factorisations + work.solves; }

/// h omega of the shortest waves is 180 at k = 1e4 and 5800 at k = 1e7. Every run has to finish without a step taken in
/// pieces, and may only lose energy: more than 5 % of S either way would be a failure. What it loses is what the fall
/// puts into the fast waves, of which the stability function leaves next to nothing a step: printed beside it.
class StiffCloth : public ::testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(Stiffness, StiffCloth, ::testing::Values(1e4, 1e5, 1e6, 1e7),
                         [](const auto& test) { return "1e" + std::to_string(std::lround(std::log10(test.param))); });

TEST_P(StiffCloth, NeverGainsEnergyAndCostsNoMoreThanThreeTimesBdf2) {
  const double k = GetParam();
  const double fastest = std::sqrt(12.0 * k / 0.001) / 60.0;
  const auto twoStep = bdf2();
  const Hung other = hang(*twoStep, 12, k, 0.0, duration);
  for (const double d : {0.0, 0.01}) {
    const auto method = trBdf2();
    const Hung hung = hang(*method, 12, k, d, duration);
    fmt::print(
        "k = {:.0e} N/m, d = {} kg/s: energy {:.4f} S at the end (bdf2 undamped {:.4f} S); |R| = {:.9f} at "
        "h omega = 0.055 (the fall), {:.1e} at {:.0f}; factorisations + solves {} ({})\n",
        k, d, hung.end / hung.scale, other.end / other.scale, shrinking(3.3 / 60.0), shrinking(fastest), fastest,
        solverWork(hung.result.work), solverWork(other.result.work));
    EXPECT_FALSE(hung.result.failed()) << hung.result.trajectory.stop.message;
    EXPECT_EQ(hung.result.work.rejectedSteps, 0);
    EXPECT_LT(hung.highest, 1e-9 * hung.scale);
    EXPECT_GT(hung.end, -0.05 * hung.scale);
    EXPECT_LE(solverWork(hung.result.work), 3 * solverWork(other.result.work));
  }
}

/// Hard case H16's stiff variants.
TEST(StiffVariantsOfH16, NeverGainEnergy) {
  for (const double k : {1e4, 1e5, 1e6}) {
    const auto method = trBdf2();
    const Hung hung = hang(*method, 10, k, 0.01, duration);
    EXPECT_FALSE(hung.result.failed()) << hung.result.trajectory.stop.message;
    EXPECT_LT(hung.highest, 1e-9 * hung.scale) << k;
  }
}

}  // namespace
}  // namespace muelle::engine
