// loses: BallEnough, BallGood, BallBest; misconception: asked_for_ever
#include "challenge.h"

#include <Eigen/SparseCholesky>

namespace {

/// Dormand-Prince 5(4) with a step that is chosen by the estimated error.
VecX dormandPrince(const Force& force, const VecX& m, const VecX& x0, const VecX& v0, double T, double tolerance) {
  static const double c[7] = {0, 0.2, 0.3, 0.8, 8.0 / 9, 1, 1};
  static const double a[7][6] = {{0},
                                 {0.2},
                                 {3.0 / 40, 9.0 / 40},
                                 {44.0 / 45, -56.0 / 15, 32.0 / 9},
                                 {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
                                 {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656},
                                 {35.0 / 384, 0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84}};
  static const double e[7] = {71.0 / 57600, 0, -71.0 / 16695, 71.0 / 1920, -17253.0 / 339200, 22.0 / 525, -1.0 / 40};
  VecX x = x0, v = v0;
  VecX kx[7], kv[7];
  double t = 0, h = T / 300;
  kx[0] = v;
  kv[0] = force(t, x, v).cwiseQuotient(m);
  while (t < T - 1e-12) {
    h = std::min(h, T - t);
    VecX xs, vs, ex = h * e[0] * kx[0], ev = h * e[0] * kv[0];
    for (int s = 1; s < 7; ++s) {
      xs = x;
      vs = v;
      for (int j = 0; j < s; ++j) {
        xs += h * a[s][j] * kx[j];
        vs += h * a[s][j] * kv[j];
      }
      kx[s] = vs;
      kv[s] = force(t + c[s] * h, xs, vs).cwiseQuotient(m);
      ex += h * e[s] * kx[s];
      ev += h * e[s] * kv[s];
    }
    const double error = std::max(ex.cwiseAbs().maxCoeff(), 0.05 * ev.cwiseAbs().maxCoeff()) / tolerance;
    if (error <= 1) {
      t += h;
      x = xs;
      v = vs;
      kx[0] = kx[6];
      kv[0] = kv[6];
    }
    h *= std::min(5.0, std::max(0.2, 0.9 * std::pow(error + 1e-8, -0.2)));
  }
  return x;
}

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
  return dormandPrince(force, m, x0, v0, ballDuration, 1e-17);
}
