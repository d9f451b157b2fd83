#include "lab/hard_cases/linear_theory.h"

#include "engine/solve/dense.h"

#include <array>
#include <cmath>
#include <Eigen/LU>
#include <functional>
#include <limits>
#include <span>

namespace muelle::hard_cases {

namespace {

using Matrix = Eigen::Matrix2d;
using Eigen::Vector2d;

/// (x, v)' = L (x, v).
Matrix generator(const Mode& m) {
  Matrix L;
  L << 0.0, 1.0, -m.stiffness, -(m.damping + m.drag);
  return L;
}

/// The truncated exponential series of Z up to `order`.
Matrix series(const Matrix& Z, int order) {
  Matrix sum = Matrix::Identity();
  for (int j = order; j >= 1; --j) sum = Matrix::Identity() + Z * sum / j;
  return sum;
}

/// exp(Z) by scaling and squaring.
Matrix exponential(const Matrix& Z) {
  const int halvings = std::max(0, static_cast<int>(std::ceil(std::log2(Z.cwiseAbs().maxCoeff() + 1e-300))) + 4);
  Matrix result = series(Z * std::ldexp(1.0, -halvings), 14);
  for (int i = 0; i < halvings; ++i) result = result * result;
  return result;
}

/// The matrix of a linear map, column by column.
Matrix matrixOf(const std::function<Vector2d(Vector2d)>& map) {
  Matrix result;
  result << map(Vector2d(1, 0)), map(Vector2d(0, 1));
  return result;
}

/// Velocity Verlet with the drag exact and the damping at the predicted velocity; h may be negative.
Matrix verlet(const Mode& m, double h) {
  const double c = h * m.drag;
  const double decay = std::exp(-c);
  const double phi1 = std::abs(c) < 1e-8 ? 1.0 - 0.5 * c : -std::expm1(-c) / c;
  const double phi2 = std::abs(c) < 1e-4 ? 0.5 - c / 6.0 + c * c / 24.0 : (1.0 - phi1) / c;
  return matrixOf([=](Vector2d y) -> Vector2d {
    const double a0 = -m.stiffness * y[0] - m.damping * y[1];
    const double x = y[0] + h * phi1 * y[1] + h * h * phi2 * a0;
    const double predicted = decay * y[1] + h * phi1 * a0;
    const double a1 = -m.stiffness * x - m.damping * predicted;
    return {x, decay * y[1] + h * ((phi1 - phi2) * a0 + phi2 * a1)};
  });
}

Matrix symplecticEuler(const Mode& m, double h) {
  return matrixOf([=](Vector2d y) -> Vector2d {
    const double v = y[1] + h * (-m.stiffness * y[0] - (m.damping + m.drag) * y[1]);
    return {y[0] + h * v, v};
  });
}

Matrix composed(const Mode& m, double h, std::span<const double> fractions) {
  Matrix result = Matrix::Identity();
  for (const double fraction : fractions) result = verlet(m, fraction * h) * result;
  return result;
}

Matrix yoshida4(const Mode& m, double h) {
  const double w = 1.0 / (2.0 - std::cbrt(2.0));
  return composed(m, h, std::array{w, 1.0 - 2.0 * w, w});
}

/// Kahan and Li 1997, order 8 with 17 stages.
Matrix kahanLi8(const Mode& m, double h) {
  constexpr double g[] = {0.13020248308889008088, 0.56116298177510838456,  -0.38947496264484728641,
                          0.15884190655515560090, -0.39590389413323757734, 0.18453964097831570709,
                          0.25837438768632204729, 0.29501172360931029887,  -0.60550853383003451170};
  std::array<double, 17> all;
  for (std::size_t j = 0; j < 17; ++j) all[j] = g[j < 9 ? j : 16 - j];
  return composed(m, h, all);
}

Matrix backwardEuler(const Matrix& Z) { return (Matrix::Identity() - Z).inverse(); }
Matrix midpoint(const Matrix& Z) { return (Matrix::Identity() - 0.5 * Z).inverse() * (Matrix::Identity() + 0.5 * Z); }

template <class Square>
Square power(Square base, long long n) {
  Square result = Square::Identity(base.rows(), base.cols());
  for (; n > 0; n /= 2) {
    if (n % 2 == 1) result = base * result;
    base = base * base;
  }
  return result;
}

double growthOf(const Eigen::MatrixXd& M) {
  if (!M.allFinite()) return std::numeric_limits<double>::infinity();
  return engine::spectralRadius(M);
}

/// BDF2 on (y_n, y_{n-1}), the first step by Alexander's SDIRK of two stages.
struct TwoStep {
  Eigen::Matrix4d step;
  Matrix first;
};
TwoStep bdf2(const Matrix& Z) {
  const Matrix I = Matrix::Identity(), solve = (I - 2.0 / 3.0 * Z).inverse();
  TwoStep result;
  result.step << 4.0 / 3.0 * solve, -1.0 / 3.0 * solve, I, Matrix::Zero();
  const double gamma = 1.0 - std::sqrt(0.5);
  const Matrix stage = (I - gamma * Z).inverse();
  result.first = stage * (I + (1.0 - gamma) * Z * stage);
  return result;
}

std::optional<Matrix> stepMatrix(const std::string& id, const Mode& m, double h) {
  const Matrix Z = h * generator(m);
  if (id == "explicit_euler") return series(Z, 1);
  if (id == "explicit_midpoint") return series(Z, 2);
  if (id == "runge_kutta_4") return series(Z, 4);
  if (id == "symplectic_euler") return symplecticEuler(m, h);
  if (id == "velocity_verlet" || id == "rattle") return verlet(m, h);
  if (id == "yoshida4") return yoshida4(m, h);
  if (id == "kahan_li_8") return kahanLi8(m, h);
  if (id == "backward_euler" || id == "linearised_backward_euler" || id == "projective_dynamics") {
    return backwardEuler(Z);
  }
  if (id == "newmark" || id == "implicit_midpoint" || id == "discrete_gradient") return midpoint(Z);
  if (id == "xpbd") return power(backwardEuler(Z / 20.0), 20);  // its substeps
  return std::nullopt;
}

/// Distance in the mode's plane [m]: velocities over omega.
double sizeOf(const Mode& mode, const Vector2d& y) {
  return std::hypot(y[0], y[1] / std::sqrt(std::max(std::abs(mode.stiffness), 1e-300)));
}

}  // namespace

double exactSize(const Mode& mode, double duration) {
  const double T = mode.duration > 0.0 ? mode.duration : duration;
  return sizeOf(mode, exponential(T * generator(mode)) * Vector2d(mode.amplitude, mode.speed));
}

std::optional<ModeForecast> forecast(const engine::MethodInfo& method, const Mode& mode, double h, double duration) {
  const double T = mode.duration > 0.0 ? mode.duration : duration;
  const auto steps = static_cast<long long>(std::ceil(T / h - 1e-9));
  h = T / static_cast<double>(steps);  // the last step is cut
  const Vector2d start(mode.amplitude, mode.speed);
  Vector2d end;
  ModeForecast result;
  if (method.id == "bdf2") {
    const TwoStep two = bdf2(h * generator(mode));
    Eigen::Vector4d pair;
    pair << two.first * start, start;
    end = (power(two.step, steps - 1) * pair).head<2>();
    result.growth = growthOf(two.step);
  } else {
    const std::optional<Matrix> step = stepMatrix(method.id, mode, h);
    if (!step) return std::nullopt;
    end = power(*step, steps) * start;
    result.growth = growthOf(*step);
  }
  const Vector2d exact = exponential(T * generator(mode)) * start;
  result.error = std::abs(mode.stiffness) > 0.0 ? sizeOf(mode, end - exact) : std::abs(end[0] - exact[0]);
  result.size = sizeOf(mode, end);
  result.sizeError = std::abs(result.size - sizeOf(mode, exact));
  if (!std::isfinite(result.error))
    result.error = result.size = result.sizeError = std::numeric_limits<double>::infinity();
  return result;
}

}  // namespace muelle::hard_cases
