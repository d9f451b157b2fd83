// loses: Verlet, Evaluations, Order, Stability, Energies, Reversibility; misconception: stateful
// verletStep keeps the acceleration of its last call in a static variable and takes it for that of the beginning,
// though the next call may begin in another state, with another force or mass.
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
  const State middle = explicitEulerStep(force, m, now, h / 2);
  const VecX a = force(middle.t, middle.x, middle.v).cwiseQuotient(m);
  return {now.t + h, now.x + h * middle.v, now.v + h * a};
}

State verletStep(const PositionForce& force, const VecX& m, const State& now, double h) {
  static VecX a;  // the end of one step is the beginning of the next: ask only once a step
  if (a.size() != now.x.size()) a = force(now.t, now.x).cwiseQuotient(m);
  State next;
  next.t = now.t + h;
  next.x = now.x + h * now.v + h * h / 2 * a;
  const VecX aNew = force(next.t, next.x).cwiseQuotient(m);
  next.v = now.v + h / 2 * (a + aNew);
  a = aNew;
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
