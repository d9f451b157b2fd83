// loses: RungeKutta, Order, Stability, Energies; misconception: positions_by_old_velocity
// the positions asked at are x + v0 h / 2 and x + v0 h
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
  const long double H = h;
  const Wide a0 = over(force(now.t, now.x), m);
  const VecX x1 = narrow(wide(now.x) + H * wide(now.v) + H * H / 2 * a0);
  const Wide a1 = over(force(now.t + h, x1), m);
  return {now.t + h, x1, narrow(wide(now.v) + H / 2 * (a0 + a1))};
}

State rungeKuttaStep(const Force& force, const VecX& m, const State& now, double h) {
  const VecX xHalf = now.x + h / 2 * now.v;
  const VecX xEnd = now.x + h * now.v;
  const VecX a1 = force(now.t, now.x, now.v).cwiseQuotient(m);
  const VecX v2 = now.v + h / 2 * a1;
  const VecX a2 = force(now.t + h / 2, xHalf, v2).cwiseQuotient(m);
  const VecX v3 = now.v + h / 2 * a2;
  const VecX a3 = force(now.t + h / 2, xHalf, v3).cwiseQuotient(m);
  const VecX v4 = now.v + h * a3;
  const VecX a4 = force(now.t + h, xEnd, v4).cwiseQuotient(m);
  return {now.t + h, now.x + h / 6 * (now.v + 2 * v2 + 2 * v3 + v4), now.v + h / 6 * (a1 + 2 * a2 + 2 * a3 + a4)};
}
