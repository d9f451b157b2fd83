#include "engine/analysis/stability.h"

#include "engine/analysis/amplification.h"
#include "engine/analysis/first_failure.h"

#include <fmt/format.h>
#include <cmath>
#include <numbers>
#include <vector>

namespace muelle::engine {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// The growth that a step of h gives the mode; 1 for what grows by its physics.
double growthOf(Amplification& amplification, const Mode& mode, double h) {
  if (mode.stiffness < 0.0) return 1.0;
  return amplification.growth(h * h * mode.stiffness, h * std::max(mode.damping, 0.0), h * mode.drag);
}

/// Largest h without growth of this mode [s].
double limitOf(Amplification& amplification, const Mode& mode) {
  const double rate = mode.rate();
  if (!(rate > 0.0)) return infinite;
  const bool damped = mode.damping + mode.drag > 1e-9 * rate;
  if (!damped && mode.stiffness > 0.0) return amplification.imaginaryLimit() / rate;
  const auto holds = [&](double z) {
    const double growth = growthOf(amplification, mode, z / rate);
    return std::isnan(growth) || growth <= 1.0 + roundingGrowth;
  };
  return firstFailure(holds, 300.0, damped) / rate;
}

/// Rounding may leave a stiffness of 0 at -1e-16 of the largest.
std::vector<Mode> cleanModes(const LinearisedSystem& system, int dimension = 40) {
  std::vector<Mode> modes = extremeModes(system, dimension);
  double largest = 0.0;
  for (const Mode& mode : modes) largest = std::max(largest, std::abs(mode.stiffness));
  for (Mode& mode : modes) {
    if (std::abs(mode.stiffness) < 1e-13 * largest) mode.stiffness = 0.0;
  }
  return modes;
}

std::string describe(const Mode& mode, const std::string& unknown) {
  const double c = mode.damping + mode.drag;
  const bool overdamped = 0.25 * c * c > mode.stiffness;
  if (overdamped) return fmt::format("a mode at {} (damping rate {:.4g} /s)", unknown, c);
  const double w = mode.frequency();
  return fmt::format("a mode at {} (omega = {:.4g} /s, {:.3g} Hz)", unknown, w, w / (2.0 * std::numbers::pi));
}

std::string sentenceOf(const StabilityReport& report, const MethodInfo& method) {
  if (std::isinf(report.largestStep)) return fmt::format("{} is stable here with every step", method.name);
  const std::string mode = describe(report.mode, report.unknown);
  if (report.largestStep == 0.0) {
    return fmt::format("{} is unstable here with every step: {} grows", method.name, mode);
  }
  return fmt::format("{} is stable here up to h = {:.6g} s; {} sets the limit", method.name, report.largestStep, mode);
}

/// The state with everything closed that may close.
State closed(const DynamicalSystem& system, State state) {
  if (system.switching() != nullptr) system.switching()->close(state);
  return state;
}

/// Whether the method is known to be stable with every step.
bool isUnconditional(const MethodInfo& method) {
  return method.stability == Stability::AStable || method.stability == Stability::LStable;
}

/// The largest step without growth, and the mode that sets it.
StabilityReport limitOf(Integrator& method, const std::vector<Mode>& modes) {
  StabilityReport result;
  Amplification amplification(method);
  for (const Mode& mode : modes) {
    // A full scan only for a mode that could lower the limit: one that grows somewhere below it.
    bool lower = std::isinf(result.largestStep);
    for (double part = 1.0; part > 0.05 && !lower; part *= 0.8) {
      lower = growthOf(amplification, mode, part * result.largestStep) > 1.0 + roundingGrowth;
    }
    const double limit = lower ? limitOf(amplification, mode) : infinite;
    if (limit >= result.largestStep) continue;
    result.largestStep = limit;
    result.mode = mode;
    if (limit == 0.0) break;
  }
  return result;
}

StabilityReport report(const DynamicalSystem& system, Integrator& method, const std::vector<Mode>& modes) {
  StabilityReport result = limitOf(method, modes);
  if (result.mode.unknown >= 0) result.unknown = system.unknownName(result.mode.unknown);
  result.sentence = sentenceOf(result, method.info());
  return result;
}

/// The dimension of the subspaces that a look may take: all that it wants where the budget has it, less without
/// matrices, for then there is nothing else to look at; 0 where there is too little.
int affordable(const LinearisedSystem& system, const LookBudget& budget) {
  constexpr int wanted = 40;
  if (budget.covers(extremeModesCost(system, wanted))) return wanted;
  if (system.stiffnessMatrix() != nullptr) return 0;
  return budget.affordable(wanted, [&](int dimension) { return extremeModesCost(system, dimension); });
}

/// "up to h = 0.002 s, by a bound from one pass over the springs".
std::string sureSentence(const DynamicalSystem& system, const std::string& method, double sure,
                         const SpectrumBound& bound) {
  const std::string why = fmt::format(
      "a bound from one pass over the springs (omega at most {:.4g} /s, about {}), for a look at the modes costs too "
      "much",
      std::sqrt(bound.stiffness), system.unknownName(bound.unknown));
  if (sure == 0.0) return fmt::format("no step of {} is surely stable, by {}", method, why);
  return fmt::format("{} is surely stable up to h = {:.6g} s, by {}", method, sure, why);
}

std::string boundWarning(const LinearisedSystem& linearised, Integrator& method, double h, LookBudget& budget) {
  const std::optional<SpectrumBound> bound = spectrumBound(linearised);
  if (!bound) return {};
  budget.spend(spectrumBoundCost);
  const double sure = sureStep(method, *bound);
  if (h <= sure) return {};
  return fmt::format("h = {:.4g} s may be unstable: {}", h,
                     sureSentence(linearised.system(), method.info().name, sure, *bound));
}

}  // namespace

