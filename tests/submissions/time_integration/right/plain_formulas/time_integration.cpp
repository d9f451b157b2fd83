#include "time_integration.h"

State explicitEulerStep(const Force& force, const VecX& m, const State& now, double h) {
  State next;
  VecX F = force(now.t, now.x, now.v);
  next.t = now.t + h;
  next.x = now.x + h * now.v;
  next.v = now.v + h * F.cwiseQuotient(m);
  return next;
}

State midpointStep(const Force& force, const VecX& m, const State& now, double h) {
  VecX a = force(now.t, now.x, now.v).cwiseQuotient(m);
  VecX xm = now.x + 0.5 * h * now.v;
  VecX vm = now.v + 0.5 * h * a;
  VecX am = force(now.t + 0.5 * h, xm, vm).cwiseQuotient(m);
  State next;
  next.t = now.t + h;
  next.x = now.x + h * vm;
  next.v = now.v + h * am;
  return next;
}

State verletStep(const PositionForce& force, const VecX& m, const State& now, double h) {
  State next;
  next.t = now.t + h;
  VecX aStart = force(now.t, now.x).cwiseQuotient(m);
  next.x = now.x + h * now.v + 0.5 * h * h * aStart;
  VecX aEnd = force(next.t, next.x).cwiseQuotient(m);
  next.v = now.v + 0.5 * h * (aStart + aEnd);
  return next;
}

State rungeKuttaStep(const Force& force, const VecX& m, const State& now, double h) {
  double tm = now.t + 0.5 * h;
  VecX kv1 = now.v;
  VecX ka1 = force(now.t, now.x, kv1).cwiseQuotient(m);
  VecX kv2 = now.v + 0.5 * h * ka1;
  VecX ka2 = force(tm, now.x + 0.5 * h * kv1, kv2).cwiseQuotient(m);
  VecX kv3 = now.v + 0.5 * h * ka2;
  VecX ka3 = force(tm, now.x + 0.5 * h * kv2, kv3).cwiseQuotient(m);
  VecX kv4 = now.v + h * ka3;
  VecX ka4 = force(now.t + h, now.x + h * kv3, kv4).cwiseQuotient(m);
  State next;
  next.t = now.t + h;
  next.x = now.x + h * (kv1 + 2 * kv2 + 2 * kv3 + kv4) / 6;
  next.v = now.v + h * (ka1 + 2 * ka2 + 2 * ka3 + ka4) / 6;
  return next;
}
