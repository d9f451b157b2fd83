#include "engine/control/stability_looks.h"

#include "engine/analysis/numerical_damping.h"
#include "engine/analysis/stability.h"
#include "engine/control/run_checks.h"

#include <fmt/format.h>
#include <algorithm>

namespace muelle::engine {

namespace {

constexpr int mostLooks = 3;  // during a run

}  // namespace

StabilityLooks::StabilityLooks(const DynamicalSystem& system, const MethodInfo& method, const RunOptions& options)
    : system_(system),
      method_(method),
      options_(options),
      wanted_((options.checkStability || options.checkNumericalDamping) && (options.fixedStep || !method.adaptive)),
      budget_(wanted_ ? LookBudget::ofRun(options.duration / options.h * std::max(1, method.stages)) : LookBudget()) {}

std::vector<std::string> StabilityLooks::before(Integrator& method, const State& start) {
  std::vector<std::string> warnings;
  if (options_.checkStability) {
    const double steps = options_.duration / options_.h;
    std::string warning = instabilityWarning(system_, method, start, options_.h, steps, budget_);
    warnedOfInstability_ = !warning.empty();
    if (!warning.empty()) warnings.push_back(std::move(warning));
    if (std::string text = bounce(start); !text.empty()) warnings.push_back(std::move(text));
    const double end = start.t + options_.duration;
    if (std::string text = unresolvedWarning(system_, start.t, end, options_.h); !text.empty()) {
      warnings.push_back(std::move(text));
    }
  }
  if (options_.checkNumericalDamping) {
    NumericalDamping damping = numericalDamping(system_, method, start, options_.h, options_.duration, budget_);
    if (damping.exceeds) warnings.push_back(std::move(damping.sentence));
  }
  return warnings;
}

/// A bounce is a jump of the force when few steps fall into it.
std::string StabilityLooks::bounce(const State& start) const {
  if (system_.switching() == nullptr) return {};
  constexpr double enough = 20.0;
  const double bounce = system_.switching()->shortestBounce(start);
  if (!(options_.h * enough > bounce) || options_.duration < bounce) return {};
  return fmt::format(
      "a bounce off an obstacle lasts {:.3g} s: h = {:.3g} s leaves {:.2g} steps for it, and {:.0f} are wanted (h up "
      "to "
      "{:.3g} s)",
      bounce, options_.h, bounce / options_.h, enough, bounce / enough);
}

std::string StabilityLooks::afterSwitch(const State& state) {
  if (!wanted_ || !options_.checkStability || warnedOfInstability_ || ++looks_ > mostLooks) return {};
  std::string warning = lateInstabilityWarning(system_, method_, state, options_.h, budget_);
  warnedOfInstability_ = !warning.empty();
  return warning;
}

}  // namespace muelle::engine
