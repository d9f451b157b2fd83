#include "lab/run/error_estimate.h"

#include "engine/integrators/catalogue.h"
#include "lab/run/energy_balance.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace muelle::lab {

using namespace engine;

namespace {

/// Two differences in a row have to shrink at least so fast for the runs to count as approaching their limit.
constexpr double slowestApproach = 1.6;

/// The larger of both parts of the motion: by it the approach of the runs is judged. What rounds by `floor` [m] is not
/// told from 0.
struct Scale {
  Sizes motion;
  double positionRounding = 0.0;  ///< [m]
  bool absolute = false;          ///< nothing moves: metres and m/s

  double part(double difference, double size) const { return absolute || size == 0.0 ? difference : difference / size; }
  double errorOf(const Sizes& difference) const {
    return std::max(part(difference.position, motion.position), part(difference.velocity, motion.velocity));
  }
  double rounding() const { return part(positionRounding, motion.position); }
};

/// The scene's runs beside the first, with finer and coarser steps, compared with one another at the same times.
class Refinement {
 public:
  Refinement(const Scene& scene, const SceneRun& run, const std::string& label)
      : scene_(scene), run_(run), label_(label), method_(makeMethod(scene.method)),
        rows_(comparedRows(run.result.trajectory)) {
    for (const std::size_t row : rows_) {
      if (row > 0) times_.push_back(run.result.trajectory.t[row]);
    }
  }

  /// \param refine 2: half the step, a tenth of the tolerance; 4: a quarter, a hundredth; 0.5: twice, ten times
  RunResult at(double refine) {
    RunOptions options = run_.options;
    options.probes = probesOf(scene_, *run_.system);
    options.checkStability = options.checkNumericalDamping = false;
    options.outputInterval = 0.0;
    options.sampleTimes = times_;
    options.label = label_;
    if (options.fixedStep) {
      options.h /= refine;
    } else {
      options.tolerance.relative = std::min(1.0, options.tolerance.relative * std::pow(10.0, -std::log2(refine)));
      options.largestStep /= refine;
      options.stepsAPeriod *= refine;
    }
    RunResult result = simulate(*run_.system, *method_, run_.system->initialState(), options);
    wallTime_ += result.wallTime;
    return result;
  }

  Sizes differenceFromFirst(const RunResult& other) const {
    return differenceOf(scene_, *run_.system, run_.result.trajectory, rows_, other.trajectory);
  }
  Sizes difference(const RunResult& a, const RunResult& b) const {
    std::vector<std::size_t> all(a.trajectory.t.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
    return differenceOf(scene_, *run_.system, a.trajectory, all, b.trajectory);
  }
  double wallTime() const { return wallTime_; }

 private:
  const Scene& scene_;
  const SceneRun& run_;
  std::string label_;
  std::unique_ptr<Method> method_;
  std::vector<std::size_t> rows_;
  std::vector<double> times_;
  double wallTime_ = 0.0;
};

/// The largest coordinate of a run [m].
double largestCoordinate(const Trajectory& trajectory) {
  double largest = 0.0;
  for (const std::vector<double>& x : trajectory.x) {
    for (const double value : x) largest = std::max(largest, std::abs(value));
  }
  return largest;
}

Scale scaleOf(const Scene& scene, const SceneRun& run, const RunResult& finest) {
  Scale scale;
  scale.motion = motionOf(scene, *run.system, finest.trajectory);
  // A position is rounded at every step; the sum of so many roundings in no order grows as the root of their number.
  const double steps = std::max(1.0, static_cast<double>(finest.work.steps));
  const double unit = std::numeric_limits<double>::epsilon() * largestCoordinate(finest.trajectory);
  scale.positionRounding = run.options.compensated ? unit : unit * std::sqrt(steps);
  scale.absolute = scale.motion.position <= 4.0 * scale.positionRounding;
  return scale;
}

/// The shortest period of what acts at any time of the run.
double shortestPeriod(const System& system, double duration) {
  constexpr int looks = 200;
  double shortest = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= looks; ++i) shortest = std::min(shortest, system.shortestPeriod(duration * i / looks));
  return shortest;
}

/// The shortest stretch between times at which a force jumps or a motion begins or ends.
double shortestStretch(const System& system, double duration) {
  std::vector<double> times = {0.0};
  if (system.switching() != nullptr) system.switching()->declaredTimes(0.0, duration, times);
  double shortest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < times.size(); ++i) {
    if (times[i] > times[i - 1]) shortest = std::min(shortest, times[i] - times[i - 1]);
  }
  return shortest;
}

