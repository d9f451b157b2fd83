#include "lab/hard_cases/prediction.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace muelle::hard_cases {

namespace {

using engine::MethodInfo;

enum Rule { Refused, Missing, Growth, Cost, Ringing, Iteration, Conservation, Closed, Flight, LinearError, Tolerance };

/// The need of the method that the system does not meet; empty when it meets all.
std::string missingNeed(const MethodInfo& method, const engine::DynamicalSystem& system) {
  const engine::Needs& needs = method.needs;
  const engine::Drag* drag = system.drag();
  const bool onlyDrag = needs.dragAside && drag != nullptr && !drag->remainderUsesVelocity();
  if (needs.velocityFreeForce && system.forceUsesVelocity() && !onlyDrag) {
    return "a force that does not depend on the velocity";
  }
  if (needs.potential && system.potential() == nullptr) return "an energy";
  if (needs.linearisation && system.linearisation() == nullptr) return "derivatives of the force";
  if (!needs.constraints) return "";
  const engine::Constraints* constraints = system.constraints();
  if (constraints == nullptr) return "the energies as constraints";
  if (const std::string left = constraints->leftOut(); !left.empty()) return "constraints for " + left;
  if (needs.distanceConstraints && !constraints->onlyDistances()) return "constraints that are all distances";
  return "";
}

Prediction fails(Rule rule, double error, std::string text) {
  return {Expectation::Fails, rule, error, std::move(text)};
}

double rateOf(const Mode& m) { return std::max(std::sqrt(std::abs(m.stiffness)), m.damping + m.drag); }

/// Forecasts are trusted to this factor.
double trust(const Variant& variant) { return variant.linear ? 1.0 : 3.0; }

/// Below this a number is rounding, and no forecast says how much of it there will be.
double roundingOf(const Variant& variant) { return 1e-15 * std::max(1.0, variant.extent); }

/// A mode with its start, rounding where nothing else moves it.
Mode seeded(Mode mode) {
  if (mode.amplitude == 0.0 && mode.speed == 0.0) mode.amplitude = 1e-16;
  return mode;
}

/// Forecasts of a method that is run on each mode alone. Modes that share the run share its steps, which are those of
/// the mode that needs the shortest.
std::vector<std::optional<ModeForecast>> measured(const MethodInfo& method, const Variant& variant, double duration,
                                                  long long budget) {
  ModeRun run;
  run.duration = duration;
  run.budget = budget;
  if (method.adaptive) {
    run.tolerance = variant.steps.toleranceOf(method);
  } else {
    run.h = variant.steps.of(method);
  }
  std::vector<std::optional<ModeForecast>> all;
  double shortest = std::numeric_limits<double>::infinity();
  for (const Mode& m : variant.modes) {
    all.push_back(measuredForecast(method, seeded(m), run));
    if (all.back() && m.duration == 0.0) shortest = std::min(shortest, duration / std::max(1.0, all.back()->steps));
  }
  if (!method.adaptive) return all;
  run.largestStep = shortest;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Mode& m = variant.modes[i];
    if (!all[i] || m.duration > 0.0 || duration / std::max(1.0, all[i]->steps) < 1.5 * shortest) continue;
    all[i] = measuredForecast(method, seeded(m), run);
  }
  return all;
}

std::vector<std::optional<ModeForecast>> forecasts(const MethodInfo& method, const Variant& variant, double duration,
                                                   long long budget) {
  if (method.adaptive) return measured(method, variant, duration, budget);
  std::vector<std::optional<ModeForecast>> all;
  for (const Mode& m : variant.modes) {
    all.push_back(forecast(method, seeded(m), variant.steps.of(method), duration));
    if (!all.back()) return measured(method, variant, duration, budget);
  }
  return all;
}

/// What a forecast of one mode makes of the place at the end [m].
double distance(const MethodInfo& method, const Variant& variant, const Mode& mode, const ModeForecast& forecast,
                double duration) {
  if (!std::isfinite(forecast.error)) return forecast.error;
  if (!variant.sensitivity) return forecast.error * mode.sensitivity;
  const Sensitivity& s = *variant.sensitivity;
  if (mode.located) {
    const double time = std::abs(forecast.phase) / std::sqrt(mode.stiffness);
    // What a method of order 1 keeps is off by x v h omega^2 / 2 of the energy; the step that is cut at the event, at
    // x = v h, changes it for good.
    const double turn = std::sqrt(mode.stiffness) * mode.duration / forecast.steps;
    const double cut = method.order == 1 ? 0.25 * turn * turn : 0.0;
    return s.perRelativeSpeed * (std::abs(forecast.amplitude) + cut) + s.endSpeed * time;
  }
  const double T = mode.duration > 0.0 ? mode.duration : duration;
  // What is wrong with the mode at its end has grown as from there; what is wrong all along, as on the average.
  const Sensitivity::Growth growth = s.between(mode.duration > 0.0 ? T : 0.0, T);
  // An error of phase lies along the motion but for the part by which modes turn unalike: within sqrt(any / along) of
  // the geometric mean.
  const double between = std::sqrt(growth.any * growth.along);
  // An implicit step solves its equations, up to five, to a part of the forces where they are not linear: what is left
  // has no sign, and the steps' add up as a random walk.
  const double newton = engine::Tolerance{}.newton;
  const double solved =
      method.implicit && !variant.linear ? 5.0 * newton * std::sqrt(forecast.steps) * forecast.exactSize : 0.0;
  if (forecast.amplitude == 0.0 && forecast.phase == 0.0) {
    return (forecast.error * between + solved * growth.any) * mode.sensitivity;
  }
  const double amplitude = forecast.exactSize * std::abs(forecast.amplitude);
  const double phase = forecast.exactSize * std::abs(forecast.phase);
  const double passing = std::max(0.0, forecast.error - std::hypot(amplitude, phase));
  const double off = amplitude * growth.any + phase * between + passing * growth.along + solved * growth.any;
  // Two motions of one size are no further apart than that.
  return std::min(off, variant.extent * std::max(1.0, forecast.size / forecast.exactSize)) * mode.sensitivity;
}

