#include "engine/integrators/implicit/methods.h"
#include "engine/integrators/position_based/methods.h"
#include "support/linear_system.h"
#include "support/spring_network.h"

#include <gtest/gtest.h>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace muelle::engine {
namespace {

using testing::LinearSystem;
using testing::SpringNetwork;
using Vector = Eigen::VectorXd;

State start(std::vector<double> x) {
  State state;
  state.v.assign(x.size(), 0.0);
  state.x = std::move(x);
  return state;
}

State run(const DynamicalSystem& system, Integrator& method, State state, double h, int steps) {
  method.prepare(system, {});
  State next = state;
  for (int i = 0; i < steps; ++i) {
    const StepResult result = method.step(system, state, h, next);
    EXPECT_TRUE(result.done) << result.failure;
    method.accept();
    std::swap(state, next);
  }
  return state;
}

/// A mass m = 2 on a spring in 1D with gravity and damping: at rest it hangs at -(L0 + m g / k).
SpringNetwork hangingSpring() {
  return {1, {2.0}, {{.k = 50.0, .L0 = 1.0, .damping = 4.0}}, Vector::Constant(1, -9.81)};
}

/// Three masses of 0.5 on springs from the origin, in the plane.
SpringNetwork chain(double damping) {
  std::vector<SpringNetwork::Spring> springs;
  for (int i = 0; i < 3; ++i) springs.push_back({.a = i, .b = i - 1, .k = 200.0, .L0 = 0.5, .damping = damping});
  return {2, {0.5, 0.5, 0.5}, springs, Vector{{0.0, -9.81}}, damping};
}
const std::vector<double> slantedChain = {0.3, -0.4, 0.6, -0.8, 0.9, -1.2};

/// One constraint and one unknown: the projection solves backward Euler's equation exactly.
TEST(Xpbd, OfOneSpringIsBackwardEulerOfTheSubstep) {
  const SpringNetwork system = hangingSpring();
  const auto projected = xpbd(4), euler = backwardEuler();
  const State a = run(system, *projected, start({-1.2}), 0.04, 25);
  const State b = run(system, *euler, start({-1.2}), 0.01, 100);
  EXPECT_NEAR(a.x[0], b.x[0], 1e-12);
  EXPECT_NEAR(a.v[0], b.v[0], 1e-11);
}

TEST(Xpbd, ComesToRestWhereAHangingSpringDoes) {
  const SpringNetwork system = hangingSpring();
  const auto method = xpbd();
  const State end = run(system, *method, start({-1.2}), 0.05, 1000);
  EXPECT_NEAR(end.x[0], -(1.0 + 2.0 * 9.81 / 50.0), 1e-10);
}

/// The one sweep errs on a chain of three springs: at rest by less the more substeps there are (first order in the
/// substep squared, the size of h^2 k / m), and in motion at first order.
TEST(Xpbd, ErrorFallsWithTheSubsteps) {
  const SpringNetwork system = chain(1.0);
  double error[2];
  for (int i = 0; i < 2; ++i) {
    const auto method = xpbd(50 << i);
    const State end = run(system, *method, start(slantedChain), 0.05, 20);
    const State exact = run(system, *implicitMidpoint(), start(slantedChain), 2e-4, 5000);
    error[i] = std::hypot(end.x[4] - exact.x[4], end.x[5] - exact.x[5]);
  }
  EXPECT_NEAR(std::log2(error[0] / error[1]), 1.0, 0.15);
}

TEST(ProjectiveDynamics, ConvergedIsBackwardEuler) {
  const SpringNetwork system = chain(0.0);
  const auto method = projectiveDynamics(3000);
  const State a = run(system, *method, start(slantedChain), 0.02, 10);
  const State b = run(system, *backwardEuler(), start(slantedChain), 0.02, 10);
  for (std::size_t i = 0; i < a.x.size(); ++i) EXPECT_NEAR(a.x[i], b.x[i], 1e-9);
}

TEST(ProjectiveDynamics, ErrsWhenStoppedEarly) {
  const SpringNetwork system = chain(0.0);
  const State exact = run(system, *backwardEuler(), start(slantedChain), 0.02, 20);
  double before = 1e9;
  for (const int iterations : {1, 4, 16, 64}) {
    const auto method = projectiveDynamics(iterations);
    const State end = run(system, *method, start(slantedChain), 0.02, 20);
    const double error = std::hypot(end.x[4] - exact.x[4], end.x[5] - exact.x[5]);
    EXPECT_LT(error, 0.5 * before) << iterations;
    before = error;
  }
}

/// 1D: the direction of a spring does not turn, so that one iteration solves the step.
TEST(ProjectiveDynamics, ComesToRestWhereAHangingSpringDoes) {
  const SpringNetwork system = hangingSpring();
  const auto method = projectiveDynamics(1);
  const State end = run(system, *method, start({-1.2}), 0.05, 1000);
  EXPECT_NEAR(end.x[0], -(1.0 + 2.0 * 9.81 / 50.0), 1e-10);
}

TEST(ProjectiveDynamics, FactorisesOncePerStepSize) {
  const SpringNetwork system = chain(1.0);
  const auto method = projectiveDynamics(5);
  method->prepare(system, {});
  State state = start(slantedChain), next = state;
  for (const double h : {0.01, 0.01, 0.01, 0.02, 0.02}) {
    ASSERT_TRUE(method->step(system, state, h, next).done);
    std::swap(state, next);
  }
  EXPECT_EQ(method->work().factorisations, 2);
  EXPECT_EQ(method->work().solves, 25);
}

TEST(PositionBased, NamesWhatItCannotDo) {
  SpringNetwork system = chain(0.0);
  system.notCovered = "friction of 'ground'";
  for (const auto& make : {+[] { return xpbd(); }, +[] { return projectiveDynamics(); }}) {
    const auto method = make();
    try {
      method->prepare(system, {});
      ADD_FAILURE() << method->info().id << " took a system whose friction it leaves out";
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find("friction of 'ground'"), std::string::npos) << error.what();
    }
    EXPECT_THROW(method->prepare(LinearSystem(1.0, 0.0), {}), std::invalid_argument);
  }
  EXPECT_THROW(xpbd(0), std::invalid_argument);
  EXPECT_THROW(projectiveDynamics(0), std::invalid_argument);
}

}  // namespace
}  // namespace muelle::engine