/// Why runs at this step would share a mistake, as far as one can tell beforehand; empty when nothing is known.
std::string sharedMistake(const Scene& scene, const SceneRun& run) {
  const double duration = run.options.duration;
  if (!run.options.fixedStep) {
    return run.result.work.steps < 2 ? "the whole run is one step" : "";
  }
  const double h = run.options.h;
  if (h >= 0.5 * duration) return fmt::format("the step of {:.3g} s is at least half of the run", h);
  const double period = shortestPeriod(*run.system, duration);
  if (h > 0.25 * period) {
    return fmt::format("the step of {:.3g} s does not resolve what acts with a period of {:.3g} s", h, period);
  }
  const double stretch = shortestStretch(*run.system, duration);
  if (!scene.locateEvents && h > 0.25 * stretch) {
    return fmt::format("the step of {:.3g} s passes over what acts for {:.3g} s (events are off)", h, stretch);
  }
  return "";
}

std::string lossSentence(double loss) {
  return fmt::format("{:.0f} % of an energy that should be kept is lost even in the finest run", 100.0 * loss);
}

/// The estimate's numbers: the difference of the first run from a finer one, times what that run has still before it.
void take(ErrorEstimate& estimate, const Scale& scale, const Sizes& difference, double factor) {
  const double floor = scale.rounding();
  estimate.absolute = scale.absolute;
  estimate.position = std::max(floor, factor * scale.part(difference.position, scale.motion.position));
  estimate.velocity = factor * scale.part(difference.velocity, scale.motion.velocity);
  for (std::size_t i = 0; i < difference.outputs.size(); ++i) {
    const double size = scale.motion.outputs[i];
    estimate.outputs.push_back({factor * scale.part(difference.outputs[i], size), size == 0.0 || scale.absolute});
  }
  estimate.atRounding = estimate.error() <= 4.0 * floor;
}

}  // namespace

ErrorEstimate estimateError(const Scene& scene, const SceneRun& run, const std::string& label) {
  ErrorEstimate estimate;
  if (run.result.failed()) {
    estimate.failure = "the run did not reach its end";
    return estimate;
  }
  estimate.failure = sharedMistake(scene, run);
  if (!estimate.failure.empty()) return estimate;

  const bool fixed = run.options.fixedStep;
  Refinement runs(scene, run, label);
  const auto finish = [&](std::string failure) {
    estimate.failure = std::move(failure);
    estimate.wallTime = runs.wallTime();
    return estimate;
  };
  const RunResult finer = runs.at(2.0);
  if (finer.failed()) return finish("the finer run did not reach its end");
  const Sizes first = runs.differenceFromFirst(finer);
  Scale scale = scaleOf(scene, run, finer);
  const double d1 = scale.errorOf(first);

  const double expected = fixed ? std::pow(2.0, run.method.order) : 10.0;
  const auto lost = [&](const RunResult& finest) { return lostEnergy(*run.system, run.result, finest); };
  const bool rounded = d1 <= 4.0 * scale.rounding();
  if (!rounded) {
    const RunResult coarser = runs.at(0.5);
    const double d0 = coarser.failed() ? 0.0 : scale.errorOf(runs.differenceFromFirst(coarser));
    const double seen = d0 / d1;
    const bool orderSeen = fixed ? seen > 0.6 * expected && seen < 1.7 * expected : seen > 4.0 && seen < 30.0;
    if (!orderSeen) {
      const RunResult finest = runs.at(4.0);
      if (finest.failed()) return finish("the finest run did not reach its end");
      scale = scaleOf(scene, run, finest);
      const double d2 = scale.errorOf(runs.difference(finer, finest));
      const double approach = d2 > 0.0 ? d1 / d2 : std::numeric_limits<double>::infinity();
      estimate.how = fixed ? "steps halved twice" : "tolerances of a tenth and a hundredth";
      if (d2 > 4.0 * scale.rounding() && approach < slowestApproach) {
        return finish(fmt::format("the order is not seen: with {} the result changes {:.2g} times as much as before",
                                  fixed ? "half the step" : "a tenth of the tolerance", 1.0 / approach));
      }
      const double loss = lost(finest);
      if (loss > mostLoss) return finish(lossSentence(loss));
      take(estimate, scale, runs.differenceFromFirst(finest), 1.0 / (1.0 - 1.0 / (approach * approach)));
      return finish({});
    }
    const double loss = lost(finer);
    if (loss > mostLoss) return finish(lossSentence(loss));
    estimate.how = fixed ? fmt::format("step halved, order {} seen", run.method.order) : "a tenth of the tolerance";
    take(estimate, scale, first, seen / (seen - 1.0));
    return finish({});
  }
  const double loss = lost(finer);
  if (loss > mostLoss) return finish(lossSentence(loss));
  estimate.how = fixed ? "step halved" : "a tenth of the tolerance";
  take(estimate, scale, first, 1.0);
  return finish({});
}

}  // namespace muelle::lab
