// loses: RungeKutta; misconception: single_precision
// 1.0f / 6 is a sixth to seven digits only
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
  const float sixth = 1.0f / 6;
  VecX v1 = now.v;
  VecX a1 = force(now.t, now.x, v1).cwiseQuotient(m);
  VecX v2 = now.v + h / 2 * a1;
  VecX a2 = force(now.t + h / 2, now.x + h / 2 * v1, v2).cwiseQuotient(m);
  VecX v3 = now.v + h / 2 * a2;
  VecX a3 = force(now.t + h / 2, now.x + h / 2 * v2, v3).cwiseQuotient(m);
  VecX v4 = now.v + h * a3;
  VecX a4 = force(now.t + h, now.x + h * v3, v4).cwiseQuotient(m);
  State next;
  next.t = now.t + h;
  next.x = now.x + sixth * h * (v1 + 2 * v2 + 2 * v3 + v4);
  next.v = now.v + sixth * h * (a1 + 2 * a2 + 2 * a3 + a4);
  return next;
}
