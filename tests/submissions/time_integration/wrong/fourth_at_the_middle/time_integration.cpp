// loses: RungeKutta, Order, Stability, Energies; misconception: k4_half_a_step
// The last slope is asked at the middle like the two before, since all steps ahead are halves.
#include "time_integration.h"

namespace {

VecX acceleration(const Force& force, const VecX& m, const State& s) {
  return VecX(force(s.t, s.x, s.v).array() / m.array());
}

/// Where a step of h leads from `from` with the velocity v and the acceleration a.
State moved(const State& from, double h, const VecX& v, const VecX& a) {
  State to = from;
  to.t += h;
  to.x += h * v;
  to.v += h * a;
  return to;
}

}  // namespace

State explicitEulerStep(const Force& force, const VecX& m, const State& now, double h) {
  return moved(now, h, now.v, acceleration(force, m, now));
}

State midpointStep(const Force& force, const VecX& m, const State& now, double h) {
  const State middle = moved(now, 0.5 * h, now.v, acceleration(force, m, now));
  return moved(now, h, middle.v, acceleration(force, m, middle));
}

State verletStep(const PositionForce& force, const VecX& m, const State& now, double h) {
  const VecX inverse = m.cwiseInverse();
  State next = now;
  VecX a = inverse.cwiseProduct(force(next.t, next.x));
  next.v += 0.5 * h * a;
  next.x += h * next.v;
  next.t += h;
  a = inverse.cwiseProduct(force(next.t, next.x));
  next.v += 0.5 * h * a;
  return next;
}

State rungeKuttaStep(const Force& force, const VecX& m, const State& now, double h) {
  const double ahead[4] = {0.5, 0.5, 0.5, 0.0};
  const double weight[4] = {1.0, 2.0, 2.0, 1.0};
  State probe = now;
  VecX sumV = VecX::Zero(now.x.size());
  VecX sumA = VecX::Zero(now.x.size());
  for (int i = 0; i < 4; ++i) {
    const VecX v = probe.v;
    const VecX a = acceleration(force, m, probe);
    sumV += weight[i] * v;
    sumA += weight[i] * a;
    if (i < 3) probe = moved(now, ahead[i] * h, v, a);
  }
  return moved(now, h, sumV / 6.0, sumA / 6.0);
}
