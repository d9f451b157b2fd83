// loses: Evaluations; misconception: none
// verletStep asks for the force at the beginning twice, once for the position and once for the velocity: three
// questions where two are allowed.
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
  next.x = now.x + h * now.v + 0.5 * h * h * force(now.t, now.x).cwiseQuotient(m);
  next.v = now.v + 0.5 * h * (force(now.t, now.x) + force(next.t, next.x)).cwiseQuotient(m);
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
