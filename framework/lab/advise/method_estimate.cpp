#include "lab/advise/method_estimate.h"

#include "engine/analysis/stability.h"
#include "engine/control/run_checks.h"
#include "engine/control/step_planner.h"
#include "engine/integrators/catalogue.h"
#include "lab/bench/stopwatch.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

namespace muelle::lab {

using namespace engine;

namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();
/// Of the limit that linear theory has at the start.
constexpr double ofStability = 0.97;

/// The error of a run in parts of the motion, by linear theory: a mode of frequency w is off in phase by
/// w T (h w)^p / (p + 1)!, about, as long as it lasts, and at most by its whole amplitude twice. Symplectic Euler is
/// velocity Verlet with velocities half a step late: its phase is of order 2.
double linearError(const EnergyShare& share, double duration, const MethodInfo& info, double h) {
  const bool late = info.symplectic && info.order == 1;
  const int order = late ? 2 : info.order;
  double error = 0.0;
  for (const Mode& mode : share.modes) {
    const double w = mode.frequency(), decay = mode.decay();
    const double lasts = decay * duration > 1.0 ? 1.0 / decay : duration;
    const double phase = w * lasts * std::pow(h * w, order) / std::tgamma(order + 2.0);
    error += std::sqrt(mode.energy) * std::min(2.0, phase + (late ? 0.5 * h * w : 0.0));
  }
  return error;
}

/// The step at which that error is the tolerance, no longer than `most`.
double stepForError(const EnergyShare& share, double duration, const MethodInfo& info, double tolerance, double most) {
  if (linearError(share, duration, info, most) <= tolerance) return most;
  double low = most * 1e-8, high = most;
  for (int i = 0; i < 60; ++i) {
    const double middle = std::sqrt(low * high);
    (linearError(share, duration, info, middle) <= tolerance ? low : high) = middle;
  }
  return low;
}

double shortestStretchOf(const ModelSystem& system, double duration) {
  std::vector<double> times = declaredTimes(system, 0.0, duration);
  times.insert(times.begin(), 0.0);
  double shortest = unlimited;
  for (std::size_t i = 1; i < times.size(); ++i) {
    if (times[i] > times[i - 1]) shortest = std::min(shortest, times[i] - times[i - 1]);
  }
  return shortest;
}

/// What no step may exceed whatever the method: what acts has to be resolved, and a run is no run in one step.
double resolvedStep(const Scene& scene, const ModelSystem& system) {
  double h = std::min(scene.duration / 4.0, scene.largestStep);
  h = std::min(h, resolvedPart * shortestPeriodOf(system, 0.0, scene.duration));
  if (!scene.locateEvents) h = std::min(h, 0.25 * shortestStretchOf(system, scene.duration));
  return h;
}

class Estimates {
 public:
  Estimates(const Pilots& pilots, const EnergyShare& share, double evaluation, double tolerance)
      : pilots_(pilots),
        share_(share),
        evaluation_(evaluation),
        tolerance_(tolerance),
        start_(pilots.system().initialState()),
        resolved_(resolvedStep(pilots.scene(), pilots.system())) {}

  MethodEstimate of(const MethodInfo& info, bool fixed) const {
    MethodEstimate estimate;
    estimate.setting = {info.id, fixed, 0.0};
    estimate.order = info.order;
    estimate.refusal = refusalOf(pilots_.system(), info.id);
    if (estimate.refusal.empty() && info.iterative) {
      estimate.refusal = "it stops iterating before it converges, and no order tells its error";
    }
    if (!estimate.fits()) return estimate;
    const double duration = pilots_.scene().duration;
    const double stable = stableStep(info, fixed);
    estimate.largestStep = std::min(resolved_, stable);
    if (!(estimate.largestStep > 1e-9 * duration)) {
      estimate.refusal = "no step is stable that anybody would wait for";
      return estimate;
    }
    estimate.stepForError = stepForError(share_, duration, info, tolerance_, estimate.largestStep);
    estimate.secondsOfStep = pilots_.secondsOfStep(info.id, estimate.stepForError);
    // An adaptive method would not have taken the step that was timed.
    if (!fixed && !std::isfinite(estimate.secondsOfStep)) estimate.secondsOfStep = 1.5 * info.stages * evaluation_;
    estimate.seconds = duration / estimate.stepForError * estimate.secondsOfStep;
    if (fixed) estimate.leastSeconds = duration / estimate.largestStep * estimate.secondsOfStep;
    estimate.setting.value = fixed ? estimate.largestStep : std::clamp(tolerance_ / 10.0, 1e-13, 0.1);
    return estimate;
  }

 private:
  /// An adaptive method finds its limit itself; the estimate has it from the fastest mode.
  double stableStep(const MethodInfo& info, bool fixed) const {
    if (fixed && (info.stability == Stability::Limited || info.stability == Stability::Never)) {
      const std::unique_ptr<Integrator> method = makeMethod(info.id);
      return ofStability * stability(pilots_.system(), *method, start_).largestStep;
    }
    if (fixed || info.stability != Stability::Limited || share_.fastest == 0.0) return unlimited;
    return std::max(info.imaginaryLimit, 1.0) / share_.fastest;
  }

  const Pilots& pilots_;
  const EnergyShare& share_;
  double evaluation_, tolerance_;
  State start_;
  double resolved_;
};

}  // namespace

UnitCosts unitCosts(const Pilots& pilots) {
  const ModelSystem& system = pilots.system();
  const State state = system.initialState();
  std::vector<double> a(state.x.size());
  UnitCosts costs;
  costs.evaluation =
      bench::secondsOf([&] { system.acceleration(state.t, state.x, state.v, state.z, a); }, bench::processorTime, 1e-3);
  if (refusalOf(system, "linearised_backward_euler").empty()) {
    costs.factorisation = pilots.secondsOfStep("linearised_backward_euler", pilots.scene().duration / 100.0);
    if (!std::isfinite(costs.factorisation)) costs.factorisation = 0.0;
  }
  return costs;
}

std::vector<MethodEstimate> estimateMethods(const Pilots& pilots, const EnergyShare& share, const UnitCosts& costs,
                                            double tolerance) {
  const Estimates estimates(pilots, share, costs.evaluation, tolerance);
  std::vector<MethodEstimate> all;
  for (const std::string& id : methodIds()) {
    const MethodInfo& info = methodInfo(id);
    all.push_back(estimates.of(info, !info.adaptive));
    // A Nystroem method of high order also pays at a fixed step: without trials, and bound by stability alone.
    if (info.adaptive && info.needs.velocityFreeForce && all.back().fits()) all.push_back(estimates.of(info, true));
  }
  std::ranges::stable_sort(all, [](const MethodEstimate& a, const MethodEstimate& b) {
    return a.fits() != b.fits() ? a.fits() : a.seconds < b.seconds;
  });
  return all;
}

}  // namespace muelle::lab
