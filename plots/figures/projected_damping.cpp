#include "tools.h"

#include <cmath>

namespace muelle::plots::projected_damping {

namespace {

const double k = 252.0, L0 = 1.0, d = 3.0, reducedMass = 0.75;

/// Hard case H07, "vibrate": nodes of 1 kg and 3 kg that turn about each other, on a spring let go stretched.
engine::Model pair() {
  engine::Model model;
  model.nodes.resize(2);
  model.nodes[0].m = 1.0;
  model.nodes[0].x = {0.9, 0.0, 0.0};
  model.nodes[0].v = {0.0, 3.6, 0.0};
  model.nodes[1].m = 3.0;
  model.nodes[1].x = {-0.3, 0.0, 0.0};
  model.nodes[1].v = {0.0, -1.2, 0.0};
  model.springs.push_back({.a = 0, .b = 1, .k = k, .L0 = L0, .dProjected = d});
  return model;
}

/// The length at which a pair of angular momentum J [kg m²/s] turns without vibrating: k (L - L0) = J^2 / (mu L^3).
double turningLength(double J) {
  double low = L0, high = 2.0 * L0;
  for (int i = 0; i < 60; ++i) {
    const double L = 0.5 * (low + high);
    (k * (L - L0) < J * J / (reducedMass * L * L * L) ? low : high) = L;
  }
  return low;
}

std::vector<double> dividedByFirst(std::vector<double> values) {
  const double first = values.front();
  for (double& value : values) value /= first;
  return values;
}

}  // namespace

/// Slide "Amortiguamiento", "the best of the three": a pair that turns and vibrates. The vibration dies, the turning
/// does not.
Figure projected_damping() {
  const auto system = engine::build(pair());
  const double duration = 2.0;
  const Trajectory trajectory = run(*system, "runge_kutta_4", 1e-3, duration, 5e-3).trajectory;
  const auto& t = trajectory.t;
  const double J = system->angularMomentum(system->initialState()).z(), turning = turningLength(J);
  const double turningEnergy =
      0.5 * k * (turning - L0) * (turning - L0) + 0.5 * J * J / (reducedMass * turning * turning);
  std::vector<double> expected;
  for (const double time : t) expected.push_back(std::exp(-d / reducedMass * time));

  Figure figure("projected_damping", "Projected damping takes the vibration and leaves the rotation", "time [s]");
  figure.slide(2);
  figure.panel("length L [m]")
      .heading("the pair stops vibrating")
      .line("", t,
            along(trajectory, [&](const State& s) { return (system->position(s, 0) - system->position(s, 1)).norm(); }))
      .reference("turning only", {0.0, duration}, {turning, turning})
      .yRange(0.95, 1.25);
  figure.panel("")
      .heading("divided by the value at the start")
      .line("", t, dividedByFirst(along(trajectory, [&](const State& s) { return system->angularMomentum(s).z(); })))
      .colour(2)
      .line("", t,
            dividedByFirst(along(trajectory, [&](const State& s) { return system->totalEnergy(s) - turningEnergy; })))
      .colour(0)
      .reference("exp(−d t / μ)", t, expected)
      .note(1.1, 1.05, "angular momentum")
      .note(0.42, 0.27, "energy of the vibration")
      .yRange(0.0, 1.2);
  return figure;
}

}  // namespace muelle::plots::projected_damping
