#include "engine/integrators/implicit/methods.h"
#include "support/linear_system.h"

#include <gtest/gtest.h>
#include <cmath>
#include <Eigen/Dense>
#include <memory>

namespace muelle::engine {
namespace {

using testing::LinearSystem;
using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

/// A small chain with unequal masses, node damping and spring damping.
LinearSystem chain() {
  const Vector mass{{1.0, 0.5, 2.0}};
  const Matrix K{{300.0, -100.0, 0.0}, {-100.0, 150.0, -50.0}, {0.0, -50.0, 50.0}};
  const Matrix D{{0.9, -0.3, 0.0}, {-0.3, 0.5, -0.1}, {0.0, -0.1, 0.2}};
  return {mass, K, D};
}

State start(const std::vector<double>& x, const std::vector<double>& v) {
  State state;
  state.x = x;
  state.v = v;
  return state;
}

State run(const System& system, Method& method, State state, double h, int steps) {
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

/// y' = A y of the chain, y = (x, v).
Matrix firstOrder() {
  const Vector mass{{1.0, 0.5, 2.0}};
  const Matrix K{{300.0, -100.0, 0.0}, {-100.0, 150.0, -50.0}, {0.0, -50.0, 50.0}};
  const Matrix D{{0.9, -0.3, 0.0}, {-0.3, 0.5, -0.1}, {0.0, -0.1, 0.2}};
  Matrix A = Matrix::Zero(6, 6);
  A.topRightCorner(3, 3).setIdentity();
  A.bottomLeftCorner(3, 3) = -(mass.cwiseInverse().asDiagonal() * K);
  A.bottomRightCorner(3, 3) = -(mass.cwiseInverse().asDiagonal() * D);
  return A;
}

Vector packed(const State& s) {
  Vector y(s.x.size() + s.v.size());
  for (std::size_t i = 0; i < s.x.size(); ++i) {
    y[static_cast<Eigen::Index>(i)] = s.x[i];
    y[static_cast<Eigen::Index>(s.x.size() + i)] = s.v[i];
  }
  return y;
}

const Vector y0{{0.1, -0.2, 0.3, 1.0, 0.0, -2.0}};
State chainStart() { return start({0.1, -0.2, 0.3}, {1.0, 0.0, -2.0}); }

/// y_n of a one-step method with stability function N(hA)^-1 P(hA).
Vector recurrence(const Matrix& denominator, const Matrix& numerator, int steps) {
  const Eigen::FullPivLU<Matrix> lu(denominator);
  Vector y = y0;
  for (int i = 0; i < steps; ++i) y = lu.solve(numerator * y);
  return y;
}

TEST(Recurrence, BackwardEulerIsItsStabilityFunction) {
  const Matrix I = Matrix::Identity(6, 6), hA = 0.05 * firstOrder();
  const LinearSystem system = chain();
  const Vector y = packed(run(system, *backwardEuler(), chainStart(), 0.05, 10));
  EXPECT_LT((y - recurrence(I - hA, I, 10)).norm(), 1e-14);
}

TEST(Recurrence, ImplicitMidpointIsItsStabilityFunction) {
  const Matrix I = Matrix::Identity(6, 6), hA = 0.05 * firstOrder();
  const LinearSystem system = chain();
  const Vector y = packed(run(system, *implicitMidpoint(), chainStart(), 0.05, 50));
  EXPECT_LT((y - recurrence(I - 0.5 * hA, I + 0.5 * hA, 50)).norm(), 2e-13);
}

}  // namespace
}  // namespace muelle::engine
