// loses: BallBest; misconception: asked_too_often
#include "challenge.h"

#include <Eigen/SparseCholesky>

// The steps of rabbit and ball are made twice: once as a whole, once in two halves. How far they differ tells the error,
// which is taken off.

namespace {

struct State {
  VecX x, v;
};

State operator+(const State& a, const State& b) { return {a.x + b.x, a.v + b.v}; }
State operator-(const State& a, const State& b) { return {a.x - b.x, a.v - b.v}; }
State operator*(double factor, const State& a) { return {factor * a.x, factor * a.v}; }

class System {
 public:
  System(const Force& force, const VecX& m) : force_(force), m_(m) {}

  State slope(double t, const State& y) const { return {y.v, force_(t, y.x, y.v).cwiseQuotient(m_)}; }

  /// Runge-Kutta 4, with the slope at the beginning, which the whole step and its first half have in common.
  State step(double t, double h, const State& y, const State& k1) const {
    const State k2 = slope(t + h / 2, y + h / 2 * k1);
    const State k3 = slope(t + h / 2, y + h / 2 * k2);
    const State k4 = slope(t + h, y + h * k3);
    return y + h / 6 * (k1 + 2 * (k2 + k3) + k4);
  }

  /// The end of a step, and by how much its halves differ from the whole: in metres, and in hundredths of a metre
  /// per second.
  std::pair<State, double> doubled(double t, double h, const State& y) const {
    const State k1 = slope(t, y);
    const State whole = step(t, h, y, k1);
    const State half = step(t, h / 2, y, k1);
    const State halves = step(t + h / 2, h / 2, half, slope(t + h / 2, half));
    const State difference = halves - whole;
    const double off = std::max(difference.x.cwiseAbs().maxCoeff(), 0.01 * difference.v.cwiseAbs().maxCoeff());
    return {halves + 1.0 / 15 * difference, off};
  }

 private:
  const Force& force_;
  const VecX& m_;
};

}  // namespace

VecX squeezedRabbit(const Force& force, const VecX& m, const VecX& x0, const VecX& v0) {
  const System system(force, m);
  const int steps = 44;
  const double h = rabbitDuration / steps;
  State y{x0, v0};
  for (int i = 0; i < steps; ++i) y = system.doubled(i * h, h, y).first;
  return y.x;
}

VecX stiffCloth(const Force& force, const Hessian& hessian, const VecX& m, const VecX& x0, const VecX& v0) {
  // Not doubled: taking off the error would let the threads swing higher with every step.
  const int steps = 80;
  const double h = clothDuration / steps;
  State y{x0, v0};
  for (int i = 0; i < steps; ++i) {
    const double t = (i + 0.5) * h;
    const VecX q = y.x + h / 2 * y.v;
    Eigen::SparseMatrix<double> A = hessian(t, q) * (h * h / 4);
    A.diagonal() += m;
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(A);
    const VecX middle = q + solver.solve(force(t, q, y.v) * (h * h / 4));
    y = {2 * middle - y.x, 4 / h * (middle - y.x) - y.v};
  }
  return y.x;
}

VecX bouncingBall(const Force& force, const VecX& m, const VecX& x0, const VecX& v0) {
  const System system(force, m);
  constexpr double tolerance = 2e-6, longest = 0.05;  // a longer step may jump over the ground
  State y{x0, v0};
  double t = 0, h = 0.01;
  while (t < ballDuration - 1e-12) {
    h = std::min(h, ballDuration - t);
    const auto [end, difference] = system.doubled(t, h, y);
    const double ratio = difference / tolerance;
    if (ratio <= 1) {
      t += h;
      y = end;
    }
    h = std::min(longest, h * std::clamp(0.9 * std::pow(std::max(ratio, 1e-8), -0.2), 0.2, 4.0));
  }
  return y.x;
}
