#include "engine/integrators/catalogue.h"
#include "tools.h"

#include <cmath>
#include <numbers>

namespace muelle::plots {

/// What a method does to the energy of an undamped elastic pendulum (hard case H04) over a hundred seconds.
Figure energy_drift() {
  const auto system = engine::build(elasticPendulum());
  const double E0 = system->totalEnergy(system->initialState());
  // What can swing: the energy above that of hanging at rest, k s^2 / 2 - m g (L0 + s) with s = m g / k.
  const double rest = -9.81 - 0.5 * 9.81 * 9.81 / 100.0;

  Figure figure("energy_drift", "Energy drifts with Euler and Runge-Kutta, stays in a band with symplectic methods",
                "time [s]");
  figure.slide();
  auto panel = figure.panel("largest energy error so far / energy of the swing");
  panel.logY();
  for (const std::string id : {"explicit_euler", "backward_euler", "runge_kutta_4", "velocity_verlet",
                               "implicit_midpoint", "discrete_gradient"}) {
    const engine::RunResult result = run(*system, id, 0.01, 100.0);
    std::vector<double> t, error;
    double largest = 0.0;
    for (std::size_t i = 1; i < result.trajectory.t.size(); ++i) {
      const State state{result.trajectory.t[i], result.trajectory.x[i], result.trajectory.v[i], {}};
      largest = std::max(largest, std::abs(system->totalEnergy(state) - E0) / (E0 - rest));
      if (i % 20 != 0) continue;
      t.push_back(state.t);
      error.push_back(std::max(largest, 1e-17));
    }
    panel.line(engine::methodInfo(id).name, t, error);
  }
  panel.xRange(0.0, 100.0).yRange(1e-16, 1e3);
  return figure;
}

}  // namespace muelle::plots
