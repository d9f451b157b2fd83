#include "engine/integrators/catalogue.h"
#include "tools.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

namespace muelle::plots::energy_drift {

namespace {

constexpr double h = 0.01, duration = 100.0, most = 1e3;

struct Drift {
  std::vector<double> t, error;
};

/// The largest energy error so far, as a part of what can swing: the energy above that of hanging at rest,
/// k s^2 / 2 - m g (L0 + s) with s = m g / k.
Drift driftOf(const engine::ModelSystem& system, const std::string& method) {
  const double E0 = system.totalEnergy(system.initialState());
  const double rest = -9.81 - 0.5 * 9.81 * 9.81 / 100.0;
  const engine::RunResult result = run(system, method, h, duration);
  Drift drift;
  double largest = 0.0;
  for (std::size_t i = 1; i < result.trajectory.t.size(); ++i) {
    const State state{result.trajectory.t[i], result.trajectory.x[i], result.trajectory.v[i], {}};
    largest = std::max(largest, std::abs(system.totalEnergy(state) - E0) / (E0 - rest));
    if (i % 20 != 0) continue;
    drift.t.push_back(state.t);
    drift.error.push_back(std::max(largest, 1e-17));
  }
  return drift;
}

/// Draws the curve, and its name at t [s], so many times higher; a curve that leaves the picture says when.
void addDrift(Figure::PanelBuilder& panel, const engine::ModelSystem& system, const std::string& id,
              const std::string& fate, double t = 42.0, double above = 3.5) {
  const Drift drift = driftOf(system, id);
  panel.line("", drift.t, drift.error);
  const std::string& name = engine::methodInfo(id).name;
  const auto exit = std::find_if(drift.error.begin(), drift.error.end(), [](double e) { return e > most; });
  if (exit != drift.error.end()) {
    const double exitTime = drift.t[static_cast<std::size_t>(exit - drift.error.begin())];
    panel.note(exitTime + 1.0, 0.15 * most,
               fmt::format("{}: {}, leaves the picture at {:.0f} s", name, fate, exitTime));
  } else {
    panel.note(t, above * drift.error[drift.error.size() / 2], fmt::format("{}: {}", name, fate));
  }
}

}  // namespace

/// What a method does to the energy of an undamped elastic pendulum (hard case H04) over a hundred seconds.
Figure energy_drift() {
  const auto system = engine::build(elasticPendulum());
  Figure figure("energy_drift", "Energy drifts with Euler and Runge-Kutta, stays in a band with symplectic methods",
                "time [s]");
  figure.slide();
  auto panel = figure.panel("largest energy error so far ÷ energy of the swing");
  panel.heading("elastic pendulum, h = 10 ms").logY();
  addDrift(panel, *system, "explicit_euler", "grows");
  addDrift(panel, *system, "backward_euler", "all is lost");
  addDrift(panel, *system, "runge_kutta_4", "drifts", 42.0, 0.1);
  addDrift(panel, *system, "velocity_verlet", "a band");
  addDrift(panel, *system, "implicit_midpoint", "a band", 3.0, 0.25);
  addDrift(panel, *system, "discrete_gradient", "kept to round-off");
  panel.xRange(0.0, duration).yRange(1e-16, most);
  return figure;
}

}  // namespace muelle::plots::energy_drift
