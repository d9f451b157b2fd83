#include "time_integration.h"

namespace {

struct Slope {
  VecX v, a;
};

Slope slopeAt(const Force& force, const VecX& m, const State& s) {
  return {s.v, (force(s.t, s.x, s.v).array() / m.array()).matrix()};
}

State moved(const State& s, const Slope& k, double h) { return {s.t + h, s.x + h * k.v, s.v + h * k.a}; }

}  // namespace

State explicitEulerStep(const Force& force, const VecX& m, const State& now, double h) {
  return moved(now, slopeAt(force, m, now), h);
}

State midpointStep(const Force& force, const VecX& m, const State& now, double h) {
  return moved(now, slopeAt(force, m, moved(now, slopeAt(force, m, now), h / 2)), h);
}

// half a kick, a drift, half a kick
State verletStep(const PositionForce& force, const VecX& m, const State& now, double h) {
  State s = now;
  s.v += h / 2 * force(s.t, s.x).cwiseQuotient(m);
  s.x += h * s.v;
  s.t += h;
  s.v += h / 2 * force(s.t, s.x).cwiseQuotient(m);
  return s;
}

State rungeKuttaStep(const Force& force, const VecX& m, const State& now, double h) {
  const Slope k1 = slopeAt(force, m, now);
  const Slope k2 = slopeAt(force, m, moved(now, k1, h / 2));
  const Slope k3 = slopeAt(force, m, moved(now, k2, h / 2));
  const Slope k4 = slopeAt(force, m, moved(now, k3, h));
  State end = now;
  end = moved(end, k1, h / 6);
  end = moved(end, k2, h / 3);
  end = moved(end, k3, h / 3);
  end = moved(end, k4, h / 6);
  end.t = now.t + h;
  return end;
}