/// The variant's number for a forecast of one mode.
double numberOf(const MethodInfo& method, const Variant& variant, const Mode& mode, const ModeForecast& forecast,
                double duration) {
  const double start = std::hypot(mode.amplitude, mode.speed / std::sqrt(std::max(std::abs(mode.stiffness), 1e-300)));
  const double ratio = forecast.size / start, exact = forecast.size / forecast.exactSize;
  switch (variant.measure) {
    case Measure::Error:
      return distance(method, variant, mode, forecast, duration);
    case Measure::Energy:
    case Measure::AngularSpeed:
      return std::abs(ratio * ratio - 1.0);
    case Measure::Size:
      return forecast.size;
    case Measure::Amplitude:
      return amplitudeFactor(exact);
  }
  return forecast.error;
}

/// "h omega = 0.1, h d/m = 0".
std::string stepText(const Mode& m, double h) {
  return fmt::format("h omega = {:.3g}, h d/m = {:.3g}", h * std::sqrt(std::abs(m.stiffness)),
                     h * (m.damping + m.drag));
}

/// The modes together.
struct Outlook {
  double error = 0.0;
  bool grows = false;
  bool dear = false;  ///< more force evaluations than the budget has
  std::string text = "nothing moves";
};

Outlook outlook(const MethodInfo& method, const Variant& variant, double duration, long long budget) {
  const std::vector<std::optional<ModeForecast>> all = forecasts(method, variant, duration, budget);
  Outlook result;
  double sum = 0.0;  // with signs, where linear theory is exact
  double worst = 0.0;
  bool added = false;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Mode m = seeded(variant.modes[i]);
    if (!all[i] || m.sensitivity == 0.0) continue;
    const double T = m.duration > 0.0 ? m.duration : duration, h = T / std::max(1.0, all[i]->steps);
    if (method.adaptive && !std::isfinite(all[i]->growth)) {
      result.dear = true;
      return result;
    }
    const double number = numberOf(method, variant, m, *all[i], duration);
    if (m.stiffness > 0.0 && all[i]->growth > 1.0 + 1e-9 && !(trust(variant) * number <= variant.bar)) {
      return {number, true, false, fmt::format("{}: grows by {:.4g} a step", stepText(m, h), all[i]->growth)};
    }
    if (variant.linear && variant.measure == Measure::Error) {
      sum += m.sensitivity * all[i]->position;
      added = true;
    }
    result.error += number;
    if (number < worst) continue;
    worst = number;
    result.text = method.adaptive ? fmt::format("tolerance {:.0e}, {:.0f} steps on the mode alone",
                                                variant.steps.toleranceOf(method), all[i]->steps)
                                  : stepText(m, h);
  }
  if (added) result.error = std::abs(sum);
  // Each mode was held to the size of the motion; so are all together.
  if (variant.sensitivity && variant.measure == Measure::Error) result.error = std::min(result.error, variant.extent);
  result.text += fmt::format(": {:.1e}", result.error);
  return result;
}

/// The most that a growing motion shows at the end: it leaves the scene, or the contact that holds it lets go.
double grown(const Variant& variant, double error) {
  for (const Mode& m : variant.modes) {
    if (m.cannotPull) return std::abs(m.speed) / (m.damping + m.drag);
  }
  return variant.extent > 0.0 ? std::min(error, std::max(variant.extent, variant.bar)) : error;
}

}  // namespace

