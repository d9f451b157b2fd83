#include "challenge.h"

#include <Eigen/SparseCholesky>

VecX squeezedRabbit(const Force& force, const VecX& m, const VecX& x0, const VecX& v0) {
  // Blanes and Moan: kicks and drifts with unequal parts, order four
  const double b[7] = {0.0829844064174052,  0.396309801498368, -0.0390563049223486, 1 - 2 * 0.4402379029934246,
                       -0.0390563049223486, 0.396309801498368, 0.0829844064174052};
  const double a3 = 0.5 - 0.245298957184271 - 0.604872665711080;
  const double a[6] = {0.245298957184271, 0.604872665711080, a3, a3, 0.604872665711080, 0.245298957184271};
  const int n = 40;
  const double h = rabbitDuration / n;
  VecX x = x0, v = v0;
  double t = 0;
  VecX F = force(t, x, v);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < 6; ++j) {
      v += h * b[j] * F.cwiseQuotient(m);
      x += h * a[j] * v;
      t += h * a[j];
      F = force(t, x, v);
    }
    v += h * b[6] * F.cwiseQuotient(m);
  }
  return x;
}

VecX stiffCloth(const Force& force, const Hessian& hessian, const VecX& m, const VecX& x0, const VecX& v0) {
  const int n = 105;
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
  // Verlet with steps by the place, tiny ones in the ground
  VecX x = x0, v = v0, a = force(0, x, v).cwiseQuotient(m);
  double t = 0;
  while (ballDuration - t > 1e-12) {
    double h = 6e-5;
    if (x[2] > 0) {
      const double fall = (v[2] + std::sqrt(v[2] * v[2] + 2 * 9.81 * x[2])) / 9.81;
      h = std::min(0.01, std::max(6e-5, fall - 1e-4));
    }
    h = std::min(h, ballDuration - t);
    x += h * v + h * h / 2 * a;
    t += h;
    const VecX guess = v + h * a;
    VecX next = force(t, x, guess).cwiseQuotient(m);
    v += h / 2 * (a + next);
    a = next;
  }
  return x;
}
