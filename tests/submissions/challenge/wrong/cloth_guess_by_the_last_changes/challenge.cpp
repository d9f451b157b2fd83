// loses: ClothEnough, ClothGood, ClothBest; misconception: no_number
// Guesses the next middle by how the last two changes of the velocity go, which are both 0 at first.
#include "challenge.h"

#include <Eigen/SparseCholesky>

namespace {

struct Motion {
  VecX x, v;
};

/// Runge-Kutta 4
void step(const Force& force, const VecX& m, double t, double h, Motion& s) {
  auto a = [&](double time, const VecX& x, const VecX& v) { return VecX(force(time, x, v).cwiseQuotient(m)); };
  const VecX v1 = s.v, a1 = a(t, s.x, v1);
  const VecX v2 = s.v + h / 2 * a1, a2 = a(t + h / 2, s.x + h / 2 * v1, v2);
  const VecX v3 = s.v + h / 2 * a2, a3 = a(t + h / 2, s.x + h / 2 * v2, v3);
  const VecX v4 = s.v + h * a3, a4 = a(t + h, s.x + h * v3, v4);
  s.x += h / 6 * (v1 + 2 * v2 + 2 * v3 + v4);
  s.v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
}

}  // namespace

VecX squeezedRabbit(const Force& force, const VecX& m, const VecX& x0, const VecX& v0) {
  Motion s{x0, v0};
  const int n = 120;
  for (int i = 0; i < n; ++i) step(force, m, i * rabbitDuration / n, rabbitDuration / n, s);
  return s.x;
}

VecX stiffCloth(const Force& force, const Hessian& hessian, const VecX& m, const VecX& x0, const VecX& v0) {
  const int n = 80;
  const double h = clothDuration / n;
  VecX x = x0, v = v0, before = v0;
  double last = 0;
  for (int i = 0; i < n; ++i) {
    const double t = (i + 0.5) * h;
    const VecX start = x + h / 2 * v;
    const VecX change = v - before;
    VecX q = start + h / 4 * (change.norm() / last) * change;
    last = change.norm();
    before = v;
    for (int turn = 0; turn < 1; ++turn) {
      Eigen::SparseMatrix<double> A = h * h / 4 * hessian(t, q);
      A.diagonal() += m;
      const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(A);
      const VecX rest = m.cwiseProduct(q - start) - h * h / 4 * force(t, q, v);
      q -= solver.solve(rest);
    }
    const VecX end = 2 * q - x;
    v = 2 / h * (end - x) - v;
    x = end;
  }
  return x;
}

VecX bouncingBall(const Force& force, const VecX& m, const VecX& x0, const VecX& v0) {
  Motion s{x0, v0};
  double t = 0;
  while (t < ballDuration - 1e-12) {
    double h = 4e-4;
    if (s.x[2] > 0) {
      // when it would be at the ground, without air
      const double fall = (s.v[2] + std::sqrt(s.v[2] * s.v[2] + 2 * 9.81 * s.x[2])) / 9.81;
      h = std::min(0.05, std::max(4e-4, fall - 4e-4));
    }
    h = std::min(h, ballDuration - t);
    step(force, m, t, h, s);
    t += h;
  }
  return s.x;
}
