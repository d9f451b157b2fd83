// loses: Verlet, Order, Stability, Energies, Reversibility; misconception: none
// verletStep adds h/2 a to the position where h^2/2 a belongs (the square of h is forgotten).
#include "time_integration.h"

State explicitEulerStep(const Force& force, const VecX& m, const State& now, double h) {
  const VecX a = force(now.t, now.x, now.v).cwiseQuotient(m);
  return {now.t + h, now.x + h * now.v, now.v + h * a};
}

State midpointStep(const Force& force, const VecX& m, const State& now, double h) {
  const State middle = explicitEulerStep(force, m, now, h / 2);
  const VecX a = force(middle.t, middle.x, middle.v).cwiseQuotient(m);
  return {now.t + h, now.x + h * middle.v, now.v + h * a};
}

State verletStep(const PositionForce& force, const VecX& m, const State& now, double h) {
  const VecX a0 = force(now.t, now.x).cwiseQuotient(m);
  State next;
  next.t = now.t + h;
  next.x = now.x + h * now.v + h / 2 * a0;
  const VecX a1 = force(next.t, next.x).cwiseQuotient(m);
  next.v = now.v + h / 2 * (a0 + a1);
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
