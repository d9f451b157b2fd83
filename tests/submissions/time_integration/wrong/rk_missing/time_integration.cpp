// loses: RungeKutta, Evaluations, Order, Stability, Energies; misconception: zero
// not written
#include "time_integration.h"

State explicitEulerStep(const Force& force, const VecX& m, const State& now, double h) {
  const VecX a = force(now.t, now.x, now.v).cwiseQuotient(m);
  return {now.t + h, now.x + h * now.v, now.v + h * a};
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
  (void)force, (void)m, (void)h;
  return {0.0, VecX::Zero(now.x.size()), VecX::Zero(now.v.size())};
}
