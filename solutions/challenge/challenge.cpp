#include "challenge.h"

#include <Eigen/SparseCholesky>

// The rabbit moves smoothly, and much is asked of its digits: a method of high order.
// The cloth is stiff, but what is stiff in it hardly moves: an implicit method, with long steps.
// The ball flies, and hits: long steps and short ones.

namespace {

struct Motion {
  VecX x, v;
};

/// One step of Runge-Kutta 4.
void rungeKuttaStep(const Force& force, const VecX& m, double t, double h, Motion& now) {
  const auto a = [&](double time, const VecX& x, const VecX& v) { return VecX(force(time, x, v).cwiseQuotient(m)); };
  const VecX v1 = now.v, a1 = a(t, now.x, v1);
  const VecX v2 = now.v + h / 2 * a1, a2 = a(t + h / 2, now.x + h / 2 * v1, v2);
  const VecX v3 = now.v + h / 2 * a2, a3 = a(t + h / 2, now.x + h / 2 * v2, v3);
  const VecX v4 = now.v + h * a3, a4 = a(t + h, now.x + h * v3, v4);
  now.x += h / 6 * (v1 + 2 * v2 + 2 * v3 + v4);
  now.v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
}

}  // namespace

VecX squeezedRabbit(const Force& force, const VecX& m, const VecX& x0, const VecX& v0) {
  constexpr int steps = 120;
  constexpr double h = rabbitDuration / steps;
  Motion now{x0, v0};
  for (int i = 0; i < steps; ++i) rungeKuttaStep(force, m, i * h, h, now);
  return now.x;
}

// Implicit midpoint: the middle q = x + h/2 v + h^2/4 F(q)/m is found by one step of Newton from x + h/2 v.
VecX stiffCloth(const Force& force, const Hessian& hessian, const VecX& m, const VecX& x0, const VecX& v0) {
  constexpr int steps = 80;
  constexpr double h = clothDuration / steps;
  Motion now{x0, v0};
  for (int i = 0; i < steps; ++i) {
    const double t = i * h + h / 2;
    const VecX guess = now.x + h / 2 * now.v;
    Eigen::SparseMatrix<double> A = h * h / 4 * hessian(t, guess);
    A.diagonal() += m;
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(A);
    const VecX middle = guess + solver.solve(h * h / 4 * force(t, guess, now.v));
    const VecX x1 = 2 * middle - now.x;
    now.v = 2 / h * (x1 - now.x) - now.v;
    now.x = x1;
  }
  return now.x;
}

// Long steps in the air, which end just above the ground; short ones in it.
VecX bouncingBall(const Force& force, const VecX& m, const VecX& x0, const VecX& v0) {
  constexpr double g = 9.81, flying = 0.05, touching = 4e-4;
  Motion now{x0, v0};
  double t = 0;
  while (t < ballDuration - 1e-12) {
    double h = touching;
    if (now.x[2] > 0) {
      const double fall = (now.v[2] + std::sqrt(now.v[2] * now.v[2] + 2 * g * now.x[2])) / g;
      h = std::clamp(fall - touching, touching, flying);
    }
    h = std::min(h, ballDuration - t);
    rungeKuttaStep(force, m, t, h, now);
    t += h;
  }
  return now.x;
}
