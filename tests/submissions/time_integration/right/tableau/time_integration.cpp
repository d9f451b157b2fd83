#include "time_integration.h"

#include <vector>

// All three of the first kind from one function and their tableaus
static State rk(const std::vector<double>& c, const std::vector<double>& b, const Force& force, const VecX& m,
                const State& now, double h) {
  const VecX w = m.cwiseInverse();
  VecX kx = VecX::Zero(m.size()), kv = VecX::Zero(m.size());
  VecX sumX = kx, sumV = kv;
  for (std::size_t i = 0; i < c.size(); ++i) {
    const VecX x = now.x + c[i] * h * kx;
    const VecX v = now.v + c[i] * h * kv;
    kx = v;
    kv = w.cwiseProduct(force(now.t + c[i] * h, x, v));
    sumX += b[i] * kx;
    sumV += b[i] * kv;
  }
  return {now.t + h, now.x + h * sumX, now.v + h * sumV};
}

State explicitEulerStep(const Force& force, const VecX& m, const State& now, double h) {
  return rk({0.}, {1.}, force, m, now, h);
}
State midpointStep(const Force& force, const VecX& m, const State& now, double h) {
  return rk({0., .5}, {0., 1.}, force, m, now, h);
}
State rungeKuttaStep(const Force& force, const VecX& m, const State& now, double h) {
  return rk({0., .5, .5, 1.}, {1. / 6, 1. / 3, 1. / 3, 1. / 6}, force, m, now, h);
}

State verletStep(const PositionForce& force, const VecX& m, const State& now, double h) {
  const VecX w = m.cwiseInverse();
  const VecX middle = now.v + 0.5 * h * w.cwiseProduct(force(now.t, now.x));
  State next{now.t + h, now.x + h * middle, middle};
  next.v += 0.5 * h * w.cwiseProduct(force(next.t, next.x));
  return next;
}
