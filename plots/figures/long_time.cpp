#include "engine/integrators/catalogue.h"
#include "tools.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace muelle::plots::long_time {

namespace {

constexpr double period = 2.0 * std::numbers::pi;
constexpr double h = 0.5;  // h omega

/// The largest energy error so far, at every step, drawn where it is 2 % later than before.
void addDrift(Figure::PanelBuilder& panel, const engine::ModelSystem& system, const std::string& id) {
  const double E0 = system.totalEnergy(system.initialState());
  // Energies equal to the last bit still have a place on the axis.
  double largest = std::numeric_limits<double>::epsilon();
  double next = 0.5 * period;
  std::vector<double> periods, errors;
  engine::RunOptions options;
  options.h = h;
  options.fixedStep = true;
  options.duration = 1e5 * period;
  options.checkStability = options.checkNumericalDamping = options.keepStates = false;
  options.probes = {{"energy", "J", [&](const State& state) {
                       const double E = system.totalEnergy(state);
                       largest = std::max(largest, std::abs(E / E0 - 1.0));
                       if (state.t >= next) {
                         periods.push_back(state.t / period);
                         errors.push_back(largest);
                         next = 1.02 * state.t;
                       }
                       return E;
                     }}};
  engine::simulate(system, *engine::makeMethod(id), system.initialState(), options);
  panel.line(engine::methodInfo(id).name, periods, errors);
}

}  // namespace

/// What remains of the energy of an oscillator after a hundred thousand periods at h omega = 0.5.
Figure long_time() {
  const auto system = engine::build(oscillator(1.0, 1.0, 1.0));
  Figure figure("long_time", "After 10⁵ periods symplectic methods still have the energy, Runge-Kutta has lost it",
                "periods");
  figure.slide();
  auto panel = figure.panel("largest relative energy error so far");
  panel.logX().logY().xRange(0.5, 1e5).yRange(1e-16, 10.0);
  for (const std::string id : {"runge_kutta_4", "velocity_verlet", "yoshida4", "kahan_li_8", "implicit_midpoint"}) {
    addDrift(panel, *system, id);
  }
  return figure;
}

}  // namespace muelle::plots::long_time
