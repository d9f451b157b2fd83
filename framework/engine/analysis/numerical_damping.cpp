#include "engine/analysis/numerical_damping.h"

#include "engine/analysis/amplification.h"
#include "engine/analysis/spectrum.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace muelle::engine {

namespace {

double massProduct(const CompactSystem& system, const std::vector<double>& y) {
  double sum = 0.0;
  for (std::size_t i = 0; i < y.size(); ++i) sum += system.mass()[i] * y[i] * y[i];
  return sum;
}

/// Adds the modes that hold energy at a state, `energy` in joule.
void addModes(const DynamicalSystem& whole, const State& at, LookBudget& budget, std::vector<Mode>& modes) {
  if (!budget.covers(assemblyCost(whole))) return;
  const LinearisedSystem linearised(whole, at);
  budget.spend(assemblyCost(whole));
  const auto cost = [&](int dimension) { return 2.0 * modesOfCost(linearised, dimension); };  // two subspaces
  const int dimension = budget.affordable(24, cost);
  if (dimension == 0) return;
  budget.spend(cost(dimension));
  const CompactSystem& system = linearised.system();
  const State state = system.compact(at);
  const double kinetic = 0.5 * massProduct(system, state.v);
  for (Mode mode : modesOf(linearised, state.v, dimension)) {
    mode.energy *= kinetic;
    modes.push_back(mode);
  }
  std::vector<double> a(state.x.size());
  system.force(state.t, state.x, state.v, state.z, a);
  for (std::size_t i = 0; i < a.size(); ++i) a[i] /= system.mass()[i];
  const double size = 0.5 * massProduct(system, a);
  std::vector<Mode> loaded = modesOf(linearised, a, dimension);
  double stiffest = 0.0;
  for (const Mode& mode : loaded) stiffest = std::max(stiffest, mode.stiffness);
  for (Mode& mode : loaded) {
    if (!(mode.stiffness > 1e-9 * stiffest)) continue;  // moves freely: no elastic energy
    mode.energy *= size / mode.stiffness;
    modes.push_back(mode);
  }
}

/// The state after the pilot's steps, or the last that could be had.
State pilot(const DynamicalSystem& system, Integrator& method, State state, double h, int steps) {
  method.prepare(system, {});
  method.restart();
  State to = state;
  for (int n = 0; n < steps; ++n) {
    if (!method.step(system, state, h, to).done) break;
    method.accept();
    std::swap(state, to);
    if (system.switching() != nullptr && system.switching()->commit(state, false)) method.restart();
  }
  return state;
}

}  // namespace

StabilityFunctionLoss stabilityFunctionLoss(const DynamicalSystem& system, Integrator& method, const State& start,
                                            double h, double steps) {
  StabilityFunctionLoss loss;
  std::vector<Mode> modes;
  LookBudget unbounded;
  addModes(system, start, unbounded, modes);
  Amplification amplification(method);
  const auto kept = [&](double z) { return std::min(1.0, amplification.growth(z * z, 0.0)); };
  double lost = 0.0, total = 0.0;
  for (const Mode& mode : modes) {
    lost += mode.energy * (1.0 - std::pow(kept(h * mode.frequency()), 2.0 * steps));
    total += mode.energy;
  }
  if (total > 0.0) loss.share = lost / total;
  for (const Mode& mode : extremeModes(LinearisedSystem(system, start))) {
    loss.fastest = std::max(loss.fastest, h * mode.frequency());
  }
  loss.factor = kept(loss.fastest);
  return loss;
}

NumericalDamping numericalDamping(const DynamicalSystem& system, Integrator& method, const State& start, double h,
                                  double duration, LookBudget& budget) {
  NumericalDamping result;
  Amplification amplification(method);
  // Most methods keep the amplitude of an undamped mode: nothing to look for.
  constexpr double enough = 0.05;  // of the amplitude over the run
  const double steps = duration / h;
  const auto lossPerStep = [&](double z) {
    const double growth = amplification.growth(z * z, 0.0);
    return growth > 0.0 ? std::max(0.0, -std::log(std::min(growth, 1.0))) : 700.0;
  };
  if (!(steps * std::max(lossPerStep(0.5), lossPerStep(1.5)) > enough)) return result;

  State first = start;
  if (first.z.empty()) first.z.assign(static_cast<std::size_t>(system.internalSize()), 0.0);
  if (system.switching() != nullptr) system.switching()->commit(first, false);
  std::vector<Mode> modes;
  addModes(system, first, budget, modes);
  // The second half of the looks only in long runs, and where the budget has the pilot's steps and something for them.
  const int stages = std::max(1, method.info().stages);
  const int pilotSteps = steps * stages < 6000.0 ? 0 : static_cast<int>(std::min(10.0, steps / 20.0));
  const double pilotCost = static_cast<double>(pilotSteps) * stages;
  if (pilotSteps > 0 && budget.covers(pilotCost)) {
    budget.spend(pilotCost);
    addModes(system, pilot(system, method, first, h, pilotSteps), budget, modes);
  }

  double total = 0.0;
  for (const Mode& mode : modes) total += mode.energy;
  Mode worst;
  for (const Mode& mode : modes) {
    const double z = h * mode.frequency();
    if (!(z > 0.5) || mode.energy < 1e-3 * total) continue;
    const double loss = lossPerStep(z);
    if (loss * steps < enough || loss / h <= mode.decay()) continue;
    result.share += mode.energy / total;
    if (mode.energy > worst.energy) worst = mode;
  }
  if (result.share < 0.1) return result;
  result.exceeds = true;
  result.frequency = worst.frequency();
  result.numericalDecay = lossPerStep(h * result.frequency) / h;
  result.ownDecay = worst.decay();
  result.sentence = fmt::format(
      "{} with h = {:.4g} s: numerical damping exceeds yours: modes with {:.0f} % of the energy, the largest of {:.3g} "
      "Hz at {} (h omega = {:.3g}), decay at {:.3g} /s by the method and at {:.3g} /s by the scene's damping; take a "
      "shorter step, or a method that conserves energy",
      method.info().name, h, 100.0 * std::min(result.share, 1.0), result.frequency / (2.0 * std::numbers::pi),
      system.unknownName(worst.unknown), h * result.frequency, result.numericalDecay, result.ownDecay);
  return result;
}

}  // namespace muelle::engine
