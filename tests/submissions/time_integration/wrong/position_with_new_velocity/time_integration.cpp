// loses: ExplicitEuler, Stability, Energies; misconception: symplectic_euler
// The velocity is updated first and the position with the new one, which is symplectic Euler.
#include "time_integration.h"

State explicitEulerStep(const Force& force, const VecX& m, const State& now, double h) {
  int n = (int)now.x.size();
  VecX F = force(now.t, now.x, now.v);
  State next = now;
  for (int i = 0; i < n; i++) {
    next.v(i) = now.v(i) + h * F(i) / m(i);
    next.x(i) = now.x(i) + h * next.v(i);
  }
  next.t = now.t + h;
  return next;
}

State midpointStep(const Force& force, const VecX& m, const State& now, double h) {
  int n = (int)now.x.size();
  VecX F = force(now.t, now.x, now.v);
  VecX xm(n), vm(n);
  for (int i = 0; i < n; i++) {
    xm(i) = now.x(i) + h / 2 * now.v(i);
    vm(i) = now.v(i) + h / 2 * F(i) / m(i);
  }
  VecX Fm = force(now.t + h / 2, xm, vm);
  State next;
  next.t = now.t + h;
  next.x = VecX(n);
  next.v = VecX(n);
  for (int i = 0; i < n; i++) {
    next.x(i) = now.x(i) + h * vm(i);
    next.v(i) = now.v(i) + h * Fm(i) / m(i);
  }
  return next;
}

State verletStep(const PositionForce& force, const VecX& m, const State& now, double h) {
  int n = (int)now.x.size();
  State next;
  next.t = now.t + h;
  next.x = VecX(n);
  next.v = VecX(n);
  VecX F0 = force(now.t, now.x);
  for (int i = 0; i < n; i++) {
    next.x(i) = now.x(i) + h * now.v(i) + 0.5 * h * h * F0(i) / m(i);
  }
  VecX F1 = force(next.t, next.x);
  for (int i = 0; i < n; i++) {
    next.v(i) = now.v(i) + 0.5 * h * (F0(i) / m(i) + F1(i) / m(i));
  }
  return next;
}

State rungeKuttaStep(const Force& force, const VecX& m, const State& now, double h) {
  int n = (int)now.x.size();
  double half = h / 2;
  VecX k1v(n), k2v(n), k3v(n), k4v(n);
  VecX k1a(n), k2a(n), k3a(n), k4a(n);
  VecX x(n), F(n);

  k1v = now.v;
  F = force(now.t, now.x, k1v);
  for (int i = 0; i < n; i++) k1a(i) = F(i) / m(i);

  for (int i = 0; i < n; i++) {
    x(i) = now.x(i) + half * k1v(i);
    k2v(i) = now.v(i) + half * k1a(i);
  }
  F = force(now.t + half, x, k2v);
  for (int i = 0; i < n; i++) k2a(i) = F(i) / m(i);

  for (int i = 0; i < n; i++) {
    x(i) = now.x(i) + half * k2v(i);
    k3v(i) = now.v(i) + half * k2a(i);
  }
  F = force(now.t + half, x, k3v);
  for (int i = 0; i < n; i++) k3a(i) = F(i) / m(i);

  for (int i = 0; i < n; i++) {
    x(i) = now.x(i) + h * k3v(i);
    k4v(i) = now.v(i) + h * k3a(i);
  }
  F = force(now.t + h, x, k4v);
  for (int i = 0; i < n; i++) k4a(i) = F(i) / m(i);

  State next = now;
  for (int i = 0; i < n; i++) {
    next.x(i) += h / 6 * (k1v(i) + 2 * k2v(i) + 2 * k3v(i) + k4v(i));
    next.v(i) += h / 6 * (k1a(i) + 2 * k2a(i) + 2 * k3a(i) + k4a(i));
  }
  next.t += h;
  return next;
}
