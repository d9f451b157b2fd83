#include "engine/integrators/catalogue.h"
#include "tools.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace muelle::plots {

namespace {

/// Largest energy error so far at each output.
void addDrift(Figure::PanelBuilder& panel, const engine::ModelSystem& system, const std::string& id, double h,
              double duration, bool compensated) {
  engine::RunOptions options;
  options.h = h;
  options.fixedStep = true;
  options.duration = duration;
  options.compensated = compensated;
  options.checkStability = options.checkNumericalDamping = false;
  options.outputInterval = duration / 2000.0;
  const engine::RunResult result = engine::simulate(system, *engine::makeMethod(id), system.initialState(), options);
  const double period = 2.0 * std::numbers::pi;
  const double E0 = system.totalEnergy(system.initialState());
  std::vector<double> periods, error;
  double largest = 1e-17;
  for (std::size_t i = 1; i < result.trajectory.t.size(); ++i) {
    const State state{result.trajectory.t[i], result.trajectory.x[i], result.trajectory.v[i], {}};
    largest = std::max(largest, std::abs(system.totalEnergy(state) / E0 - 1.0));
    periods.push_back(state.t / period);
    error.push_back(largest);
  }
  panel.line(engine::methodInfo(id).name + (compensated ? ", compensated" : ""), periods, error);
}

}  // namespace

/// What remains of the energy of an oscillator after a hundred thousand periods (h omega = 0.5; the plot ends earlier
/// for methods that are lost).
Figure long_time() {
  const auto system = engine::build(oscillator(1.0, 1.0, 1.0));
  const double duration = 2.0 * std::numbers::pi * 1e5;
  Figure figure("long_time", "After 100000 periods only symplectic and energy-conserving methods still have the energy",
                "periods");
  figure.slide();
  auto panel = figure.panel("relative energy error");
  panel.logX().logY();
  for (const std::string id : {"runge_kutta_4", "velocity_verlet", "kahan_li_8", "implicit_midpoint"}) {
    addDrift(panel, *system, id, 0.5, duration, false);
  }
  addDrift(panel, *system, "implicit_midpoint", 0.5, duration, true);
  addDrift(panel, *system, "discrete_gradient", 0.5, duration, false);
  panel.yRange(1e-17, 10.0);
  return figure;
}

}  // namespace muelle::plots
