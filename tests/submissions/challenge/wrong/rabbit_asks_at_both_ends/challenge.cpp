// loses: RabbitGood, RabbitBest; misconception: asked_too_often
// The student asks for the force at the beginning and at the end of each Verlet step and does not keep the answer.
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
  const int n = 1300;
  const double h = rabbitDuration / n;
  VecX x = x0, v = v0;
  for (int i = 0; i < n; ++i) {
    const double t = i * h;
    const VecX a = force(t, x, v).cwiseQuotient(m);
    x += h * v + 0.5 * h * h * a;
    const VecX b = force(t + h, x, v).cwiseQuotient(m);
    v += 0.5 * h * (a + b);
  }
  return x;
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
  const double flight = 0.03, ground = 3e-4;
  Motion s{0.0, x0, v0};
  while (s.t < ballDuration) {
    const double rest = ballDuration - s.t;
    // how long until it is at the ground if it fell a little faster than it does
    const double vz = s.v[2], z = s.x[2];
    double h = ground;
    if (z > 0) {
      const double g = 10.5;
      const double fall = (vz + std::sqrt(vz * vz + 2 * g * z)) / g;
      h = std::clamp(0.9 * fall, ground, flight);
    }
    const bool last = h >= rest;
    rungeKutta(force, m, s, last ? rest : h);
    if (last) break;
  }
  return s.x;
}
