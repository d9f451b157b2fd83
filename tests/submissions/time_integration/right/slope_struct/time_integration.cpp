#include "time_integration.h"

namespace {

struct Slope {
  VecX dx, dv;
};

Slope slopeAt(const Force& force, const VecX& m, const State& s) {
  return {s.v, force(s.t, s.x, s.v).cwiseQuotient(m)};
}

State along(const State& s, const Slope& k, double h) { return {s.t + h, s.x + h * k.dx, s.v + h * k.dv}; }

}  // namespace

State explicitEulerStep(const Force& force, const VecX& m, const State& now, double h) {
  return along(now, slopeAt(force, m, now), h);
}

State midpointStep(const Force& force, const VecX& m, const State& now, double h) {
  const State half = explicitEulerStep(force, m, now, h / 2);
  return along(now, slopeAt(force, m, half), h);
}

State verletStep(const PositionForce& force, const VecX& m, const State& now, double h) {
  // a slope that turns half a kick into the mean velocity of the step
  const VecX half = now.v + h / 2 * force(now.t, now.x).cwiseQuotient(m);
  const VecX end = now.x + h * half;
  return {now.t + h, end, half + h / 2 * force(now.t + h, end).cwiseQuotient(m)};
}

State rungeKuttaStep(const Force& force, const VecX& m, const State& now, double h) {
  const Slope k1 = slopeAt(force, m, now);
  const Slope k2 = slopeAt(force, m, along(now, k1, h / 2));
  const Slope k3 = slopeAt(force, m, along(now, k2, h / 2));
  const Slope k4 = slopeAt(force, m, along(now, k3, h));
  const Slope mean{(k1.dx + 2 * (k2.dx + k3.dx) + k4.dx) / 6, (k1.dv + 2 * (k2.dv + k3.dv) + k4.dv) / 6};
  return along(now, mean, h);
}
