#include "time_integration.h"

State explicitEulerStep(const Force& force, const VecX& m, const State& now, double h) {
  State next = now;
  const VecX F = force(now.t, now.x, now.v);
  for (int i = 0; i < m.size(); i++) {
    next.x[i] = now.x[i] + now.v[i] * h;
    next.v[i] = now.v[i] + F[i] / m[i] * h;
  }
  next.t += h;
  return next;
}

State midpointStep(const Force& force, const VecX& m, const State& now, double h) {
  const int n = static_cast<int>(m.size());
  VecX xm(n), vm(n);
  VecX F = force(now.t, now.x, now.v);
  for (int i = 0; i < n; i++) {
    xm[i] = now.x[i] + now.v[i] * h / 2;
    vm[i] = now.v[i] + F[i] / m[i] * h / 2;
  }
  F = force(now.t + h / 2, xm, vm);
  State next = now;
  for (int i = 0; i < n; i++) {
    next.x[i] += vm[i] * h;
    next.v[i] += F[i] / m[i] * h;
  }
  next.t += h;
  return next;
}

State verletStep(const PositionForce& force, const VecX& m, const State& now, double h) {
  const int n = static_cast<int>(m.size());
  State next = now;
  next.t += h;
  const VecX before = force(now.t, now.x);
  for (int i = 0; i < n; i++) next.x[i] += h * now.v[i] + 0.5 * h * h * before[i] / m[i];
  const VecX after = force(next.t, next.x);
  for (int i = 0; i < n; i++) next.v[i] += h * (before[i] + after[i]) / (2 * m[i]);
  return next;
}

State rungeKuttaStep(const Force& force, const VecX& m, const State& now, double h) {
  const int n = static_cast<int>(m.size());
  VecX kx[4], kv[4];
  const double part[4] = {0, h / 2, h / 2, h};
  for (int s = 0; s < 4; s++) {
    VecX x = now.x, v = now.v;
    if (s > 0) {
      for (int i = 0; i < n; i++) {
        x[i] += part[s] * kx[s - 1][i];
        v[i] += part[s] * kv[s - 1][i];
      }
    }
    kx[s] = v;
    kv[s] = force(now.t + part[s], x, v);
    for (int i = 0; i < n; i++) kv[s][i] /= m[i];
  }
  State next = now;
  next.t += h;
  for (int i = 0; i < n; i++) {
    next.x[i] += h * (kx[0][i] + 2 * kx[1][i] + 2 * kx[2][i] + kx[3][i]) / 6;
    next.v[i] += h * (kv[0][i] + 2 * kv[1][i] + 2 * kv[2][i] + kv[3][i]) / 6;
  }
  return next;
}
