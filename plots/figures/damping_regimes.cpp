#include "tools.h"

#include <fmt/format.h>

namespace muelle::plots::damping_regimes {

/// Slide "Amortiguamiento": the three regimes of a damped spring (hard case H02).
Figure damping_regimes() {
  Figure figure("damping_regimes", "Damping: too little swings, too much creeps, critical returns first", "time [s]");
  figure.slide();
  auto panel = figure.panel("position [m]");
  for (const auto& [d, name] : {std::pair(2.0, "underdamped, d = 2 kg/s"), std::pair(20.0, "critical, d = 20 kg/s"),
                                std::pair(200.0, "overdamped, d = 200 kg/s")}) {
    const auto system = engine::build(oscillator(1.0, 100.0, 1.0, d));
    const engine::RunResult result = run(*system, "runge_kutta_4", 1e-3, 1.5, 5e-3);
    panel.line(name, result.trajectory.t, result.trajectory.position(0));
  }
  panel.structure("", {0.0, 1.5}, {0.0, 0.0});
  panel.note(1.0, -0.6, "m = 1 kg, k = 100 N/m");
  return figure;
}

}  // namespace muelle::plots::damping_regimes
