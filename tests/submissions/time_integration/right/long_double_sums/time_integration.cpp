#include "time_integration.h"

using Long = Eigen::Matrix<long double, Eigen::Dynamic, 1>;

static Long accel(const VecX& F, const VecX& m) {
  return F.cast<long double>().cwiseQuotient(m.cast<long double>());
}
static VecX sum(const VecX& from, double h, const Long& slope) {
  const Long r = from.cast<long double>() + static_cast<long double>(h) * slope;
  return r.cast<double>();
}

State explicitEulerStep(const Force& force, const VecX& m, const State& now, double h) {
  const Long a = accel(force(now.t, now.x, now.v), m);
  return State{now.t + h, sum(now.x, h, now.v.cast<long double>()), sum(now.v, h, a)};
}

State midpointStep(const Force& force, const VecX& m, const State& now, double h) {
  const State mid = explicitEulerStep(force, m, now, h * 0.5);
  const Long a = accel(force(mid.t, mid.x, mid.v), m);
  return State{now.t + h, sum(now.x, h, mid.v.cast<long double>()), sum(now.v, h, a)};
}

State verletStep(const PositionForce& force, const VecX& m, const State& now, double h) {
  const Long a0 = accel(force(now.t, now.x), m);
  const VecX x1 = sum(now.x, h, now.v.cast<long double>() + a0 * static_cast<long double>(h / 2));
  const Long a1 = accel(force(now.t + h, x1), m);
  return State{now.t + h, x1, sum(now.v, h / 2, a0 + a1)};
}

State rungeKuttaStep(const Force& force, const VecX& m, const State& now, double h) {
  auto A = [&](double t, const VecX& x, const VecX& v) -> Long { return accel(force(t, x, v), m); };
  const Long v1 = now.v.cast<long double>();
  const Long a1 = A(now.t, now.x, now.v);
  const VecX v2 = sum(now.v, h / 2, a1);
  const Long a2 = A(now.t + h / 2, sum(now.x, h / 2, v1), v2);
  const VecX v3 = sum(now.v, h / 2, a2);
  const Long a3 = A(now.t + h / 2, sum(now.x, h / 2, v2.cast<long double>()), v3);
  const VecX v4 = sum(now.v, h, a3);
  const Long a4 = A(now.t + h, sum(now.x, h, v3.cast<long double>()), v4);
  const Long vs = (v1 + 2 * (v2 + v3).cast<long double>() + v4.cast<long double>()) / 6;
  const Long as = (a1 + 2 * (a2 + a3) + a4) / 6;
  return {now.t + h, sum(now.x, h, vs), sum(now.v, h, as)};
}
