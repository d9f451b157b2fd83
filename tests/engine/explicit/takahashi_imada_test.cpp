/// \file
/// Takahashi-Imada on x'' = -sin x: what the states outside keep over long times.

#include "engine/integrators/explicit/methods.h"

#include <gtest/gtest.h>
#include <array>
#include <cmath>

namespace muelle::engine {
namespace {

class Swing : public DynamicalSystem {
 public:
  int size() const override { return 1; }
  std::span<const double> mass() const override { return mass_; }
  bool forceUsesVelocity() const override { return false; }
  void force(double, In x, In, In, Out f) const override { f[0] = -std::sin(x[0]); }

 private:
  std::array<double, 1> mass_{1.0};
};

double energyOf(const State& state) { return 0.5 * state.v[0] * state.v[0] - std::cos(state.x[0]); }

template <typename Look>
State swing(Integrator& method, State state, double h, int steps, Look look) {
  const Swing system;
  method.prepare(system, {});
  State next;
  for (int n = 0; n < steps; ++n) {
    EXPECT_TRUE(method.step(system, state, h, next).done);
    method.accept();
    std::swap(state, next);
    look(state);
  }
  return state;
}

const State swingStart{.t = 0.0, .x = {1.0}, .v = {0.2}, .z = {}};

// The map inside is reversible, so the energy stays in a band; outside too, where it is one of h^4. 1e4 periods of 6.7
// s.
TEST(TakahashiImada, KeepsTheEnergyInABandOverTenThousandPeriods) {
  const auto method = takahashiImada();
  const double first = energyOf(swingStart);
  double early = 0.0, late = 0.0;
  int n = 0;
  constexpr int steps = 220'000;
  swing(*method, swingStart, 0.3, steps, [&](const State& state) {
    double& largest = ++n <= steps / 10 ? early : late;
    largest = std::max(largest, std::abs(energyOf(state) - first));
  });
  EXPECT_LT(late, 1.01 * early + 1e-15 * std::sqrt(steps));
  EXPECT_LT(early, 0.3 * 0.3 * 0.3 * 0.3 / 12.0);
}

// Forth, turned and back: the way out is known to h^4 only in v, so the way back meets the start to that order.
TEST(TakahashiImada, ComesBackToItsStartToFourthOrder) {
  const auto miss = [](double h, int steps) {
    const auto method = takahashiImada();
    State turned = swing(*method, swingStart, h, steps, [](const State&) {});
    turned.v[0] = -turned.v[0];
    const State end = swing(*method, turned, h, steps, [](const State&) {});
    return std::hypot(end.x[0] - swingStart.x[0], end.v[0] + swingStart.v[0]);
  };
  const double coarse = miss(0.1, 100), fine = miss(0.05, 200);
  EXPECT_LT(coarse, 1e-4);
  EXPECT_GT(std::log2(coarse / fine), 3.5);
}

// A change of the step starts it anew, and costs no order: steps of two lengths in turns.
TEST(TakahashiImada, TakesStepsOfOtherLengths) {
  const auto error = [](double h) {
    const Swing system;
    const auto method = takahashiImada(), exact = nystrom12();
    method->prepare(system, {});
    exact->prepare(system, {});
    State state = swingStart, reference = swingStart, next;
    for (double t = 0.0; t < 3.0 - 1e-9; t += 2.5 * h) {
      for (const double length : {h, 1.5 * h}) {
        method->step(system, state, length, next);
        method->accept();
        std::swap(state, next);
        exact->step(system, reference, length, next);
        exact->accept();
        std::swap(reference, next);
      }
    }
    return std::hypot(state.x[0] - reference.x[0], state.v[0] - reference.v[0]);
  };
  EXPECT_NEAR(std::log2(error(0.06) / error(0.03)), 4.0, 0.4);
}

}  // namespace
}  // namespace muelle::engine
