#include "lab/hard_cases/prediction.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>

namespace muelle::hard_cases {

namespace {

using engine::MethodInfo;

enum Rule { Refused, Missing, Growth, Cost, Ringing, Iteration, Conservation, Flight, LinearError, Tolerance };

/// The need of the method that the system does not meet; empty when it meets all.
std::string missingNeed(const MethodInfo& method, const engine::System& system) {
  const engine::Needs& needs = method.needs;
  if (needs.velocityFreeForce && system.forceUsesVelocity()) return "a force that does not depend on the velocity";
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

/// Methods that choose their steps: their error is that of the tolerance, their cost follows from it.
Prediction adaptive(const MethodInfo& method, const Variant& variant, double duration, long long budget) {
  const double tolerance = variant.steps.tolerance;
  double steps = 1.0, error = 0.0, left = 0.0;
  for (const Mode& m : variant.modes) {
    const double T = m.duration > 0.0 ? m.duration : duration;
    const double omega = std::sqrt(std::abs(m.stiffness)), damping = m.damping + m.drag;
    // Resolved while the mode carries more than the tolerance: h omega = tolerance^(1/(p+1)), at most 1.
    const double alive = std::max(m.amplitude, std::abs(m.speed) / std::max(omega, 1e-300)) > tolerance ? 1.0 : 0.0;
    const double rate = std::max(1.0, std::pow(tolerance, -1.0 / (method.order + 1.0)) / method.order) * omega * alive;
    const double resolving = rate * (damping > 0.0 ? std::min(T, 40.0 / damping) : T);
    // Kept stable after that.
    const double imaginary = method.imaginaryLimit > 0.0 ? omega * T / method.imaginaryLimit : omega * T * alive;
    const double real =
        std::isfinite(method.realLimit) && damping > 0.0 ? damping * T / std::max(method.realLimit, 1.0) : 0.0;
    steps = std::max({steps, resolving, imaginary, real});
    // Local errors of one tolerance each, as long as they last. Above order 2 the estimate is that of a companion of
    // lower order and they cancel in part, as a random walk; RKC2's is its own, and they add up.
    const double lasting = std::max(1.0, rate * (damping > 0.0 ? std::min(T, 1.0 / damping) : T));
    const double sum = method.order > 2 ? std::sqrt(lasting) : lasting;
    error = std::max(error, tolerance * m.sensitivity * variant.errorGrowth * sum);
    left = std::max(left, exactSize(m, duration));
  }
  // An implicit step solves an equation for each order, each with two or three evaluations.
  const double evaluations = steps * (method.implicit ? 2.0 * method.order : method.stages);
  if (evaluations > static_cast<double>(budget)) {
    return fails(Cost, std::numeric_limits<double>::infinity(),
                 fmt::format("about {:.1e} force evaluations at tolerance {:.0e}, beyond {:.0e}", evaluations,
                             tolerance, static_cast<double>(budget)));
  }
  if (variant.measure == Measure::Size) {
    const std::string text = fmt::format("follows the exact motion, which leaves {:.1e}", left);
    return {left > variant.bar ? Expectation::Fails : Expectation::Passes, Tolerance, left, text};
  }
  const std::string text = variant.modes.empty()
                               ? "nothing but constant forces: exact"
                               : fmt::format("tolerance {:.0e}, error about {:.0e}", tolerance, error);
  return {trust(variant) * error > variant.bar ? Expectation::Fails : Expectation::Passes, Tolerance, error, text};
}

/// The variant's number for a forecast of one mode.
double measured(const Variant& variant, const Mode& mode, const ModeForecast& forecast) {
  if (!std::isfinite(forecast.error)) return forecast.error;
  const double start = std::hypot(mode.amplitude, mode.speed / std::sqrt(std::max(std::abs(mode.stiffness), 1e-300)));
  const double ratio = forecast.size / start;
  switch (variant.measure) {
    case Measure::Error:
      return forecast.error * mode.sensitivity;
    case Measure::Energy:
    case Measure::AngularSpeed:
      return std::abs(ratio * ratio - 1.0);
    case Measure::Size:
      return forecast.size;
  }
  return forecast.error;
}

}  // namespace

const std::vector<PredictionRule>& predictionRules() {
  static const std::vector<PredictionRule> rules = {
      {"refused input", "simulate() refuses steps and states that make no sense, whatever the method"},
      {"missing need", "the method needs a capability that the system lacks (MethodInfo::needs)"},
      {"growth",
       "a mode grows at this step: its stability function exceeds 1 there (MethodInfo's limits), from rounding on"},
      {"cost", "a method that chooses its steps would need more force evaluations than a cell may spend"},
      {"ringing",
       "only a step of backward Euler is sure to lower the energy of a non-linear scene; implicit methods of order 2 "
       "at "
       "h omega > 2 keep their fast modes ringing, or hop between minima of the energy for ever"},
      {"unfinished iteration",
       "a position based method stops iterating before coupled constraints are solved: too soft where a step is long "
       "for the stiffest spring"},
      {"conservation", "the method keeps the measured invariant exactly (MethodInfo::conserves...)"},
      {"free flight",
       "methods of order 1 are off by h a t / 2 under a constant acceleration a for the time t; from order 2 on they "
       "are "
       "exact"},
      {"linear theory",
       "the method's stability function, or its drift and kick matrices, raised to the number of steps, on each mode "
       "that "
       "carries the motion: error of phase, of amplitude and of damping; exact on linear cases, trusted to a factor of "
       "3 elsewhere"},
      {"tolerance",
       "a method with step control keeps the local error at the tolerance; the case's sensitivity amplifies it"},
  };
  return rules;
}

Prediction predict(const MethodInfo& method, const Variant& variant, const engine::System& system, double duration,
                   long long budget) {
  if (variant.inputs) return {Expectation::Passes, Refused, 0.0, "refuses them"};
  if (const std::string need = missingNeed(method, system); !need.empty()) {
    return {Expectation::NotApplicable, Missing, 0.0, "needs " + need};
  }
  if (method.adaptive) return adaptive(method, variant, duration, budget);

  const double h = variant.steps.of(method);
  if (variant.measure == Measure::AngularSpeed && method.conservesAngularMomentum) {
    return {Expectation::Passes, Conservation, 1e-13, "keeps the angular momentum"};
  }
  if (variant.measure == Measure::Energy && method.conservesEnergy) {
    return {Expectation::Passes, Conservation, 1e-12, "keeps the energy"};
  }
  double error = 0.0;
  std::string text = "nothing moves";
  for (const Mode& m : variant.modes) {
    Mode seeded = m;  // rounding excites what nothing else does
    seeded.amplitude = m.amplitude == 0.0 && m.speed == 0.0 ? 1e-16 : m.amplitude;
    const std::optional<ModeForecast> foreseen = forecast(method, seeded, h, duration);
    if (!foreseen) continue;
    const double value = measured(variant, seeded, *foreseen);
    const bool grows = m.stiffness > 0.0 && foreseen->growth > 1.0 + 1e-9;
    if (grows && !(trust(variant) * value <= variant.bar)) {
      return fails(Growth, value,
                   fmt::format("h omega = {:.3g}, h d/m = {:.3g}: grows by {:.4g} a step", h * std::sqrt(m.stiffness),
                               h * (m.damping + m.drag), foreseen->growth));
    }
    if (value >= error) {
      error = value;
      text = fmt::format("h omega = {:.3g}, h d/m = {:.3g}: {:.1e} by linear theory",
                         h * std::sqrt(std::abs(m.stiffness)), h * (m.damping + m.drag), value);
    }
  }
  if (variant.stiffest * h > 2.0 && method.implicit && method.order > 1) {
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
    // missing. Projective dynamics converges within its iterations as long as the constant matrix is near: h omega < 1.
    const double soft = method.id == "xpbd" ? 0.25 * own * own * largest : own > 1.0 ? largest : 0.0;
    if (trust(variant) * soft > variant.bar) {
      return fails(Iteration, soft,
                   fmt::format("{} coupled constraints at h omega = {:.3g}: {:.1e}", variant.coupled, own, soft));
    }
  }
  if (variant.flightAcceleration > 0.0 && method.order == 1) {
    const double step = std::min(method.id == "xpbd" ? h / 20.0 : h, variant.flightTime);
    const double flight = 0.5 * step * variant.flightAcceleration * variant.flightTime * variant.flightSensitivity;
    if (flight > std::max(error, variant.bar)) {
      return fails(Flight, flight,
                   fmt::format("order 1 under {:.3g} m/s^2: {:.1e}", variant.flightAcceleration, flight));
    }
  }
  if (trust(variant) * error > variant.bar) return fails(LinearError, error, text);
  return {Expectation::Passes, LinearError, error, text};
}

}  // namespace muelle::hard_cases
