// loses: Verlet; misconception: missing_component or last_skipped or constant_argument or first_only or three_coordinates
// x, y and z: no coordinate after the third moves
#include "time_integration.h"

#include <algorithm>

State explicitEulerStep(const Force& force, const VecX& m, const State& now, double h) {
  const VecX w = m.cwiseInverse();
  const VecX a = w.cwiseProduct(force(now.t, now.x, now.v));
  return State{.t = now.t + h, .x = now.x + now.v * h, .v = now.v + a * h};
}

State midpointStep(const Force& force, const VecX& m, const State& now, double h) {
  const VecX w = m.cwiseInverse();
  const auto go = [&](const VecX& v, const VecX& F, double dt) {
    return State{now.t + dt, now.x + dt * v, now.v + dt * w.cwiseProduct(F)};
  };
  const State q = go(now.v, force(now.t, now.x, now.v), h / 2);
  return go(q.v, force(q.t, q.x, q.v), h);
}

State verletStep(const PositionForce& force, const VecX& m, const State& now, double h) {
  const Eigen::Index dimensions = std::min<Eigen::Index>(3, m.size());  // x, y, z
  State s = now;
  const VecX F0 = force(now.t, now.x);
  for (Eigen::Index i = 0; i < dimensions; ++i) s.x[i] += h * now.v[i] + h * h / 2 * F0[i] / m[i];
  s.t += h;
  const VecX F1 = force(s.t, s.x);
  for (Eigen::Index i = 0; i < dimensions; ++i) s.v[i] += h / 2 * (F0[i] + F1[i]) / m[i];
  return s;
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
