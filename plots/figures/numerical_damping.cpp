#include "engine/integrators/catalogue.h"
#include "tools.h"

#include <fmt/format.h>
#include <cmath>
#include <numbers>

namespace muelle::plots::numerical_damping {

/// Backward Euler damps by itself: a spring without any damping, swinging once a second.
Figure numerical_damping() {
  const double omega = 2.0 * std::numbers::pi;
  const auto system = engine::build(oscillator(1.0, omega * omega, 1.0));
  Figure figure("numerical_damping", "Backward Euler damps a spring that has no damping", "time [s]");
  figure.slide(2);
  auto motion = figure.panel("position [m]");
  motion.heading("one period takes 1 s");
  for (const int perSecond : {60, 240, 960}) {
    const engine::RunResult result = run(*system, "backward_euler", 1.0 / perSecond, 6.0);
    motion.line(fmt::format("{} steps/s", perSecond), result.trajectory.t, result.trajectory.position(0));
  }
  auto left = figure.panel("amplitude left");
  left.heading("after 6 s, by method").xLabel("step [s]").logX();
  for (const std::string id : {"backward_euler", "bdf2", "implicit_midpoint"}) {
    std::vector<double> steps, amplitudes;
    for (const double h : logarithmic(3e-4, 0.15, 14)) {
      const engine::RunResult result = run(*system, id, h, 6.0, 6.0);
      const double E = system->totalEnergy(result.last), E0 = system->totalEnergy(system->initialState());
      steps.push_back(h);
      amplitudes.push_back(std::sqrt(E / E0));
    }
    left.linePoints(engine::methodInfo(id).name, steps, amplitudes);
  }
  left.xRange(2e-4, 0.2).yRange(-0.05, 1.1);
  return figure;
}

}  // namespace muelle::plots::numerical_damping
