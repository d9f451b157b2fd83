#include "lab/run/energy_climb.h"

#include "engine/analysis/amplification.h"
#include "engine/analysis/spectrum.h"
#include "engine/control/simulation.h"
#include "engine/integrators/catalogue.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace muelle::lab {

using namespace engine;

namespace {

/// Tells at which ends of steps the forces have switched, or the length of steps.
class SwitchWatch {
 public:
  SwitchWatch(const ModelSystem& system, const State& start, double h)
      : system_(system), h_(h), closed_(closedGuards(start)) {}

  /// \param state  at the end of the step
  bool hasSwitched(const State& state, const Advance& step) {
    const bool cut = std::abs(step.length - h_) > 1e-9 * h_;
    const std::vector<bool> closed = std::exchange(closed_, closedGuards(state));
    return step.hasJumped || cut || closed != closed_;
  }

 private:
  std::vector<bool> closedGuards(const State& state) const {
    const Switching* switching = system_.switching();
    if (switching == nullptr) return {};
    std::vector<double> guards(static_cast<std::size_t>(switching->guardCount()));
    switching->guards(state.t, state.x, state.v, state.z, guards);
    std::vector<bool> closed;
    for (const double guard : guards) closed.push_back(guard < 0.0);
    return closed;
  }

  const ModelSystem& system_;
  double h_;
  std::vector<bool> closed_;
};

/// What the energy may rise to from one switch to the next.
class Allowance {
 public:
  Allowance(double scale, double harmless, const OwnEnergy& own) : scale_(scale), harmless_(harmless), own_(own) {}

  double between() const { return rise(own_.swing); }
  /// In a step at which something switches.
  double across() const { return own_.stable ? rise(own_.swing * own_.swing) : between(); }
  /// Something has switched, and the energy [J], less the start's, is where the next rise begins.
  void startFrom(double energy) {
    if (own_.stable) from_ = std::max(0.0, energy);
  }

 private:
  double rise(double factor) const { return std::max(harmless_, from_ + (factor - 1.0) * (scale_ + from_)); }

  double scale_, harmless_;
  const OwnEnergy& own_;
  double from_ = 0.0;
};

}  // namespace

OwnEnergy ownEnergy(const ModelSystem& system, const std::string& id, const RunOptions& options) {
  OwnEnergy own;
  if (!options.fixedStep) return own;
  const std::unique_ptr<Integrator> method = makeMethod(id);
  Amplification amplification(*method);
  State state = system.initialState();
  if (system.switching() != nullptr) system.switching()->close(state);
  own.stable = true;
  const double h = options.h;
  for (const Mode& mode : extremeModes(LinearisedSystem(system, state))) {
    if (!(mode.stiffness > 0.0)) continue;
    const double growth = amplification.growth(h * h * mode.stiffness, h * std::max(mode.damping, 0.0), h * mode.drag);
    own.stable = own.stable && growth <= 1.0 + roundingGrowth;
    own.swing = std::max(own.swing, amplification.energySwing(h * mode.frequency()));
  }
  return own;
}

EnergyClimb energyClimb(const ModelSystem& system, const std::string& id, const StepOptions& options, double until,
                        double scale, double harmless, const OwnEnergy& own) {
  const std::unique_ptr<Integrator> method = makeMethod(id);
  Simulation simulation(system, *method, system.initialState(), options);
  SwitchWatch watch(system, simulation.state(), options.h);
  Allowance allowance(scale, harmless, own);
  const double start = system.totalEnergy(simulation.state());
  EnergyClimb climb{.allowed = allowance.between()};
  while (simulation.time() < until) {
    const Advance step = simulation.advance();
    if (!step.goesOn()) break;
    const double energy = system.totalEnergy(simulation.state()) - start;
    const bool switched = watch.hasSwitched(simulation.state(), step);
    const double allowed = switched ? allowance.across() : allowance.between();
    climb.highest = std::max(climb.highest, energy);
    if (energy > allowed) return {energy, allowed};
    climb.allowed = std::max(climb.allowed, allowed);
    if (switched) allowance.startFrom(energy);
  }
  return climb;
}

}  // namespace muelle::lab
