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
  const double part[4] = {0.0, h / 2, h / 2, h};
  const double weight[4] = {1, 2, 2, 1};
  const long n = now.x.size();
  State sum = now;
  VecX kv = VecX::Zero(n), ka = VecX::Zero(n);
  for (int stage = 0; stage < 4; stage++) {
    VecX x(n), v(n);
    for (long i = 0; i < n; i++) {
      x(i) = now.x(i) + part[stage] * kv(i);
      v(i) = now.v(i) + part[stage] * ka(i);
    }
    ka = divide(force(now.t + part[stage], x, v), m);
    kv = v;
    for (long i = 0; i < n; i++) {
      sum.x(i) += h * weight[stage] / 6 * kv(i);
      sum.v(i) += h * weight[stage] / 6 * ka(i);
    }
  }
  sum.t = now.t + h;
  return sum;
}