StabilityReport stability(const DynamicalSystem& system, Integrator& method, const State& state) {
  if (isUnconditional(method.info())) return report(system, method, {});
  return report(system, method, cleanModes(LinearisedSystem(system, closed(system, state))));
}

// A mode of stiffness s and damping c has the limit of (q^2 s, q c) times q: so every mode within the bound has at
// least that of one on its rim, s = S and c <= C or c = C and s <= S. The rim is looked at in steps of a factor of 2,
// which may pass over a dip of the limit between two of them by a few per cent.
double sureStep(Integrator& method, const SpectrumBound& bound) {
  if (isUnconditional(method.info())) return infinite;
  constexpr double between = 0.95;
  std::vector<Mode> rim;
  const auto add = [&](double stiffness, double damping, double drag) {
    rim.push_back({.stiffness = stiffness, .damping = damping, .drag = drag, .unknown = bound.unknown});
  };
  add(bound.stiffness, 0.0, 0.0);
  if (bound.damping + bound.drag == 0.0) return limitOf(method, rim).largestStep;
  const std::vector<double> drags = bound.drag > 0.0 ? std::vector<double>{0.0, bound.drag} : std::vector<double>{0.0};
  for (const double drag : drags) {
    add(0.0, bound.damping, drag);
    for (double part = 1.0; part > 1e-3; part *= 0.5) {
      add(bound.stiffness, part * bound.damping, part * drag);
      add(part * part * bound.stiffness, bound.damping, drag);
    }
  }
  return between * limitOf(method, rim).largestStep;
}

std::string instabilityWarning(const DynamicalSystem& system, Integrator& method, const State& state, double h,
                               double steps, LookBudget& budget) {
  if (isUnconditional(method.info())) return {};
  const LinearisedSystem linearised(system, closed(system, state));
  budget.spend(assemblyCost(system));
  const int dimension = affordable(linearised, budget);
  if (dimension == 0) return boundWarning(linearised, method, h, budget);
  budget.spend(extremeModesCost(linearised, dimension));
  const std::vector<Mode> modes = cleanModes(linearised, dimension);
  Amplification amplification(method);
  double worst = 1.0;
  for (const Mode& mode : modes) {
    const double growth = growthOf(amplification, mode, h);
    if (growth > worst) worst = growth;
  }
  if (!(worst > 1.0 + roundingGrowth) || steps * std::log(worst) < std::log(10.0)) return {};
  return fmt::format("h = {:.4g} s is unstable, growing {:.4g} times a step: {}", h, worst,
                     report(system, method, modes).sentence);
}

std::string lateInstabilityWarning(const DynamicalSystem& system, const MethodInfo& method, const State& state,
                                   double h, LookBudget& budget) {
  if (isUnconditional(method) || !(method.imaginaryLimit > 0.0) || std::isinf(method.imaginaryLimit)) return {};
  if (!budget.covers(assemblyCost(system) + spectrumBoundCost)) return {};
  const LinearisedSystem linearised(system, state);
  budget.spend(assemblyCost(system));
  const int dimension = affordable(linearised, budget);
  if (dimension == 0) {
    const std::optional<SpectrumBound> bound = spectrumBound(linearised);
    if (!bound) return {};
    budget.spend(spectrumBoundCost);
    const double sure = method.imaginaryLimit / std::sqrt(bound->stiffness);
    if (h <= sure) return {};
    return fmt::format("t = {:.6g} s: h = {:.4g} s may be unstable from here on: {}", state.t, h,
                       sureSentence(system, method.name, sure, *bound));
  }
  budget.spend(extremeModesCost(linearised, dimension));
  Mode fastest;
  for (const Mode& mode : cleanModes(linearised, dimension)) {
    if (mode.stiffness > fastest.stiffness) fastest = mode;
  }
  if (fastest.unknown < 0 || h * fastest.frequency() <= method.imaginaryLimit) return {};
  return fmt::format(
      "t = {:.6g} s: h = {:.4g} s is unstable from here on: {} is stable up to h = {:.6g} s; {} sets the limit",
      state.t, h, method.name, method.imaginaryLimit / fastest.frequency(),
      describe(fastest, system.unknownName(fastest.unknown)));
}

}  // namespace muelle::engine
