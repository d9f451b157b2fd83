// loses: RungeKutta; misconception: three_eighths
// the other method of Kutta, also of order 4
#include "time_integration.h"

namespace {

// divides each force by its own mass
VecX divide(VecX f, const VecX& m) {
  for (int i = 0; i < f.size(); i++) f(i) /= m(i);
  return f;
}

}  // namespace

State explicitEulerStep(const Force& force, const VecX& m, const State& now, double h) {
  const VecX acc = divide(force(now.t, now.x, now.v), m);
  State s = now;
  s.t += h;
  for (int i = 0; i < acc.size(); i++) {
    s.x(i) += h * now.v(i);
    s.v(i) += h * acc(i);
  }
  return s;
}

State midpointStep(const Force& force, const VecX& m, const State& now, double h) {
  const VecX acc = divide(force(now.t, now.x, now.v), m);
  State mid = now, s = now;
  mid.t += h / 2;
  for (int i = 0; i < acc.size(); i++) {
    mid.x(i) += h / 2 * now.v(i);
    mid.v(i) += h / 2 * acc(i);
  }
  const VecX accMid = divide(force(mid.t, mid.x, mid.v), m);
  s.t += h;
  for (int i = 0; i < acc.size(); i++) {
    s.x(i) += h * mid.v(i);
    s.v(i) += h * accMid(i);
  }
  return s;
}

State verletStep(const PositionForce& force, const VecX& m, const State& now, double h) {
  State s = now;
  s.t += h;
  const VecX before = divide(force(now.t, now.x), m);
  for (int i = 0; i < before.size(); i++) s.x(i) += h * now.v(i) + h * h * before(i) / 2;
  const VecX after = divide(force(s.t, s.x), m);
  for (int i = 0; i < before.size(); i++) s.v(i) += h * (before(i) + after(i)) / 2;
  return s;
}

State rungeKuttaStep(const Force& force, const VecX& m, const State& now, double h) {
  const VecX v1 = now.v;
  const VecX a1 = divide(force(now.t, now.x, v1), m);
  const VecX v2 = now.v + h / 3 * a1;
  const VecX a2 = divide(force(now.t + h / 3, now.x + h / 3 * v1, v2), m);
  const VecX v3 = now.v + h * (a2 - a1 / 3);
  const VecX a3 = divide(force(now.t + 2 * h / 3, now.x + h * (v2 - v1 / 3), v3), m);
  const VecX v4 = now.v + h * (a1 - a2 + a3);
  const VecX a4 = divide(force(now.t + h, now.x + h * (v1 - v2 + v3), v4), m);
  return {now.t + h, now.x + h / 8 * (v1 + 3 * v2 + 3 * v3 + v4), now.v + h / 8 * (a1 + 3 * a2 + 3 * a3 + a4)};
}
