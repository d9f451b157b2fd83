// loses: RungeKutta, Order, Stability, Energies; misconception: none
// rungeKuttaStep has kv2 twice in the sum for the position where the second one should be kv3 (copy-paste slip).
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
  State next;
  next.t = now.t + h;
  const VecX aOld = force(now.t, now.x).array() / m.array();
  next.x = now.x + now.v * h + aOld * (0.5 * h * h);
  const VecX aNew = force(next.t, next.x).array() / m.array();
  next.v = now.v + (aOld + aNew) * (0.5 * h);
  return next;
}

State rungeKuttaStep(const Force& force, const VecX& m, const State& now, double h) {
  const VecX kv1 = now.v;
  const VecX ka1 = force(now.t, now.x, kv1).cwiseQuotient(m);
  const VecX kv2 = now.v + h / 2 * ka1;
  const VecX ka2 = force(now.t + h / 2, now.x + h / 2 * kv1, kv2).cwiseQuotient(m);
  const VecX kv3 = now.v + h / 2 * ka2;
  const VecX ka3 = force(now.t + h / 2, now.x + h / 2 * kv2, kv3).cwiseQuotient(m);
  const VecX kv4 = now.v + h * ka3;
  const VecX ka4 = force(now.t + h, now.x + h * kv3, kv4).cwiseQuotient(m);
  State next;
  next.t = now.t + h;
  next.x = now.x + h / 6 * (kv1 + 2 * kv2 + 2 * kv2 + kv4);
  next.v = now.v + h / 6 * (ka1 + 2 * ka2 + 2 * ka3 + ka4);
  return next;
}
