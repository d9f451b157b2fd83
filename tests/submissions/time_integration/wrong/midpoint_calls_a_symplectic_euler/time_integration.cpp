// loses: ExplicitEuler, Stability, Energies; misconception: symplectic_euler
// the midpoint is right by the Euler that it calls
#include "time_integration.h"

State explicitEulerStep(const Force& force, const VecX& m, const State& now, double h) {
  State after = now;
  after.v += h * force(now.t, now.x, now.v).cwiseQuotient(m);
  after.x += h * after.v;
  after.t += h;
  return after;
}

State midpointStep(const Force& force, const VecX& m, const State& now, double h) {
  State look = explicitEulerStep(force, m, now, 0.5 * h);
  State after = now;
  after.x += h * look.v;
  after.v += h * force(look.t, look.x, look.v).cwiseQuotient(m);
  after.t += h;
  return after;
}

State verletStep(const PositionForce& force, const VecX& m, const State& now, double h) {
  State s = now;
  s.v += 0.5 * h * force(s.t, s.x).cwiseQuotient(m);  // kick
  s.x += h * s.v;                                     // drift
  s.t += h;
  s.v += 0.5 * h * force(s.t, s.x).cwiseQuotient(m);  // kick
  return s;
}

State rungeKuttaStep(const Force& force, const VecX& m, const State& now, double h) {
  State after = now;
  VecX v = now.v;
  VecX a = force(now.t, now.x, v).cwiseQuotient(m);
  after.x += h / 6 * v;
  after.v += h / 6 * a;
  for (int twice = 0; twice < 2; ++twice) {
    const VecX x = now.x + h / 2 * v;
    v = now.v + h / 2 * a;
    a = force(now.t + h / 2, x, v).cwiseQuotient(m);
    after.x += h / 3 * v;
    after.v += h / 3 * a;
  }
  const VecX x = now.x + h * v;
  v = now.v + h * a;
  a = force(now.t + h, x, v).cwiseQuotient(m);
  after.x += h / 6 * v;
  after.v += h / 6 * a;
  after.t += h;
  return after;
}
