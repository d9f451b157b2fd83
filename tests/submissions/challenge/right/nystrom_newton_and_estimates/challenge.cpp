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

}  // namespace

VecX squeezedRabbit(const Force& force, const VecX& m, const VecX& x0, const VecX& v0) {
  // Nystrom: three questions a step, order four
  const int n = 115;
  const double h = rabbitDuration / n;
  VecX x = x0, v = v0;
  for (int i = 0; i < n; ++i) {
    const double t = i * h;
    const VecX a1 = force(t, x, v).cwiseQuotient(m);
    const VecX a2 = force(t + h / 2, x + h / 2 * v + h * h / 8 * a1, v).cwiseQuotient(m);
    const VecX a3 = force(t + h, x + h * v + h * h / 2 * a2, v).cwiseQuotient(m);
    x += h * v + h * h / 6 * (a1 + 2 * a2);
    v += h / 6 * (a1 + 4 * a2 + a3);
  }
  return x;
}

VecX stiffCloth(const Force& force, const Hessian& hessian, const VecX& m, const VecX& x0, const VecX& v0) {
  const int n = 60;
  const double h = clothDuration / n;
  VecX x = x0, v = v0;
  for (int i = 0; i < n; ++i) {
    const double t = (i + 0.5) * h;
    const VecX start = x + h / 2 * v;
    VecX q = start;
    for (int turn = 0; turn < 2; ++turn) {
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
  return dormandPrince(force, m, x0, v0, ballDuration, 1e-7);
}
