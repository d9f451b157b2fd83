#include "time_integration.h"

// dx and dv are changes over a whole step

namespace {

void change(const Force& force, const VecX& m, double t, const VecX& x, const VecX& v, double h, VecX& dx, VecX& dv) {
  dx = h * v;
  dv = h * force(t, x, v);
  dv.array() /= m.array();
}

}  // namespace

State explicitEulerStep(const Force& force, const VecX& m, const State& now, double h) {
  VecX dx, dv;
  change(force, m, now.t, now.x, now.v, h, dx, dv);
  State next = now;
  next.t = now.t + h;
  next.x += dx;
  next.v += dv;
  return next;
}

State midpointStep(const Force& force, const VecX& m, const State& now, double h) {
  VecX dx1, dv1, dx2, dv2;
  change(force, m, now.t, now.x, now.v, h, dx1, dv1);
  change(force, m, now.t + h / 2, now.x + dx1 / 2, now.v + dv1 / 2, h, dx2, dv2);
  return {now.t + h, now.x + dx2, now.v + dv2};
}

State verletStep(const PositionForce& force, const VecX& m, const State& now, double h) {
  const VecX dv0 = h * force(now.t, now.x).cwiseQuotient(m);
  const VecX x = now.x + h * now.v + h * dv0 / 2;
  const VecX dv1 = h * force(now.t + h, x).cwiseQuotient(m);
  return {now.t + h, x, now.v + dv0 / 2 + dv1 / 2};
}

State rungeKuttaStep(const Force& force, const VecX& m, const State& now, double h) {
  VecX dx1, dv1, dx2, dv2, dx3, dv3, dx4, dv4;
  change(force, m, now.t, now.x, now.v, h, dx1, dv1);
  change(force, m, now.t + h / 2, now.x + dx1 / 2, now.v + dv1 / 2, h, dx2, dv2);
  change(force, m, now.t + h / 2, now.x + dx2 / 2, now.v + dv2 / 2, h, dx3, dv3);
  change(force, m, now.t + h, now.x + dx3, now.v + dv3, h, dx4, dv4);
  const VecX dx = dx1 / 6 + dx2 / 3 + dx3 / 3 + dx4 / 6;
  const VecX dv = dv1 / 6 + dv2 / 3 + dv3 / 3 + dv4 / 6;
  return {now.t + h, now.x + dx, now.v + dv};
}
