// loses: RabbitEnough, RabbitGood, RabbitBest; misconception: too_inexact
// Extrapolates the rabbit's two Verlet runs as if the error halved with the step: two times the fine minus the coarse.
#include "challenge.h"

#include <Eigen/SparseCholesky>

static VecX verlet(const Force& force, const VecX& m, const VecX& x0, const VecX& v0, double T, int n) {
  const double h = T / n;
  VecX x = x0, v = v0;
  VecX a = force(0, x, v).cwiseQuotient(m);
  for (int i = 1; i <= n; i++) {
    v += h / 2 * a;
    x += h * v;
    if (i == n) break;  // the last velocity is not wanted
    a = force(i * h, x, v).cwiseQuotient(m);
    v += h / 2 * a;
  }
  return x;
}

VecX squeezedRabbit(const Force& force, const VecX& m, const VecX& x0, const VecX& v0) {
  // The error goes down with the step, so take it away.
  const VecX coarse = verlet(force, m, x0, v0, rabbitDuration, 160);
  const VecX fine = verlet(force, m, x0, v0, rabbitDuration, 320);
  return 2 * fine - coarse;
}

VecX stiffCloth(const Force& force, const Hessian& hessian, const VecX& m, const VecX& x0, const VecX& v0) {
  const int steps = 90;
  const double h = clothDuration / steps;
  typedef Eigen::SparseMatrix<double> Sparse;
  Eigen::SimplicialLDLT<Sparse> solver;
  VecX x = x0, v = v0;
  for (int i = 0; i < steps; i++) {
    const double t = i * h + h / 2;
    VecX u = v;  // the velocity in the middle of the step
    Sparse A = hessian(t, x + h / 2 * u) * (h * h / 4);
    A.diagonal() += m;
    solver.compute(A);
    for (int k = 0; k < 5; k++) {
      const VecX r = m.cwiseProduct(u - v) - h / 2 * force(t, x + h / 2 * u, u);
      u -= solver.solve(r);
    }
    x += h * u;
    v = 2 * u - v;
  }
  return x;
}

VecX bouncingBall(const Force& force, const VecX& m, const VecX& x0, const VecX& v0) {
  const double small = 6e-5, big = 5e-3;
  double t = 0;
  VecX x = x0, v = v0;
  VecX a = force(t, x, v).cwiseQuotient(m);
  while (t < ballDuration) {
    // Where is the ball in a big step, roughly? Halve until that is above the ground.
    double h = big;
    while (h > small && x[2] + h * v[2] + h * h / 2 * a[2] < 0) h /= 2;
    if (x[2] < 0 || h < small) h = small;
    const bool last = t + h >= ballDuration;
    if (last) h = ballDuration - t;
    x += h * v + h * h / 2 * a;
    t += h;
    const VecX aNew = force(t, x, v + h * a).cwiseQuotient(m);
    v += h / 2 * (a + aNew);
    a = aNew;
    if (last) break;
  }
  return x;
}
