#include "course/testing/expect.h"
#include "course/testing/test_function.h"
#include "time_integration.h"

#include <gtest/gtest.h>

// One coordinate of 2 kg, at t = 1 s at x = 1 m with v = 3 m/s, and steps of 0.5 s, under a force that depends on all:
// at the beginning it is 8 - 4 - 6 = -2 N, so a = -1 m/s^2.

namespace {

using muelle::TestFunction;

const TestFunction<VecX(double, const VecX&, const VecX&)> force(
    "[](double t, const VecX& x, const VecX& v) { return VecX(8 * t - 4 * x.array() - 2 * v.array()); }",
    [](double t, const VecX& x, const VecX& v) { return VecX(8 * t - 4 * x.array() - 2 * v.array()); });

// The same without its damper: at the beginning 8 - 4 = 4 N, so a = 2 m/s^2.
const TestFunction<VecX(double, const VecX&)> positionForce(
    "[](double t, const VecX& x) { return VecX(8 * t - 4 * x.array()); }",
    [](double t, const VecX& x) { return VecX(8 * t - 4 * x.array()); });

const VecX m{{2}};
const State start{1, VecX{{1}}, VecX{{3}}};
constexpr double h = 0.5;

void expectState(const State& state, double x, double v) {
  {
    MUELLE_LABEL("time at the end of the step", "s");
    EXPECT_NUMBER_NEAR(state.t, 1.5, 1e-12);
  }
  {
    MUELLE_LABEL("position at the end of the step", "m");
    EXPECT_VECTOR_NEAR(state.x, (VecX{{x}}), 1e-12);
  }
  MUELLE_LABEL("velocity at the end of the step", "m/s");
  EXPECT_VECTOR_NEAR(state.v, (VecX{{v}}), 1e-12);
}

TEST(ExplicitEuler, GoesOnAsAtTheBeginning) {
  MUELLE_PROPERTY("v = 3 and a = -1 hold for the whole step of 0.5 s: x = 1 + 1.5, v = 3 - 0.5");
  expectState(submission::explicitEulerStep(force, m, start, h), 2.5, 2.5);
}

TEST(Midpoint, GoesOnAsAtTheMiddle) {
  MUELLE_PROPERTY(
      "half a step leads to t = 1.25, x = 1.75, v = 2.75, where a = -1.25; these hold for the whole step from the "
      "beginning: x = 1 + 0.5 2.75, v = 3 - 0.5 1.25");
  expectState(submission::midpointStep(force, m, start, h), 2.375, 2.375);
}

TEST(Verlet, TakesTheMeanOfBothEnds) {
  MUELLE_PROPERTY(
      "a = 2 leads to x = 1 + 1.5 + 0.25, where at t = 1.5 the force is 1 N and a = 0.5; v = 3 + 0.5 times the mean");
  expectState(submission::verletStep(positionForce, m, start, h), 2.75, 3.625);
}

TEST(RungeKutta, TakesTheMeanOfFour) {
  MUELLE_PROPERTY(
      "velocities 3, 2.75, 2.6875, 2.46875 and accelerations -1, -1.25, -1.0625, -1.15625: the mean of each");
  expectState(submission::rungeKuttaStep(force, m, start, h), 1 + 16.34375 / 12, 3 - 6.78125 / 12);
}

/// How often `step` asks the function of the test.
template <class Function, class Step>
double questions(const Function& function, const Step& step) {
  function.forgetCalls();
  step();
  return static_cast<double>(function.calls());
}

TEST(Evaluations, AreCounted) {
  MUELLE_PROPERTY(
      "the force is asked once by explicit Euler, twice by midpoint and by Verlet, four times by Runge-Kutta");
  {
    MUELLE_LABEL("how often explicitEulerStep asks for the force");
    EXPECT_NUMBER_NEAR(questions(force, [] { submission::explicitEulerStep(force, m, start, h); }), 1, 0);
  }
  {
    MUELLE_LABEL("how often midpointStep asks for the force");
    EXPECT_NUMBER_NEAR(questions(force, [] { submission::midpointStep(force, m, start, h); }), 2, 0);
  }
  {
    MUELLE_LABEL("how often verletStep asks for the force");
    EXPECT_NUMBER_NEAR(questions(positionForce, [] { submission::verletStep(positionForce, m, start, h); }), 2, 0);
  }
  MUELLE_LABEL("how often rungeKuttaStep asks for the force");
  EXPECT_NUMBER_NEAR(questions(force, [] { submission::rungeKuttaStep(force, m, start, h); }), 4, 0);
}

}  // namespace
