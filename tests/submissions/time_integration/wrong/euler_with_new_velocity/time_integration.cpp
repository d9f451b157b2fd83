// loses: ExplicitEuler, Stability, Energies; misconception: symplectic_euler
// explicitEulerStep moves the position by the new velocity where the old one belongs: that is symplectic Euler.
#include "time_integration.h"

State explicitEulerStep(const Force& force, const VecX& m, const State& now, double h) {
  State next = now;
  next.v += h * force(now.t, now.x, now.v).cwiseQuotient(m);
  next.x += h * next.v;
  next.t += h;
  return next;
}

State midpointStep(const Force& force, const VecX& m, const State& now, double h) {
  const VecX a0 = force(now.t, now.x, now.v).cwiseQuotient(m);
  const VecX xm = now.x + 0.5 * h * now.v;
  const VecX vm = now.v + 0.5 * h * a0;
  const VecX am = force(now.t + 0.5 * h, xm, vm).cwiseQuotient(m);
  State next = now;
  next.t += h;
  next.x += h * vm;
  next.v += h * am;
  return next;
}

State verletStep(const PositionForce& force, const VecX& m, const State& now, double h) {
  const VecX a0 = force(now.t, now.x).cwiseQuotient(m);
  const VecX x1 = now.x + h * now.v + h * h / 2 * a0;
  const VecX a1 = force(now.t + h, x1).cwiseQuotient(m);
  return {now.t + h, x1, now.v + h / 2 * (a0 + a1)};
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