const std::vector<PredictionRule>& predictionRules() {
  static const std::vector<PredictionRule> rules = {
      {"refused input", "simulate() refuses steps and states that make no sense, whatever the method"},
      {"missing need", "the method needs a capability that the system lacks (MethodInfo::needs)"},
      {"growth",
       "a mode grows at this step: its stability function exceeds 1 there (MethodInfo's limits), from rounding on, "
       "until "
       "the scene has been left or a contact lets go"},
      {"cost", "a method that chooses its steps would need more force evaluations than a cell may spend"},
      {"ringing",
       "only a step of backward Euler is sure to lower the energy of a non-linear scene; implicit methods of order 2 "
       "at "
       "h omega > 2 keep their fast modes ringing, or hop between minima of the energy for ever"},
      {"unfinished iteration",
       "a position based method stops iterating before coupled constraints are solved: too soft where a step is long "
       "for the stiffest spring"},
      {"conservation", "the method keeps the measured invariant exactly (MethodInfo::conserves...)"},
      {"closed form",
       "while each node's components go their own ways, in free flight and in contacts across one of them, "
       "a method that chooses its steps has no part in them"},
      {"free flight",
       "methods of order 1 are off by h a t / 2 under a constant acceleration a for the time t; from order 2 on they "
       "are "
       "exact"},
      {"linear theory",
       "the method's stability function, or its drift and kick matrices, raised to the number of steps, on each mode "
       "that carries the motion: error of phase, of amplitude and of damping, times what the case's own motion makes "
       "of "
       "such errors (computed); exact on linear cases, trusted to a factor of 3 elsewhere. A method without a formula "
       "here is run on the mode alone"},
      {"tolerance",
       "a method with step control is run on each mode alone with the case's tolerance, and with the shortest step of "
       "them; the case's own motion amplifies the error as above"},
  };
  return rules;
}

Prediction predict(const MethodInfo& method, const Variant& variant, const engine::DynamicalSystem& system,
                   double duration, long long budget) {
  if (variant.inputs) return {Expectation::Passes, Refused, 0.0, "refuses them"};
  if (const std::string need = missingNeed(method, system); !need.empty()) {
    return {Expectation::NotApplicable, Missing, 0.0, "needs " + need};
  }
  const double h = variant.steps.of(method);
  if (variant.measure == Measure::AngularSpeed && method.conservesAngularMomentum) {
    return {Expectation::Passes, Conservation, 0.0, "keeps the angular momentum but for rounding"};
  }
  if (variant.measure == Measure::Energy && method.conservesEnergy) {
    return {Expectation::Passes, Conservation, 0.0, "keeps the energy but for rounding"};
  }
  if (variant.inClosedForm && method.adaptive) {
    return {Expectation::Passes, Closed, 0.0, "exact but for rounding, whatever the method"};
  }
  Outlook foreseen = outlook(method, variant, duration, budget);
  if (foreseen.dear) {
    return fails(Cost, std::numeric_limits<double>::infinity(),
                 fmt::format("more than {:.0e} force evaluations at tolerance {:.0e}", static_cast<double>(budget),
                             variant.steps.toleranceOf(method)));
  }
  if (foreseen.grows) return fails(Growth, grown(variant, foreseen.error), foreseen.text);
  if (foreseen.error < roundingOf(variant)) {
    foreseen.error = 0.0;
    foreseen.text = "exact but for rounding";
  }
  const double error = foreseen.error;
  if (!method.adaptive && variant.stiffest * h > 2.0 && method.implicit && method.order > 1) {
    return fails(
        Ringing, variant.bar,
        fmt::format("order {} at h omega = {:.3g} on a scene with several minima", method.order, variant.stiffest * h));
  }
  if (method.iterative && variant.coupled > 1) {
    double fastest = 0.0, largest = 0.0;
    for (const Mode& m : variant.modes) {
      fastest = std::max(fastest, rateOf(m));
      largest = std::max(largest, m.amplitude);
    }
    const double own = (method.id == "xpbd" ? h / 20.0 : h) * fastest;
    // A single sweep sees the springs before it moved and those after it not yet: a part (h omega)^2 / 4 of the load is
    // missing. Projective dynamics converges within its iterations as long as the constant matrix is near (h omega <
    // 1), and at once on a line, where no spring turns.
    const bool turning = system.dimension() > 1;
    const double stretch = variant.stretch > 0.0 ? variant.stretch : largest;
    const double soft = method.id == "xpbd" ? 0.25 * own * own * stretch : turning && own > 1.0 ? largest : 0.0;
    if (trust(variant) * soft > variant.bar) {
      return fails(Iteration, soft,
                   fmt::format("{} coupled constraints at h omega = {:.3g}: {:.1e}", variant.coupled, own, soft));
    }
  }
  if (variant.flightAcceleration > 0.0 && method.order == 1) {
    const double step = std::min(method.id == "xpbd" ? h / 20.0 : h, variant.flightTime);
    const double flight = 0.5 * step * variant.flightAcceleration * variant.flightTime;
    if (flight > std::max(error, variant.bar)) {
      return fails(Flight, flight,
                   fmt::format("order 1 under {:.3g} m/s^2: {:.1e}", variant.flightAcceleration, flight));
    }
  }
  const Rule rule = method.adaptive ? Tolerance : LinearError;
  if (trust(variant) * error > variant.bar) return fails(rule, error, foreseen.text);
  return {Expectation::Passes, rule, error, foreseen.text};
}

}  // namespace muelle::hard_cases
