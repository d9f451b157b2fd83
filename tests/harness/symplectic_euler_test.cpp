#include "test_systems.h"

#include <gtest/gtest.h>
#include <cmath>
#include <limits>

namespace muelle {
namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

/// Error in (x, v) of the unit oscillator after one second, started at x = 1, v = 0.
double errorAfterOneSecond(double h) {
  const State end = run(oscillator(1.0), {0.0, {1.0}, {0.0}, {}}, {.h = h, .duration = 1.0}).last();
  return std::hypot(end.x[0] - std::cos(1.0), end.v[0] + std::sin(1.0));
}

TEST(SymplecticEuler, HasOrderOne) {
  double sumLogH = 0, sumLogE = 0, sumHH = 0, sumHE = 0;
  int n = 0;
  for (double h = 1.0 / 32; h > 1.0 / 2000; h /= 2, ++n) {
    const double x = std::log(h);
    const double y = std::log(errorAfterOneSecond(h));
    sumLogH += x;
    sumLogE += y;
    sumHH += x * x;
    sumHE += x * y;
  }
  const double slope = (n * sumHE - sumLogH * sumLogE) / (n * sumHH - sumLogH * sumLogH);
  // error = C1 h + C2 h^2 with |C2| <= |C1|: over h <= 1/32 the slope is off by at most h C2 / C1, 0.03.
  EXPECT_NEAR(slope, 1.0, 0.03);
}

// The step is a linear map with eigenvalues exp(+-i theta), sin(theta / 2) = h w / 2: the recurrence in closed form.
TEST(SymplecticEuler, FollowsItsRecurrenceOnAnOscillator) {
  const double w = 3.0, h = 0.01, x0 = 0.7, v0 = -0.4;
  const int steps = 10000;
  const Trajectory path = run(oscillator(w), {0.0, {x0}, {v0}, {}}, {.h = h, .duration = steps * h});
  ASSERT_EQ(path.t.size(), static_cast<std::size_t>(steps) + 1);
  const double theta = 2.0 * std::asin(0.5 * h * w);
  const double x1 = x0 + h * (v0 - h * w * w * x0);
  const double sine = (x1 - x0 * std::cos(theta)) / std::sin(theta);
  // Each step rounds a few times; errors of the map add up linearly in n, those of n theta as n theta eps.
  const double tolerance = 20.0 * steps * eps;
  for (int n = 0; n <= steps; n += 97) {
    const double expected = x0 * std::cos(n * theta) + sine * std::sin(n * theta);
    EXPECT_NEAR(path.x[static_cast<std::size_t>(n)][0], expected, tolerance) << "step " << n;
  }
}

// v^2 + w^2 x^2 - h w^2 x v is exactly invariant under the step (insert and expand); the energy itself only swings.
TEST(SymplecticEuler, ConservesTheModifiedEnergyOverManySteps) {
  const double w = 2.0, h = 0.05;
  const auto modified = [&](const State& s) {
    return s.v[0] * s.v[0] + w * w * s.x[0] * s.x[0] - h * w * w * s.x[0] * s.v[0];
  };
  const double steps = 1e5;
  const MarchOptions options{
      .h = h, .duration = steps * h, .outputEvery = 10, .probes = {{"modified energy", "J", modified}}};
  const Trajectory path = run(oscillator(w), {0.0, {1.0}, {0.3}, {}}, options);
  const std::vector<double>& energy = path.track("modified energy");
  // About six roundings a step, each at most eps relative to the energy, in the worst case all of one sign.
  const double tolerance = 6.0 * steps * eps * energy.front();
  for (const double value : energy) ASSERT_NEAR(value, energy.front(), tolerance);
}

TEST(SymplecticEuler, FollowsTheRecurrenceOfAProjectile) {
  const Vec3 g(0, 0, -9.81), x0(1, 2, 3), v0(4, -5, 6);
  const double m = 2.5, h = 0.01;
  const int steps = 500;
  const State start{0.0, {x0[0], x0[1], x0[2]}, {v0[0], v0[1], v0[2]}, {}};
  const Trajectory path = run(projectile(m, m * g), start, {.h = h, .duration = steps * h});
  for (int n = 0; n <= steps; n += 50) {
    const auto row = static_cast<std::size_t>(n);
    const Vec3 v = v0 + n * h * g;
    const Vec3 x = x0 + n * h * v0 + 0.5 * n * (n + 1) * h * h * g;
    // Sums of n terms of at most 150 m: n roundings of 150 eps each.
    const double tolerance = 4.0 * 150.0 * steps * eps;
    EXPECT_LT((node3(In(path.x[row]), 0) - x).norm(), tolerance) << "step " << n;
    EXPECT_LT((node3(In(path.v[row]), 0) - v).norm(), tolerance) << "step " << n;
  }
}

TEST(SymplecticEuler, ConservesTheMomentaOfAFreePair) {
  const double ma = 0.5, mb = 2.0;
  // A central force, any at all: it grows with the cube of the distance.
  const FunctionSystem pair({ma, ma, ma, mb, mb, mb}, [](double, In x, In, Out f) {
    const Vec3 r = node3(x, 0) - node3(x, 1);
    node3(f, 0) = -r * r.squaredNorm();
    node3(f, 1) = r * r.squaredNorm();
  });
  MarchOptions options{.h = 1e-3, .duration = 10.0};
  for (int axis = 0; axis < 3; ++axis) options.probes.push_back(linearMomentum(pair, axis));
  for (int axis = 0; axis < 3; ++axis) options.probes.push_back(angularMomentum(pair, axis));
  const Trajectory path = run(pair, {0.0, {1, 0, 0, -0.3, 0.2, 0.1}, {0, 1, 0.5, 0.1, -0.2, 0}, {}}, options);
  ASSERT_FALSE(path.stop.stopped);
  EXPECT_GT(std::abs(path.x.back()[0] - path.x.front()[0]), 0.01);  // something moved
  // Numbers of size 10 at most, a few roundings in each of 1e4 steps.
  const double tolerance = 10.0 * 1e4 * 10.0 * eps;
  for (const Track& track : path.tracks) {
    for (const double value : track.values) ASSERT_NEAR(value, track.values.front(), tolerance) << track.name;
  }
}

TEST(SymplecticEuler, KeepsInternalVariablesAndAdvancesTime) {
  const FunctionSystem system = oscillator(1.0);
  const State from{2.0, {1.0}, {0.0}, {7.0, 8.0}};
  State to = from;
  to.z = {0.0, 0.0};
  symplecticEulerStep(system, from, 0.25, to);
  EXPECT_EQ(to.z, from.z);
  EXPECT_DOUBLE_EQ(to.t, 2.25);
}

}  // namespace
}  // namespace muelle
