// loses: BallEnough, BallGood, BallBest; misconception: no_number
// The time to the ground as the root of v^2 - 2 g z, with the wrong sign under it, chooses the steps.
#include "challenge.h"

#include <Eigen/Sparse>

namespace {

struct Motion {
  double t;
  VecX x, v;
};

void rungeKutta(const Force& force, const VecX& m, Motion& s, double h) {
  const VecX xa = s.v;
  const VecX va = force(s.t, s.x, s.v).cwiseQuotient(m);
  const VecX xb = s.v + 0.5 * h * va;
  const VecX vb = force(s.t + 0.5 * h, s.x + 0.5 * h * xa, xb).cwiseQuotient(m);
  const VecX xc = s.v + 0.5 * h * vb;
  const VecX vc = force(s.t + 0.5 * h, s.x + 0.5 * h * xb, xc).cwiseQuotient(m);
  const VecX xd = s.v + h * vc;
  const VecX vd = force(s.t + h, s.x + h * xc, xd).cwiseQuotient(m);
  s.x += h / 6 * (xa + 2 * xb + 2 * xc + xd);
  s.v += h / 6 * (va + 2 * vb + 2 * vc + vd);
  s.t += h;
}

}  // namespace

VecX squeezedRabbit(const Force& force, const VecX& m, const VecX& x0, const VecX& v0) {
  Motion s{0.0, x0, v0};
  const int n = 122;
  for (int i = 0; i < n; ++i) {
    s.t = i * rabbitDuration / n;
    rungeKutta(force, m, s, rabbitDuration / n);
  }
  return s.x;
}

VecX stiffCloth(const Force& force, const Hessian& hessian, const VecX& m, const VecX& x0, const VecX& v0) {
  const int n = 90;
  const double h = clothDuration / n;
  VecX x = x0, v = v0;
  VecX a = force(0, x, v).cwiseQuotient(m);
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> ldlt;
  for (int i = 0; i < n; ++i) {
    const double t1 = (i + 1) * h;
    VecX x1 = x + h * v + 0.5 * h * h * a;
    Eigen::SparseMatrix<double> A = 0.25 * h * h * hessian(t1, x + h * v);
    for (Eigen::Index j = 0; j < m.size(); ++j) A.coeffRef(j, j) += m[j];
    ldlt.compute(A);
    const VecX known = x + h * v + 0.25 * h * h * a;
    VecX a1;
    x1 = x + h * v;
    for (int newton = 0; newton < 3; ++newton) {
      a1 = force(t1, x1, v).cwiseQuotient(m);
      const VecX residual = m.cwiseProduct(known + 0.25 * h * h * a1 - x1);
      x1 += ldlt.solve(residual);
    }
    a1 = (x1 - known) / (0.25 * h * h);
    v += 0.5 * h * (a + a1);
    x = x1;
    a = a1;
  }
  return x;
}

VecX bouncingBall(const Force& force, const VecX& m, const VecX& x0, const VecX& v0) {
  Motion s{0.0, x0, v0};
  double t = 0;
  while (t < ballDuration) {
    const double toGround = (s.v[2] + std::sqrt(s.v[2] * s.v[2] - 2 * 9.81 * s.x[2])) / 9.81;
    double h = s.x[2] > 0 ? 0.1 * toGround : 1e-4;
    if (h > ballDuration - t) h = ballDuration - t;
    rungeKutta(force, m, s, h);
    t = t + h;
    if (std::isnan(s.x[2])) break;
  }
  return s.x;
}
