#include "engine/control/run_checks.h"

#include "base/text/count.h"
#include "engine/control/step_planner.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

namespace muelle::engine {

namespace {

template <class... Arguments>
[[noreturn]] void reject(fmt::format_string<Arguments...> message, Arguments&&... arguments) {
  throw std::invalid_argument("simulate: " + fmt::format(message, std::forward<Arguments>(arguments)...));
}

/// The message is put together only when it is needed: short runs would take longer for that than for their steps.
template <class... Arguments>
void require(bool holds, fmt::format_string<Arguments...> message, Arguments&&... arguments) {
  if (!holds) reject(message, std::forward<Arguments>(arguments)...);
}

bool isPositive(double value) { return value > 0.0 && std::isfinite(value); }

void checkStep(const StepOptions& options, bool adaptive) {
  if (adaptive) {
    require(options.h == 0.0 || isPositive(options.h),
            "the first step h is {} s; it must be positive and finite, or 0 to be chosen", options.h);
    require(options.largestStep > 0.0, "largestStep is {} s; it must be positive (infinite: no limit)",
            options.largestStep);
    const double tolerance = options.tolerance.relative;
    require(tolerance > 0.0 && tolerance <= 1.0,
            "the tolerance is {}; it bounds the error of a step in parts of the motion: above 0, at most 1", tolerance);
    return;
  }
  require(isPositive(options.h), "the step h is {} s; it must be positive and finite", options.h);
  require(options.duration / options.h < 1e12, "{} s in steps of {} s are too many steps", options.duration, options.h);
}

/// \param times of outputs [s]
void checkTimes(const std::vector<double>& times, const State& start, double duration) {
  double before = start.t;
  for (const double t : times) {
    require(t >= before && t <= start.t + duration,
            "the output time {} s is out of order or outside the run from {} to {} s", t, start.t, start.t + duration);
    before = t;
  }
}

}  // namespace

void checkOutputOptions(const RunOptions& options, const State& start) {
  require(options.outputInterval >= 0.0 && std::isfinite(options.outputInterval),
          "outputInterval is {} s; it must be positive, or 0 for every step", options.outputInterval);
  require(options.outputInterval == 0.0 || options.duration / options.outputInterval < 1e9,
          "{} s with an output every {} s are too many outputs", options.duration, options.outputInterval);
  checkTimes(options.sampleTimes, start, options.duration);
  for (const Probe& probe : options.probes) {
    require(static_cast<bool>(probe.measure), "the probe '{}' has no function", probe.name);
  }
}

void checkStepOptions(const StepOptions& options, const State& start, bool adaptive) {
  require(isPositive(options.duration), "the duration is {} s; it must be positive and finite", options.duration);
  require(start.t + options.duration > start.t, "the duration of {} s is lost in the rounding of the start time {} s",
          options.duration, start.t);
  checkStep(options, adaptive);
  checkTimes(options.outputTimes, start, options.duration);
  require(options.explosion > 0.0, "explosion is {}; it must be positive", options.explosion);
  require(options.mostSteps > 0 && options.mostForceEvaluations > 0,
          "the limits of steps and force evaluations must "
          "be positive");
}

void checkForesight(const DynamicalSystem& system, const MethodInfo& method, const StepOptions& options) {
  const bool blind = method.adaptive && !options.fixedStep && system.hasUnannouncedForce();
  require(!blind || std::isfinite(options.largestStep),
          "a force changes with time without declared times, and {} could step over it; set largestStep "
          "below the shortest thing that the force does, or declare the times at which it jumps",
          method.name);
}

void checkRodsAreHeld(const DynamicalSystem& system, const MethodInfo& method) {
  require(system.rods().empty() || method.holdsRods,
          "{} does not hold rods, and the scene has {}; use the method 'rattle', or give the springs a "
          "stiffness k in place of rod = true",
          method.id, system.rods().size());
}

void checkSizes(const DynamicalSystem& system, const State& start) {
  const auto size = static_cast<std::size_t>(system.storage());
  require(system.size() > 0, "the system has no unknown");
  if (start.x.size() != size || start.v.size() != size) {
    reject("the state has {} and {}, the system {}", counted(std::ssize(start.x), "position"),
           counted(std::ssize(start.v), "velocity", "velocities"), counted(system.storage(), "lane"));
  }
  const auto internal = static_cast<std::size_t>(system.internalSize());
  if (!start.z.empty() && start.z.size() != internal) {
    reject("the state has {}, the system {}", counted(std::ssize(start.z), "internal variable"), internal);
  }
  const std::span<const double> mass = system.mass();
  if (mass.size() != size) {
    reject("{} for {}", counted(std::ssize(mass), "mass", "masses"), counted(system.storage(), "lane"));
  }
  for (int i = 0; i < system.size(); ++i) {
    const double m = mass[laneOf(system, i)];
    if (!isPositive(m)) {
      reject("{}: the mass is {} kg; a mass is positive and finite", system.unknownName(i), m);
    }
  }
  require(std::isfinite(start.t), "the start time is not finite");
}

double shortestPeriodOf(const DynamicalSystem& system, double from, double to) {
  std::vector<double> times = declaredTimes(system, from, to);
  times.insert(times.end(), {from, to});
  std::sort(times.begin(), times.end());
  double shortest = system.shortestPeriod(from);
  for (std::size_t i = 1; i < times.size(); ++i) {
    shortest = std::min(shortest, system.shortestPeriod(0.5 * (times[i - 1] + times[i])));
  }
  return shortest;
}

std::string unresolvedWarning(const DynamicalSystem& system, double from, double to, double h) {
  const double period = shortestPeriodOf(system, from, to);
  if (!(h > resolvedPart * period)) return "";
  return fmt::format("something acts with a period of {:.3g} s: h = {:.3g} s does not resolve it (h up to {:.3g} s)",
                     period, h, resolvedPart * period);
}

}  // namespace muelle::engine
