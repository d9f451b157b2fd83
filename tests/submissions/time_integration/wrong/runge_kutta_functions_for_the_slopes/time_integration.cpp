// loses: Evaluations; misconception: none
// k1() to k4() compute again what they need: right numbers, ten questions and more
#include "time_integration.h"

namespace {

// y = (x, v), so that y' = (v, F / m)
VecX stack(const VecX& x, const VecX& v) {
  VecX y(x.size() + v.size());
  y << x, v;
  return y;
}

VecX rhs(const Force& force, const VecX& m, double t, const VecX& y) {
  const auto n = m.size();
  const VecX x = y.head(n);
  const VecX v = y.tail(n);
  return stack(v, force(t, x, v).cwiseQuotient(m));
}

State unstack(double t, const VecX& y) {
  const auto n = y.size() / 2;
  return {t, y.head(n), y.tail(n)};
}

}  // namespace

State explicitEulerStep(const Force& force, const VecX& m, const State& now, double h) {
  const VecX y = stack(now.x, now.v);
  return unstack(now.t + h, y + h * rhs(force, m, now.t, y));
}

State midpointStep(const Force& force, const VecX& m, const State& now, double h) {
  const VecX y = stack(now.x, now.v);
  const VecX ym = y + h / 2 * rhs(force, m, now.t, y);
  return unstack(now.t + h, y + h * rhs(force, m, now.t + h / 2, ym));
}

State verletStep(const PositionForce& force, const VecX& m, const State& now, double h) {
  const double t1 = now.t + h;
  const VecX a0 = force(now.t, now.x).array() / m.array();
  const VecX x1 = now.x + h * (now.v + h / 2 * a0);
  const VecX a1 = force(t1, x1).array() / m.array();
  return unstack(t1, stack(x1, now.v + h * (a0 + a1) / 2));
}

State rungeKuttaStep(const Force& force, const VecX& m, const State& now, double h) {
  const VecX y = stack(now.x, now.v);
  const auto k1 = [&]() -> VecX { return rhs(force, m, now.t, y); };
  const auto k2 = [&]() -> VecX { return rhs(force, m, now.t + h / 2, y + h / 2 * k1()); };
  const auto k3 = [&]() -> VecX { return rhs(force, m, now.t + h / 2, y + h / 2 * k2()); };
  const auto k4 = [&]() -> VecX { return rhs(force, m, now.t + h, y + h * k3()); };
  return unstack(now.t + h, y + h / 6 * (k1() + 2 * k2() + 2 * k3() + k4()));
}
