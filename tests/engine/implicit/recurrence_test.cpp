#include "engine/integrators/implicit/methods.h"
#include "engine/solve/dense.h"
#include "run.h"
#include "support/linear_system.h"

#include <algorithm>
#include <cmath>

namespace muelle::engine {
namespace {

using testing::LinearSystem;
using testing::run;
using testing::start;
using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

const Vector mass{{1.0, 0.5, 2.0}};
const Matrix K{{300.0, -100.0, 0.0}, {-100.0, 150.0, -50.0}, {0.0, -50.0, 50.0}};
const Matrix D{{0.9, -0.3, 0.0}, {-0.3, 0.5, -0.1}, {0.0, -0.1, 0.2}};
const Vector y0{{0.1, -0.2, 0.3, 1.0, 0.0, -2.0}};

/// A small chain with unequal masses, node damping and spring damping.
LinearSystem chain() { return {mass, K, D}; }
State chainStart() { return start({0.1, -0.2, 0.3}, {1.0, 0.0, -2.0}); }

/// h A of the chain written as y' = A y, y = (x, v).
Matrix firstOrder(double h) {
  Matrix A = Matrix::Zero(6, 6);
  A.topRightCorner(3, 3).setIdentity();
  A.bottomLeftCorner(3, 3) = -(mass.cwiseInverse().asDiagonal() * K);
  A.bottomRightCorner(3, 3) = -(mass.cwiseInverse().asDiagonal() * D);
  return h * A;
}

Vector packed(const State& s) {
  Vector y(6);
  for (int i = 0; i < 3; ++i) {
    y[i] = s.x[static_cast<std::size_t>(i)];
    y[3 + i] = s.v[static_cast<std::size_t>(i)];
  }
  return y;
}

/// y after `steps` of a one-step method with stability function denominator^-1 numerator.
Vector recurrence(const Matrix& denominator, const Matrix& numerator, int steps) {
  Vector y = y0;
  for (int i = 0; i < steps; ++i) y = solveFullPivoting(denominator, numerator * y);
  return y;
}

const Matrix I = Matrix::Identity(6, 6);

TEST(Recurrence, BackwardEulerIsItsStabilityFunction) {
  const LinearSystem system = chain();
  const Vector y = packed(run(system, *backwardEuler(), chainStart(), 0.05, 10));
  EXPECT_LT((y - recurrence(I - firstOrder(0.05), I, 10)).norm(), 1e-14);
}

TEST(Recurrence, LinearisedBackwardEulerIsBackwardEulerOnALinearSystem) {
  const LinearSystem system = chain();
  const Vector y = packed(run(system, *linearisedBackwardEuler(), chainStart(), 0.05, 10));
  EXPECT_LT((y - recurrence(I - firstOrder(0.05), I, 10)).norm(), 1e-14);
}

TEST(Recurrence, ImplicitMidpointAndDiscreteGradientAreTheTrapezoidalStabilityFunction) {
  const LinearSystem system = chain();
  const Matrix hA = firstOrder(0.05);
  const Vector expected = recurrence(I - 0.5 * hA, I + 0.5 * hA, 50);
  for (const auto make : {implicitMidpoint, discreteGradient}) {
    const auto method = make();
    EXPECT_LT((packed(run(system, *method, chainStart(), 0.05, 50)) - expected).norm(), 2e-13) << method->info().id;
  }
}

/// SDIRK2 of Alexander, then BDF2 with the coefficients of the step ratio.
TEST(Recurrence, Bdf2FollowsItsFormulaWithChangingSteps) {
  const LinearSystem system = chain();
  const auto method = bdf2();
  method->prepare(system, {});
  State state = chainStart(), next = state;
  Vector before = y0, now = y0;
  double last = 0.0;
  for (const double h : {0.05, 0.05, 0.08, 0.02, 0.03}) {
    ASSERT_TRUE(method->step(system, state, h, next).done);
    method->accept();
    std::swap(state, next);
    const Matrix hA = firstOrder(h);
    Vector y;
    if (last == 0.0) {
      const double gamma = 1.0 - std::sqrt(0.5);
      const Matrix stage = I - gamma * hA;
      const Vector slope = hA * solveFullPivoting(stage, now);
      y = solveFullPivoting(stage, now + (1.0 - gamma) * slope);
    } else {
      const double r = h / last;
      const Vector known = now * ((1.0 + r) * (1.0 + r) / (1.0 + 2.0 * r)) - before * (r * r / (1.0 + 2.0 * r));
      y = solveFullPivoting(I - (1.0 + r) / (1.0 + 2.0 * r) * hA, known);
    }
    before = now;
    now = y;
    last = h;
    EXPECT_LT((packed(state) - y).norm(), 1e-14) << "h = " << h;
  }
}

/// The trapezoidal rule to 2 d h and BDF2 over both parts, with changing steps; d = 1 - 1/sqrt(2).
TEST(Recurrence, TrBdf2IsItsStabilityFunction) {
  const LinearSystem system = chain();
  const auto method = trBdf2();
  method->prepare(system, {});
  State state = chainStart(), next = state;
  const double d = 1.0 - std::sqrt(0.5);
  Vector y = y0;
  for (const double h : {0.05, 0.05, 0.08, 0.02, 0.03}) {
    ASSERT_TRUE(method->step(system, state, h, next).done);
    method->accept();
    std::swap(state, next);
    const Matrix hA = firstOrder(h), stage = I - d * hA;
    y = solveFullPivoting(stage * stage, y + (1.0 - 2.0 * d) * (hA * y));
    EXPECT_LT((packed(state) - y).norm(), 1e-14) << "h = " << h;
  }
}

/// R(z) = P(z) / (1 - z/4)^5 with P of degree 4, since the method is of order 4 and R(inf) = 0: P's coefficients are
/// those of exp(z) (1 - z/4)^5 up to z^4.
TEST(Recurrence, Esdirk4IsItsStabilityFunction) {
  const LinearSystem system = chain();
  double numerator[5], factorial = 1.0;
  const double power[5] = {1.0, -5.0 / 4, 10.0 / 16, -10.0 / 64, 5.0 / 256};  // of (1 - z/4)^5
  for (double& c : numerator) c = 0.0;
  for (int i = 0; i < 5; ++i) {
    factorial *= i > 0 ? i : 1;
    for (int j = 0; i + j < 5; ++j) numerator[i + j] += power[j] / factorial;
  }
  const Matrix hA = firstOrder(0.05), stage = I - 0.25 * hA;
  Matrix P = numerator[4] * I, Q = I;
  for (int i = 3; i >= 0; --i) P = Matrix(P * hA) + numerator[i] * I;
  for (int i = 0; i < 5; ++i) Q = Matrix(Q * stage);
  // Five solves a step, each with some ulp of the stages, which are up to 10 times as large as the state.
  EXPECT_LT((packed(run(system, *esdirk4(), chainStart(), 0.05, 10)) - recurrence(Q, P, 10)).norm(), 1e-13);
}

/// What the controller is told falls with h^order, whatever the power of the estimate itself; at fast modes it does not
/// grow with the stiffness.
TEST(ErrorEstimate, FallsWithTheOrderAndStaysBoundedAtFastModes) {
  Tolerance same;  // for all unknowns
  same.relative = 0.0;
  same.relative = 1.0;
  const auto estimate = [&same](Integrator& method, const DynamicalSystem& system, const State& from, double h) {
    State to = from;
    method.prepare(system, same);
    return method.step(system, from, h, to).error;
  };
  for (const auto make : {trBdf2, esdirk4}) {
    const auto method = make();
    const LinearSystem system = chain();
    // At h omega = 0.03 the next term is some per cent of the first.
    const double coarse = estimate(*method, system, chainStart(), 1e-3);
    const double fine = estimate(*method, system, chainStart(), 5e-4);
    EXPECT_NEAR(std::log2(coarse / fine), method->info().order, 0.15) << method->info().id;
    // Unfiltered, the estimate of a mode grows with h omega: here 100 times.
    const double stiff = estimate(*method, LinearSystem(1e4, 0.0), start({1e-2}, {1.0}), 1.0);
    const double stiffer = estimate(*method, LinearSystem(1e8, 0.0), start({1e-4}, {1.0}), 1.0);
    EXPECT_LT(stiffer, 2.0 * stiff) << method->info().id;
  }
}

/// A step that is taken again with a smaller h must not leave the rejected one in the memory.
TEST(Recurrence, ARejectedStepLeavesNoTrace) {
  const LinearSystem system = chain();
  for (const auto make : {bdf2, trBdf2, esdirk4}) {
    const auto straight = make(), disturbed = make();
    straight->prepare(system, {});
    disturbed->prepare(system, {});
    State a = chainStart(), b = a, next = a;
    for (int i = 0; i < 4; ++i) {
      ASSERT_TRUE(straight->step(system, a, 0.03, next).done);
      straight->accept();
      std::swap(a, next);
      ASSERT_TRUE(disturbed->step(system, b, 0.06, next).done);
      ASSERT_TRUE(disturbed->step(system, b, 0.03, next).done);
      disturbed->accept();
      std::swap(b, next);
    }
    EXPECT_EQ(a.x, b.x) << straight->info().id;
    EXPECT_EQ(a.v, b.v) << straight->info().id;
  }
}

/// h omega = 1e4 and h d / m = 1e6: no method of this family may grow; the L-stable ones let the fast modes die.
TEST(Stability, HoldsForEveryStep) {
  const LinearSystem stiff(Vector::Ones(2), Matrix{{1e8, 0.0}, {0.0, 1.0}}, Matrix{{1e4, 0.0}, {0.0, 1e6}});
  for (const auto make :
       {backwardEuler, linearisedBackwardEuler, bdf2, trBdf2, esdirk4, implicitMidpoint, discreteGradient}) {
    const auto method = make();
    const State end = run(stiff, *method, start({1.0, 1.0}, {1.0, 1.0}), 1.0, 100);
    EXPECT_LE(std::abs(end.x[0]), 1.001) << method->info().id;
    EXPECT_LE(std::abs(end.x[1]), 1.6) << method->info().id;
    if (method->info().stability == Stability::LStable) {
      EXPECT_LT(std::abs(end.x[0]), 1e-12) << method->info().id;
      EXPECT_LT(std::abs(end.v[1]), 1e-5) << method->info().id;
    }
  }
}

/// Reference case H23: node drag d = 1e4 on m = 1, k = 1 (closed form of the two exponentials).
TEST(Stability, StiffDragIsExactForLStableMethods) {
  const LinearSystem drag(1.0, 1e4);
  const double exact = 9.99900024996834137392e-5;
  for (const auto make : {backwardEuler, bdf2, trBdf2, esdirk4}) {
    const auto method = make();
    const State end = run(drag, *method, start({0.0}, {1.0}), 1.0 / 60.0, 60);
    EXPECT_NEAR(end.x[0], exact, 1e-9 * exact) << method->info().id;
  }
}

/// Implicit midpoint on the oscillator of H01: solved for the increment, the energy has no drift. 1e5 steps of unbiased
/// round-off are 1e-16 sqrt(1e5) = 4e-14.
TEST(Energy, OfImplicitMidpointHasNoBiasedRoundOff) {
  const LinearSystem oscillator(1.0, 0.0);
  const State end = run(oscillator, *implicitMidpoint(), start({1.0}, {0.0}), 0.1, 100000);
  EXPECT_NEAR(0.5 * (end.x[0] * end.x[0] + end.v[0] * end.v[0]), 0.5, 1e-13);
  const double angle = 1e5 * 2.0 * std::atan(0.05);
  EXPECT_NEAR(end.x[0], std::cos(angle), 1e-10);
}

// The cubic of both ends' positions and velocities lies within max |x| + 4/27 (|h v0| + |h v1|), the largest values of
// its basis; forces would come in times (h omega)^2 = 250,000.
TEST(Interpolant, OfAStepOverManyPeriodsStaysNearItsEnds) {
  const LinearSystem system(1.0, 0.0);
  const double h = 500.0;
  for (const auto make : {backwardEuler, linearisedBackwardEuler, bdf2, trBdf2}) {
    const auto method = make();
    method->prepare(system, {});
    const State from = start({1.0}, {0.001});
    State to, inside;
    ASSERT_TRUE(method->step(system, from, h, to).done);
    const double bound =
        std::max(std::abs(from.x[0]), std::abs(to.x[0])) + 4.0 / 27.0 * h * (std::abs(from.v[0]) + std::abs(to.v[0]));
    const long long before = method->work().forceEvaluations;
    for (const double theta : {0.0, 0.1, 0.3, 0.5, 0.8, 1.0}) {
      method->interpolate(system, from, to, theta, inside);
      EXPECT_LE(std::abs(inside.x[0]), bound) << method->info().id << ' ' << theta;
    }
    EXPECT_NEAR(inside.x[0], to.x[0], 1e-15 * bound);
    EXPECT_NEAR(inside.v[0], to.v[0], 1e-15 * bound);
    EXPECT_EQ(method->work().forceEvaluations, before);
  }
}

}  // namespace
}  // namespace muelle::engine
