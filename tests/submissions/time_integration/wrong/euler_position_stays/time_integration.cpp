// loses: ExplicitEuler, Order, Stability, Energies; misconception: position_stays
#include "time_integration.h"

State explicitEulerStep(const Force& force, const VecX& m, const State& now, double h) {
  const VecX a = force(now.t, now.x, now.v).cwiseQuotient(m);
  State next = now;
  next.t += h;
  next.v += h * a;
  return next;
}

State midpointStep(const Force& force, const VecX& m, const State& now, double h) {
  const VecX a0 = force(now.t, now.x, now.v).cwiseQuotient(m);
  const VecX xm = now.x + 0.5 * h * now.v;
  const VecX vm = now.v + 0.5 * h * a0;
  const VecX am = force(now.t + 0.5 * h, xm, vm).cwiseQuotient(m);
  return {now.t + h, now.x + h * vm, now.v + h * am};
}

State verletStep(const PositionForce& force, const VecX& m, const State& now, double h) {
  const VecX a0 = force(now.t, now.x).cwiseQuotient(m);
  const VecX x1 = now.x + h * now.v + 0.5 * h * h * a0;
  const VecX a1 = force(now.t + h, x1).cwiseQuotient(m);
  return {now.t + h, x1, now.v + 0.5 * h * (a0 + a1)};
}

State rungeKuttaStep(const Force& force, const VecX& m, const State& now, double h) {
  const VecX v1 = now.v;
  const VecX a1 = force(now.t, now.x, v1).cwiseQuotient(m);
  const VecX v2 = now.v + 0.5 * h * a1;
  const VecX a2 = force(now.t + 0.5 * h, now.x + 0.5 * h * v1, v2).cwiseQuotient(m);
  const VecX v3 = now.v + 0.5 * h * a2;
  const VecX a3 = force(now.t + 0.5 * h, now.x + 0.5 * h * v2, v3).cwiseQuotient(m);
  const VecX v4 = now.v + h * a3;
  const VecX a4 = force(now.t + h, now.x + h * v3, v4).cwiseQuotient(m);
  return {now.t + h, now.x + h / 6 * (v1 + 2 * v2 + 2 * v3 + v4), now.v + h / 6 * (a1 + 2 * a2 + 2 * a3 + a4)};
}
