#include "engine/control/failure_report.h"

#include "base/text/count.h"

#include <fmt/format.h>
#include <cmath>

namespace muelle::engine {

StopReport notFiniteForce(const DynamicalSystem& system, const State& state, double t) {
  std::vector<double> force(state.x.size());
  system.force(t, state.x, state.v, state.z, force);
  for (std::size_t i = 0; i < force.size(); ++i) {
    if (std::isfinite(force[i])) continue;
    const int lane = static_cast<int>(i);
    return {true, t, lane, fmt::format("t = {:.6g} s, {}: the force is not finite", t, laneName(system, lane))};
  }
  return {};
}

StopReport failedStep(const MethodInfo& method, double t, double length, const StepResult& result) {
  return {
      true, t, -1,
      fmt::format("t = {:.6g} s: {} fails even with a step of {:.3g} s: {}", t, method.name, length, result.failure)};
}

StopReport failingPieces(const MethodInfo& method, double t, double nominal, double length, const StepResult& result) {
  return {
      true, t, -1,
      fmt::format("t = {:.6g} s: {} fails in pieces of h = {:.3g} s again and again, the last of {:.3g} s: {}; take "
                  "a shorter step, or look for a place where the force jumps",
                  t, method.name, nominal, length, result.failure)};
}

StopReport inexactStep(double t, double length, const StepResult& result, const Tolerance& tolerance) {
  return {true, t, -1,
          fmt::format("t = {:.6g} s: the step falls below {:.3g} s and its error is still {:.3g} times the "
                      "tolerance; look for a force that jumps, or ask for less than {:.1g} of the motion",
                      t, length, result.error, tolerance.relative)};
}

StopReport reachedLimit(const StepOptions& options, const Work& work, double t) {
  const auto report = [t](long long most, const char* what) {
    return StopReport{true, t, -1, fmt::format("t = {:.6g} s: the limit of {} is reached", t, counted(most, what))};
  };
  if (work.steps >= options.mostSteps) return report(options.mostSteps, "step");
  if (work.forceEvaluations >= options.mostForceEvaluations) {
    return report(options.mostForceEvaluations, "force evaluation");
  }
  return {};
}

}  // namespace muelle::engine
