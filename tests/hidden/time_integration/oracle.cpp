/// \file
/// The expected values: Runge-Kutta methods as such, from their tableaus, on the stacked vector y = (x, v); Verlet as a
/// kick, a drift and a kick.

#include "time_integration.h"

namespace {

/// y' = g(t, y) for y = (x, v) in R^2n.
class FirstOrder {
 public:
  FirstOrder(const Force& force, const VecX& m) : force_(force), m_(m) {}

  VecX operator()(double t, const VecX& y) const {
    const VecX F = force_(t, y.head(m_.size()), y.tail(m_.size()));
    VecX slope = y;
    for (Eigen::Index i = 0; i < m_.size(); ++i) {
      slope[i] = y[m_.size() + i];
      slope[m_.size() + i] = F[i] / m_[i];
    }
    return slope;
  }

 private:
  const Force& force_;
  const VecX& m_;
};

VecX stacked(const State& state) {
  VecX y(state.x.size() + state.v.size());
  y << state.x, state.v;
  return y;
}

State parted(double t, const VecX& y) { return {t, y.head(y.size() / 2), y.tail(y.size() / 2)}; }

}  // namespace

namespace oracle {

State explicitEulerStep(const Force& force, const VecX& m, const State& now, double h) {
  const VecX y = stacked(now);
  return parted(now.t + h, y + h * FirstOrder(force, m)(now.t, y));
}

State midpointStep(const Force& force, const VecX& m, const State& now, double h) {
  const State middle = given::explicitEulerStep(force, m, now, 0.5 * h);
  return parted(now.t + h, stacked(now) + h * FirstOrder(force, m)(middle.t, stacked(middle)));
}

State verletStep(const PositionForce& force, const VecX& m, const State& now, double h) {
  State next = now;
  const auto kick = [&] { next.v.array() += 0.5 * h * force(next.t, next.x).array() / m.array(); };
  kick();
  next.x += h * next.v;
  next.t += h;
  kick();
  return next;
}

State rungeKuttaStep(const Force& force, const VecX& m, const State& now, double h) {
  const FirstOrder slope(force, m);
  const std::array<double, 4> lead = {0.0, 0.5, 0.5, 1.0};
  const std::array<double, 4> weight = {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6};
  VecX y = stacked(now);
  const VecX start = y;
  VecX k = VecX::Zero(y.size());
  for (std::size_t stage = 0; stage < 4; ++stage) {
    k = slope(now.t + lead[stage] * h, start + lead[stage] * h * k);
    y += weight[stage] * h * k;
  }
  return parted(now.t + h, y);
}

}  // namespace oracle
