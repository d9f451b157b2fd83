// loses: Verlet, Order, Stability, Energies, Reversibility; misconception: parabola_missing or integer_division
// 1 / 2 is 0
#include "time_integration.h"

namespace {

using Wide = Eigen::Matrix<long double, Eigen::Dynamic, 1>;

Wide wide(const VecX& a) { return a.cast<long double>(); }
VecX narrow(const Wide& a) { return a.cast<double>(); }

Wide over(const VecX& F, const VecX& m) { return wide(F).cwiseQuotient(wide(m)); }

}  // namespace

State explicitEulerStep(const Force& force, const VecX& m, const State& now, double h) {
  const Wide a = over(force(now.t, now.x, now.v), m);
  const long double H = h;
  return {now.t + h, narrow(wide(now.x) + H * wide(now.v)), narrow(wide(now.v) + H * a)};
}

State midpointStep(const Force& force, const VecX& m, const State& now, double h) {
  const long double H = h;
  const Wide x = wide(now.x), v = wide(now.v);
  const Wide vm = v + H / 2 * over(force(now.t, now.x, now.v), m);
  const Wide am = over(force(now.t + h / 2, narrow(x + H / 2 * v), narrow(vm)), m);
  return {now.t + h, narrow(x + H * vm), narrow(v + H * am)};
}

State verletStep(const PositionForce& force, const VecX& m, const State& now, double h) {
  const VecX a0 = force(now.t, now.x).cwiseQuotient(m);
  const VecX x1 = now.x + h * now.v + 1 / 2 * h * h * a0;
  const VecX a1 = force(now.t + h, x1).cwiseQuotient(m);
  return {now.t + h, x1, now.v + h * (a0 + a1) / 2.0};
}

State rungeKuttaStep(const Force& force, const VecX& m, const State& now, double h) {
  const long double H = h, half = H / 2;
  const Wide x = wide(now.x), v = wide(now.v);
  const Wide a1 = over(force(now.t, now.x, now.v), m);
  const Wide v2 = v + half * a1;
  const Wide a2 = over(force(now.t + h / 2, narrow(x + half * v), narrow(v2)), m);
  const Wide v3 = v + half * a2;
  const Wide a3 = over(force(now.t + h / 2, narrow(x + half * v2), narrow(v3)), m);
  const Wide v4 = v + H * a3;
  const Wide a4 = over(force(now.t + h, narrow(x + H * v3), narrow(v4)), m);
  const Wide dv = (v + v4) + 2.0L * (v2 + v3);
  const Wide da = (a1 + a4) + 2.0L * (a2 + a3);
  return {now.t + h, narrow(x + H / 6 * dv), narrow(v + H / 6 * da)};
}
