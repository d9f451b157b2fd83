// loses: Midpoint, Order, Energies; misconception: integer_division or euler_instead
// midpointStep computes half of the step as 1 / 2 * h, where 1 / 2 is an integer division and gives 0, so it never
// leaves the beginning and is explicit Euler.
#include "time_integration.h"

State explicitEulerStep(const Force& force, const VecX& m, const State& now, double h) {
  State next;
  const VecX F = force(now.t, now.x, now.v);
  next.t = now.t + h;
  next.x = now.x + h * now.v;
  next.v = now.v;
  for (Eigen::Index i = 0; i < F.size(); i++) next.v[i] += h * F[i] / m[i];
  return next;
}

State midpointStep(const Force& force, const VecX& m, const State& now, double h) {
  const double half = 1 / 2 * h;
  const VecX a0 = force(now.t, now.x, now.v).cwiseQuotient(m);
  const VecX xm = now.x + half * now.v;
  const VecX vm = now.v + half * a0;
  const VecX am = force(now.t + half, xm, vm).cwiseQuotient(m);
  return {now.t + h, now.x + h * vm, now.v + h * am};
}

State verletStep(const PositionForce& force, const VecX& m, const State& now, double h) {
  State next;
  next.t = now.t + h;
  const VecX aOld = force(now.t, now.x).array() / m.array();
  next.x = now.x + now.v * h + aOld * (0.5 * h * h);
  const VecX aNew = force(next.t, next.x).array() / m.array();
  next.v = now.v + (aOld + aNew) * (0.5 * h);
  return next;
}

State rungeKuttaStep(const Force& force, const VecX& m, const State& now, double h) {
  const double t = now.t;
  const VecX &x = now.x, &v = now.v;
  VecX kx1 = v;
  VecX kv1 = force(t, x, kx1).cwiseQuotient(m);

  VecX kx2 = v + 0.5 * h * kv1;
  VecX kv2 = force(t + 0.5 * h, x + 0.5 * h * kx1, kx2).cwiseQuotient(m);

  VecX kx3 = v + 0.5 * h * kv2;
  VecX kv3 = force(t + 0.5 * h, x + 0.5 * h * kx2, kx3).cwiseQuotient(m);

  VecX kx4 = v + h * kv3;
  VecX kv4 = force(t + h, x + h * kx3, kx4).cwiseQuotient(m);

  State next;
  next.t = t + h;
  next.x = x + h * (kx1 + 2 * kx2 + 2 * kx3 + kx4) / 6;
  next.v = v + h * (kv1 + 2 * kv2 + 2 * kv3 + kv4) / 6;
  return next;
}
