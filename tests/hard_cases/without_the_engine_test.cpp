/// \file
/// What the cases warn of, shown on recurrences written here: none of these runs a line of the engine, and none counts
/// as a test of it (acceptance_test.cpp).

#include "lab/hard_cases/references.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace muelle::hard_cases {
namespace {

// What single precision does to the same recurrence, in full.
TEST(WithoutTheEngine, H01SinglePrecisionLosesThePhase) {
  float x = 1.0F, v = 0.0F;
  const float h = 0.1F;
  for (int n = 0; n < 62831853; ++n) {
    v -= 0.5F * h * x;
    x += h * v;
    v -= 0.5F * h * x;
  }
  EXPECT_NEAR(0.5 * (x * x + v * v), 0.4994, 2e-3);
  EXPECT_GT(std::abs(x - reference("H01", "VV.x")), 1e-3);
}

// Implicit midpoint with its matrix computed once turns by a matrix whose determinant is not 1.
TEST(WithoutTheEngine, H01NaiveMidpointCoefficientsDrift) {
  const double q = 0.1 * 0.1 / 4.0, c = (1.0 - q) / (1.0 + q), s = 0.1 / (1.0 + q);
  double x = 1.0, v = 0.0;
  for (int n = 0; n < 62831853; ++n) {
    const double next = c * x + s * v;
    v = c * v - s * x;
    x = next;
  }
  EXPECT_GT(std::abs(0.5 * (x * x + v * v) - 0.5), 1e-10);
}

// The closed form with distinct roots is 0/0 at critical damping.
TEST(WithoutTheEngine, H02FormulaOfDistinctRootsFailsAtCriticalDamping) {
  const double root = std::sqrt(20.0 * 20.0 / 4.0 - 100.0), a = -10.0 + root, b = -10.0 - root;
  EXPECT_TRUE(std::isnan((a * std::exp(b) - b * std::exp(a)) / (a - b)));
}

// Velocity Verlet with the drag force taken at the old velocity.
TEST(WithoutTheEngine, H23VerletWithLaggedDragFailsAtItsLimit) {
  const auto lagged = [](double h, int steps) {
    double x = 0.0, v = 1.0, a = -x - 1e4 * v;
    for (int n = 0; n < steps; ++n) {
      x += h * v + 0.5 * h * h * a;
      const double next = -x - 1e4 * (v + 0.5 * h * a);
      v += 0.5 * h * (a + next);
      a = next;
    }
    return x;
  };
  EXPECT_FALSE(std::abs(lagged(2.5e-4, 4000)) < 1.0);
  EXPECT_GT(std::abs(lagged(0.5e-4, 20000) / reference("H23", "drag.x(1)") - 1.0), 0.03);
}

// Friction as a smooth function of the speed creeps, Coulomb's law by sign(v) chatters.
TEST(WithoutTheEngine, H20RegularisedFrictionCreepsAndSignChatters) {
  const double angle = 26.5 * std::numbers::pi / 180.0, g = 9.81, h = 1e-3;
  double x = 0.0, v = 0.0;
  for (int n = 0; n < 10000; ++n) {
    v += h * (g * std::sin(angle) - 0.5 * g * std::cos(angle) * std::tanh(v / 1e-3));
    x += h * v;
  }
  EXPECT_GT(x, 1e-3);
  double speed = 3.0, least = 3.0;
  for (int n = 0; n < 1000; ++n) {
    speed -= h * 0.5 * g * (speed > 0.0 ? 1.0 : speed < 0.0 ? -1.0 : 0.0);
    least = std::min(least, speed);
  }
  EXPECT_LT(least, -1e-4) << "reverses";
}

}  // namespace
}  // namespace muelle::hard_cases
