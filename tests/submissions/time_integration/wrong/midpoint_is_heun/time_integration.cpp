// loses: Midpoint; misconception: heun
// midpointStep takes the mean of the slopes at the beginning and at the end of the step (Heun's method) where the
// slope at the middle belongs.
#include "time_integration.h"

State explicitEulerStep(const Force& force, const VecX& m, const State& now, double h) {
  const VecX a = force(now.t, now.x, now.v).cwiseQuotient(m);
  return {now.t + h, now.x + h * now.v, now.v + h * a};
}

State midpointStep(const Force& force, const VecX& m, const State& now, double h) {
  const VecX a0 = force(now.t, now.x, now.v).cwiseQuotient(m);
  const VecX xEnd = now.x + h * now.v;
  const VecX vEnd = now.v + h * a0;
  const VecX aEnd = force(now.t + h, xEnd, vEnd).cwiseQuotient(m);
  // the mean of the beginning and the end is what holds in the middle
  return {now.t + h, now.x + h * 0.5 * (now.v + vEnd), now.v + h * 0.5 * (a0 + aEnd)};
}

State verletStep(const PositionForce& force, const VecX& m, const State& now, double h) {
  const VecX a0 = force(now.t, now.x).cwiseQuotient(m);
  const VecX x1 = now.x + h * now.v + h * h / 2 * a0;
  const VecX a1 = force(now.t + h, x1).cwiseQuotient(m);
  return {now.t + h, x1, now.v + h / 2 * (a0 + a1)};
}

State rungeKuttaStep(const Force& force, const VecX& m, const State& now, double h) {
  const auto a = [&](double t, const VecX& x, const VecX& v) -> VecX { return force(t, x, v).cwiseQuotient(m); };
  const VecX v1 = now.v;
  const VecX a1 = a(now.t, now.x, v1);
  const VecX v2 = now.v + h / 2 * a1;
  const VecX a2 = a(now.t + h / 2, now.x + h / 2 * v1, v2);
  const VecX v3 = now.v + h / 2 * a2;
  const VecX a3 = a(now.t + h / 2, now.x + h / 2 * v2, v3);
  const VecX v4 = now.v + h * a3;
  const VecX a4 = a(now.t + h, now.x + h * v3, v4);
  return {now.t + h, now.x + h / 6 * (v1 + 2 * v2 + 2 * v3 + v4), now.v + h / 6 * (a1 + 2 * a2 + 2 * a3 + a4)};
}
