/// \file
/// The methods against their own discrete recurrences on the oscillator, to round-off.

#include "engine/integrators/explicit/methods.h"
#include "support/linear_system.h"

#include <gtest/gtest.h>
#include <cmath>
#include <complex>

namespace muelle::engine {
namespace {

using testing::LinearSystem;

State oscillator(double x, double v) { return {.t = 0.0, .x = {x}, .v = {v}, .z = {}}; }

State run(Integrator& method, const DynamicalSystem& system, State state, double h, int steps) {
  method.prepare(system, {});
  State next;
  for (int n = 0; n < steps; ++n) {
    const StepResult result = method.step(system, state, h, next);
    if (!result.done) ADD_FAILURE() << result.failure;
    method.accept();
    std::swap(state, next);
  }
  return state;
}

// H03: x_{n+1} = (2 - z^2) x_n - x_{n-1} with z = omega h, after 1000 steps.
TEST(Recurrence, SymplecticEulerAtItsLimit) {
  const LinearSystem system(100.0, 0.0);
  const auto at = [&](double z) { return run(*symplecticEuler(), system, oscillator(1.0, 0.0), z / 100.0, 1000).x[0]; };
  EXPECT_NEAR(at(1.99), -7.70721327191765753, 1e-9 * 7.7);
  EXPECT_NEAR(at(2.0), 2001.0, 1e-9 * 2001.0);
  EXPECT_NEAR(at(2.01) / 3.66931515866879167849e+87, 1.0, 1e-9);
}

TEST(Recurrence, VelocityVerletAtItsLimit) {
  const LinearSystem system(100.0, 0.0);
  const auto at = [&](double z) { return run(*velocityVerlet(), system, oscillator(1.0, 0.0), z / 100.0, 1000).x[0]; };
  EXPECT_NEAR(at(1.99), 0.558265503053201851, 1e-9 * 0.56);
  EXPECT_NEAR(at(2.0), 1.0, 1e-9);
  EXPECT_NEAR(at(2.01) / 3.32441958958355195812e+86, 1.0, 1e-9);
}

// x_N = cos(N theta), cos theta = 1 - h^2/2; the conserved energy is v^2/2 + (1 - h^2/4) x^2/2 (H01).
TEST(Recurrence, VelocityVerletTurnsByItsOwnAngle) {
  const LinearSystem system(1.0, 0.0);
  const double h = 0.1, theta = std::acos(1.0 - h * h / 2.0);
  const State end = run(*velocityVerlet(), system, oscillator(1.0, 0.0), h, 10000);
  EXPECT_NEAR(end.x[0], std::cos(10000 * theta), 1e-11);
  EXPECT_NEAR(0.5 * end.v[0] * end.v[0] + 0.5 * (1.0 - h * h / 4.0) * end.x[0] * end.x[0], 0.49875, 1e-12);
}

// On x' = v, v' = -x the state x - i v turns and shrinks as R(i h)^N.
TEST(Recurrence, RungeKuttaFollowsItsStabilityFunction) {
  using Complex = std::complex<double>;
  struct Case {
    std::unique_ptr<Integrator> method;
    Complex (*R)(Complex);
  };
  Case cases[] = {
      {explicitEuler(), [](Complex z) { return 1.0 + z; }},
      {explicitMidpoint(), [](Complex z) { return 1.0 + z + z * z / 2.0; }},
      {rungeKutta4(), [](Complex z) { return 1.0 + z * (1.0 + z / 2.0 * (1.0 + z / 3.0 * (1.0 + z / 4.0))); }},
      {dormandPrince5(),
       [](Complex z) {
         return 1.0 + z * (1.0 + z / 2.0 * (1.0 + z / 3.0 * (1.0 + z / 4.0 * (1.0 + z / 5.0 * (1.0 + z / 5.0)))));
       }},
  };
  const LinearSystem system(1.0, 0.0);
  for (const Case& c : cases) {
    const State end = run(*c.method, system, oscillator(1.0, 0.0), 0.1, 100);
    const Complex expected = std::pow(c.R(Complex(0.0, -0.1)), 100);
    EXPECT_NEAR(end.x[0], expected.real(), 1e-13) << c.method->info().name;
    EXPECT_NEAR(end.v[0], expected.imag(), 1e-13) << c.method->info().name;
  }
}

}  // namespace
}  // namespace muelle::engine
