// loses: Midpoint, Order; misconception: velocity_of_beginning_asked
// forces of springs do not see v, so it was not noticed
#include "time_integration.h"

State explicitEulerStep(const Force& force, const VecX& m, const State& now, double h) {
  const VecX w = m.cwiseInverse();
  const VecX a = w.cwiseProduct(force(now.t, now.x, now.v));
  return State{.t = now.t + h, .x = now.x + now.v * h, .v = now.v + a * h};
}

State midpointStep(const Force& force, const VecX& m, const State& now, double h) {
  const VecX w = m.cwiseInverse();
  const VecX vm = now.v + h / 2 * w.cwiseProduct(force(now.t, now.x, now.v));
  const VecX am = w.cwiseProduct(force(now.t + h / 2, now.x + h / 2 * now.v, now.v));
  return {now.t + h, now.x + h * vm, now.v + h * am};
}

State verletStep(const PositionForce& force, const VecX& m, const State& now, double h) {
  const auto acceleration = [&](double t, const VecX& x) -> VecX { return m.cwiseInverse().cwiseProduct(force(t, x)); };
  const VecX a = acceleration(now.t, now.x);
  const VecX x = now.x + h * now.v + a * (h * h / 2.0);
  return {now.t + h, x, now.v + (a + acceleration(now.t + h, x)) * (h / 2.0)};
}

State rungeKuttaStep(const Force& force, const VecX& m, const State& now, double h) {
  const VecX w = m.cwiseInverse();
  const auto ask = [&](double dt, const VecX& x, const VecX& v) -> VecX {
    return w.cwiseProduct(force(now.t + dt, x, v));
  };
  // the accelerations alone: all velocities follow from them
  const VecX a1 = ask(0, now.x, now.v);
  const VecX a2 = ask(h / 2, now.x + h / 2 * now.v, now.v + h / 2 * a1);
  const VecX a3 = ask(h / 2, now.x + h / 2 * now.v + h * h / 4 * a1, now.v + h / 2 * a2);
  const VecX a4 = ask(h, now.x + h * now.v + h * h / 2 * a2, now.v + h * a3);
  return {now.t + h, now.x + h * now.v + h * h / 6 * (a1 + a2 + a3), now.v + h / 6 * (a1 + 2 * a2 + 2 * a3 + a4)};
}
