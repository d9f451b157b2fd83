#include "time_integration.h"

// y = (x, v) is one long vector, and everything is y' = g(t, y)

static VecX glue(const State& s) {
  VecX y(2 * s.x.size());
  y << s.x, s.v;
  return y;
}

static State cut(double t, const VecX& y) {
  State s;
  s.t = t;
  s.x = y.head(y.size() / 2);
  s.v = y.tail(y.size() / 2);
  return s;
}

static VecX g(const Force& force, const VecX& m, double t, const VecX& y) {
  const State s = cut(t, y);
  VecX dy(y.size());
  dy << s.v, force(t, s.x, s.v).cwiseQuotient(m);
  return dy;
}

State explicitEulerStep(const Force& force, const VecX& m, const State& now, double h) {
  const VecX y = glue(now);
  return cut(now.t + h, y + h * g(force, m, now.t, y));
}

State midpointStep(const Force& force, const VecX& m, const State& now, double h) {
  const VecX y = glue(now);
  const VecX k1 = g(force, m, now.t, y);
  const VecX k2 = g(force, m, now.t + 0.5 * h, y + 0.5 * h * k1);
  return cut(now.t + h, y + h * k2);
}

State verletStep(const PositionForce& force, const VecX& m, const State& now, double h) {
  State next;
  next.t = now.t + h;
  VecX a = force(now.t, now.x).cwiseQuotient(m);
  next.x = now.x + h * (now.v + 0.5 * h * a);
  a += force(next.t, next.x).cwiseQuotient(m);
  next.v = now.v + 0.5 * h * a;
  return next;
}

State rungeKuttaStep(const Force& force, const VecX& m, const State& now, double h) {
  const VecX y = glue(now);
  const VecX k1 = g(force, m, now.t, y);
  const VecX k2 = g(force, m, now.t + 0.5 * h, y + 0.5 * h * k1);
  const VecX k3 = g(force, m, now.t + 0.5 * h, y + 0.5 * h * k2);
  const VecX k4 = g(force, m, now.t + h, y + h * k3);
  return cut(now.t + h, y + h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4));
}
