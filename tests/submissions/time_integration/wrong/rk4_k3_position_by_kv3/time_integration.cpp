// loses: RungeKutta, Order, Stability, Energies; misconception: none
// in rungeKuttaStep the position of the third question goes on with kv3 where kv2, the velocity found just before,
// belongs.
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
  const VecX x1 = now.x + h * now.v + h * h / 2 * a0;
  const VecX a1 = force(now.t + h, x1).cwiseQuotient(m);
  return {now.t + h, x1, now.v + h / 2 * (a0 + a1)};
}

State rungeKuttaStep(const Force& force, const VecX& m, const State& now, double h) {
  auto acc = [&force, &m](double t, const VecX& x, const VecX& v) { return VecX(force(t, x, v).array() / m.array()); };
  const double half = 0.5 * h;

  const VecX v1 = now.v;
  const VecX a1 = acc(now.t, now.x, v1);
  const VecX v2 = now.v + half * a1;
  const VecX a2 = acc(now.t + half, now.x + half * v1, v2);
  const VecX v3 = now.v + half * a2;
  const VecX a3 = acc(now.t + half, now.x + half * v3, v3);
  const VecX v4 = now.v + h * a3;
  const VecX a4 = acc(now.t + h, now.x + h * v3, v4);

  const VecX dx = (v1 + 2.0 * v2 + 2.0 * v3 + v4) / 6.0;
  const VecX dv = (a1 + 2.0 * a2 + 2.0 * a3 + a4) / 6.0;
  return {now.t + h, now.x + h * dx, now.v + h * dv};
}
