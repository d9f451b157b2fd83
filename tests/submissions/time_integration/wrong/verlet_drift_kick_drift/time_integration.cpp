// loses: Verlet, Evaluations; misconception: none
// position Verlet: another method of order 2, reversible too, with one question
#include "time_integration.h"

#include <vector>

namespace {

/// An explicit method in which each stage needs only the one before: its share of the step, and the weights.
struct Tableau {
  std::vector<double> c;
  std::vector<double> b;
};

State stepOf(const Tableau& method, const Force& force, const VecX& m, const State& now, double h) {
  VecX kx = VecX::Zero(now.x.size());
  VecX kv = VecX::Zero(now.v.size());
  VecX dx = kx, dv = kv;
  for (std::size_t s = 0; s < method.c.size(); ++s) {
    const double part = method.c[s] * h;
    const VecX x = now.x + part * kx;
    const VecX v = now.v + part * kv;
    kv = force(now.t + part, x, v).cwiseQuotient(m);
    kx = v;
    dx += method.b[s] * kx;
    dv += method.b[s] * kv;
  }
  return {now.t + h, now.x + h * dx, now.v + h * dv};
}

}  // namespace

State explicitEulerStep(const Force& force, const VecX& m, const State& now, double h) {
  return stepOf({{0.0}, {1.0}}, force, m, now, h);
}

State midpointStep(const Force& force, const VecX& m, const State& now, double h) {
  return stepOf({{0.0, 0.5}, {0.0, 1.0}}, force, m, now, h);
}

State verletStep(const PositionForce& force, const VecX& m, const State& now, double h) {
  State s = now;
  s.x += h / 2 * s.v;
  s.t += h / 2;
  s.v += h * force(s.t, s.x).cwiseQuotient(m);
  s.x += h / 2 * s.v;
  s.t = now.t + h;
  return s;
}

State rungeKuttaStep(const Force& force, const VecX& m, const State& now, double h) {
  return stepOf({{0.0, 0.5, 0.5, 1.0}, {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6}}, force, m, now, h);
}
