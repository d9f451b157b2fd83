/// \file
/// Model::precision: what is computed in single precision, and what never is.

#include "engine/control/simulate.h"
#include "engine/integrators/catalogue.h"
#include "engine/model/model_system.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace muelle::engine::testing {
namespace {

constexpr int side = 24;

/// A waved cloth of 24 by 24 nodes, held at two corners, `from` the origin. \param hole without the nodes of a square
Model cloth(kernels::Precision precision, const Vec3& from = Vec3::Zero(), bool hole = false) {
  Model model;
  model.precision = precision;
  model.gravity = {0, 0, -9.81};
  std::vector<int> number(side * side, -1);
  for (int i = 0; i < side; ++i) {
    for (int j = 0; j < side; ++j) {
      if (hole && i > 8 && i < 16 && j > 8 && j < 16) continue;
      number[static_cast<std::size_t>(i * side + j)] = static_cast<int>(model.nodes.size());
      ModelNode node = {
          .x = from + Vec3(i / 32.0, j / 32.0, std::round(1024.0 * std::sin(0.5 * i + 0.3 * j)) / 65536.0),
          .v = Vec3(0.25 * (i % 5), 0.125 * (j % 3), 0.0),
          .m = 0.001};
      node.pinned = i == 0 && (j == 0 || j == side - 1);
      node.drag = 0.001;
      model.nodes.push_back(node);
    }
  }
  for (int i = 0; i < side; ++i) {
    for (int j = 0; j < side; ++j) {
      for (const auto& [down, right] : {std::pair(1, 0), {0, 1}, {1, 1}, {1, -1}}) {
        if (i + down >= side || j + right >= side || j + right < 0) continue;
        const int a = number[static_cast<std::size_t>(i * side + j)];
        const int b = number[static_cast<std::size_t>((i + down) * side + j + right)];
        if (a < 0 || b < 0) continue;
        const double L0 = (down * right == 0 ? 1.0 : std::sqrt(2.0)) / 32.0;
        model.springs.push_back({.a = a, .b = b, .k = 100.0, .L0 = L0, .dProjected = 0.01});
      }
    }
  }
  return model;
}

std::vector<double> accelerations(const ModelSystem& system) {
  const State s = system.initialState();
  std::vector<double> a(s.x.size());
  system.acceleration(s.t, s.x, s.v, s.z, a);
  return a;
}

double largest(const std::vector<double>& values) {
  double most = 0.0;
  for (const double value : values) most = std::max(most, std::fabs(value));
  return most;
}

/// Beside a rounding of 32 u of k (L + |L0 - L|) <= 2 k L0 for each of 8 springs of a node, u = 2^-24: the rest of
/// singleBounds() (engine/kernels) is smaller.
constexpr double rounding = 8 * 32 * 6e-8 * 2 * 100.0 / 32.0 / 0.001;

void expectClose(const std::vector<double>& single, const std::vector<double>& full) {
  ASSERT_EQ(single.size(), full.size());
  double off = 0.0;
  for (std::size_t i = 0; i < full.size(); ++i) off = std::max(off, std::fabs(single[i] - full[i]));
  EXPECT_LE(off, rounding);
  EXPECT_LE(off, 1e-5 * largest(full));
  EXPECT_GT(off, 0.0) << "these are doubles";
}

TEST(SinglePrecision, IsOfAccelerationsOnAGridAlone) {
  const auto full = build(cloth(kernels::Precision::Double)), single = build(cloth(kernels::Precision::Single));
  EXPECT_TRUE(single->mayBeSingle());
  expectClose(accelerations(*single), accelerations(*full));
  const State s = full->initialState();
  std::vector<double> of(s.x.size()), ofSingle(s.x.size());
  full->force(s.t, s.x, s.v, s.z, of);
  single->force(s.t, s.x, s.v, s.z, ofSingle);
  EXPECT_EQ(of, ofSingle);
  EXPECT_EQ(full->totalEnergy(s), single->totalEnergy(s));
  EXPECT_GT(single->accelerationRounding(), full->accelerationRounding());
}

TEST(SinglePrecision, DoesNotMindHolesFarFromTheOrigin) {
  const Vec3 away(65536.0, -32768.0, 16384.0);
  for (const bool hole : {false, true}) {
    const auto full = build(cloth(kernels::Precision::Double, away, hole));
    const auto single = build(cloth(kernels::Precision::Single, away, hole));
    ASSERT_TRUE(single->mayBeSingle());
    expectClose(accelerations(*single), accelerations(*full));
  }
}

TEST(SinglePrecision, DecidesNothingWhereSpringsAreNoGrid) {
  Model model = cloth(kernels::Precision::Single);
  for (std::size_t i = 0; i < 400; ++i) {  // more loose ends than a grid may have
    model.springs.push_back({.a = static_cast<int>(i), .b = static_cast<int>((i * 37 + 5) % 576), .k = 1.0, .L0 = 0.1});
    if (model.springs.back().a == model.springs.back().b) model.springs.pop_back();
  }
  const auto single = build(model);
  model.precision = kernels::Precision::Double;
  const auto full = build(model);
  EXPECT_FALSE(single->mayBeSingle());
  EXPECT_EQ(accelerations(*single), accelerations(*full));
}

class SinglePrecisionRun : public ::testing::TestWithParam<std::string> {};

TEST_P(SinglePrecisionRun, EndsWhereDoubleDoesButForSomeMillionths) {
  std::vector<State> ends;
  for (const auto precision : {kernels::Precision::Double, kernels::Precision::Single}) {
    const auto system = build(cloth(precision));
    RunOptions options;
    options.duration = 0.25;
    options.h = 5e-4;
    options.fixedStep = true;
    const auto method = makeMethod(GetParam());
    const RunResult run = simulate(*system, *method, system->initialState(), options);
    ASSERT_FALSE(run.failed()) << run.trajectory.stop.message;
    ends.push_back(run.last);
  }
  double off = 0.0;
  for (std::size_t i = 0; i < ends[0].x.size(); ++i) off = std::max(off, std::fabs(ends[0].x[i] - ends[1].x[i]));
  // Accelerations differ by 1e-5 of their largest at most, some 5 m/s^2 where all fall: t^2 / 2 of that is 3e-6 m, of a
  // way of 0.1 m; modes of the cloth do not amplify it in a quarter of a second.
  EXPECT_LE(off, 3e-6);
  EXPECT_GT(off, 0.0);
}

INSTANTIATE_TEST_SUITE_P(Method, SinglePrecisionRun,
                         ::testing::Values("velocity_verlet", "runge_kutta_4", "symplectic_euler", "rkc2"),
                         [](const auto& method) { return method.param; });

}  // namespace
}  // namespace muelle::engine::testing
