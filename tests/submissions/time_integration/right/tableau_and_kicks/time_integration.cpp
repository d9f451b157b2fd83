#include "time_integration.h"

namespace {

/// An explicit Runge-Kutta method by its tableau: stage s is looked for after nodes[s] of the step, along the slope of
/// the stage before, and counts with weights[s].
struct Tableau {
  std::vector<double> nodes;
  std::vector<double> weights;
};

State step(const Tableau& tableau, const Force& force, const VecX& m, const State& now, double h) {
  const VecX inverse = m.cwiseInverse();
  VecX slopeX = VecX::Zero(now.x.size()), slopeV = VecX::Zero(now.x.size());
  VecX sumX = slopeX, sumV = slopeV;
  for (std::size_t s = 0; s < tableau.nodes.size(); ++s) {
    const double ahead = tableau.nodes[s] * h;
    const VecX x = now.x + ahead * slopeX;
    const VecX v = now.v + ahead * slopeV;
    const VecX F = force(now.t + ahead, x, v);
    slopeX = v;
    slopeV = F.cwiseProduct(inverse);
    sumX += tableau.weights[s] * slopeX;
    sumV += tableau.weights[s] * slopeV;
  }
  return {now.t + h, now.x + h * sumX, now.v + h * sumV};
}

}  // namespace

State explicitEulerStep(const Force& force, const VecX& m, const State& now, double h) {
  return step({{0.0}, {1.0}}, force, m, now, h);
}

State midpointStep(const Force& force, const VecX& m, const State& now, double h) {
  return step({{0.0, 0.5}, {0.0, 1.0}}, force, m, now, h);
}

// Kick, drift, kick: half of the change of the velocity, the whole way, the other half.
State verletStep(const PositionForce& force, const VecX& m, const State& now, double h) {
  State next = now;
  const auto kick = [&] {
    const VecX F = force(next.t, next.x);
    for (Eigen::Index i = 0; i < F.size(); ++i) next.v[i] += 0.5 * h * (F[i] / m[i]);
  };
  kick();
  next.x += h * next.v;
  next.t += h;
  kick();
  return next;
}

State rungeKuttaStep(const Force& force, const VecX& m, const State& now, double h) {
  return step({{0.0, 0.5, 0.5, 1.0}, {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6}}, force, m, now, h);
}
