// loses: ExplicitEuler; misconception: mass_per_node
// explicitEulerStep takes m for one mass a node and divides coordinate i by m[i / 3], but m has one mass for each
// coordinate.
#include "time_integration.h"

State explicitEulerStep(const Force& force, const VecX& m, const State& now, double h) {
  const VecX F = force(now.t, now.x, now.v);
  State next = now;
  next.t = now.t + h;
  for (int i = 0; i < now.x.size(); i++) {
    next.x[i] += h * now.v[i];
    next.v[i] += h * F[i] / m[i / 3];  // three coordinates a node
  }
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
