// loses: BallEnough, BallGood, BallBest; misconception: too_inexact or draught_left_out
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
  VecX x = x0, v = v0;
  for (int i = 0; i < n; ++i) {
    const double t = (i + 0.5) * h;
    const VecX start = x + h / 2 * v;
    VecX q = start;
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
  // a few questions, and the rest by myself
  const double M = m[0];
  const VecX still = VecX::Zero(3);
  const double g = -force(0, x0, still)[2] / M;
  const VecX below = muelle::Vec3(0, 0, -0.01);
  const double k = (force(0, below, still)[2] + M * g) / std::pow(0.01, 1.5), c = 0.02, drag = 0.002;
  muelle::Vec3 x = x0, v = v0;
  const int n = 300000;
  const double h = ballDuration / n;
  for (int i = 0; i < n; ++i) {
    muelle::Vec3 F = -drag * v.norm() * v - muelle::Vec3(0, 0, M * g);
    if (x[2] < 0) F[2] += k * std::pow(-x[2], 1.5) * std::max(0.0, 1 - c * v[2]);
    v += h / M * F;
    x += h * v;
  }
  return x;
}
