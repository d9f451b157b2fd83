#include "lab/run/error_estimate.h"

#include "base/text/count.h"
#include "engine/control/run_checks.h"
#include "engine/control/step_planner.h"
#include "engine/integrators/catalogue.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace muelle::lab {

using namespace engine;

namespace {

/// Two differences in a row have to shrink at least so fast for the runs to count as approaching their limit.
constexpr double slowestApproach = 1.6;

/// Above it, in parts of the motion, differences no longer grow as errors do, and an order may seem to be there by
/// accident.
constexpr double surelySmall = 0.05;

/// Differences that do not shrink and are smaller than this, in parts of the motion, are rounding, as stiff springs and
/// contacts amplify it.
constexpr double surelyRounding = 1e-10;

/// Steps times unknowns of a finer run that anybody waits for: where the order is not seen by then, and only so much is
/// to be done, the steps are halved again.
constexpr double quicklyDone = 1e6;

/// A finer run may cost so many times the first, and a few evaluations that nobody notices besides: half the step costs
/// twice, an eighth eight times, a thousandth of a tolerance 32 times with order 2. An explicit method that has to
/// follow a contact at a tolerance that is finer than its rounding would go on for ever.
constexpr double mostTimes = 40.0, quickEvaluations = 20'000.0;

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
      : scene_(scene),
        run_(run),
        label_(label),
        method_(makeMethod(scene.method)),
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
    const double first = static_cast<double>(run_.result.work.forceEvaluations);
    most_ = quickEvaluations + std::max(mostTimes, 2.0 * refine) * first;
    options.mostForceEvaluations = static_cast<long long>(most_);
    if (options.fixedStep) {
      options.h /= refine;
    } else {
      options.tolerance.relative = std::min(1.0, options.tolerance.relative * std::pow(10.0, -std::log2(refine)));
      options.largestStep /= refine;
      options.stepsAPeriod *= refine;
    }
    RunResult result = simulate(*run_.system, *method_, run_.system->initialState(), options);
    wallTime_ += result.wallTime;
    gaveUp_ = result.failed() && result.work.forceEvaluations >= options.mostForceEvaluations;
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
  /// Why the last run has no result. \param which  "finer"
  std::string failure(const char* which) const {
    if (!gaveUp_) return fmt::format("the {} run did not reach its end", which);
    const long long first = run_.result.work.forceEvaluations;
    return fmt::format("the {} run would take more than {} force evaluations, and the first took {}", which,
                       grouped(std::llround(most_)), grouped(first));
  }

 private:
  const Scene& scene_;
  const SceneRun& run_;
  std::string label_;
  std::unique_ptr<Integrator> method_;
  std::vector<std::size_t> rows_;
  std::vector<double> times_;
  double wallTime_ = 0.0;
  double most_ = 0.0;  // force evaluations of the last run
  bool gaveUp_ = false;
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

/// The shortest stretch between times at which a force jumps or a motion begins or ends.
double shortestStretch(const engine::DynamicalSystem& system, double duration) {
  std::vector<double> times = engine::declaredTimes(system, 0.0, duration);
  times.insert(times.begin(), 0.0);
  double shortest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < times.size(); ++i) {
    if (times[i] > times[i - 1]) shortest = std::min(shortest, times[i] - times[i - 1]);
  }
  return shortest;
}

/// Why runs at this step would share a mistake, as far as one can tell beforehand; empty when nothing is known.
std::string sharedMistake(const Scene& scene, const SceneRun& run) {
  const double duration = run.options.duration;
  if (run.result.failed()) return "the run did not reach its end";
  if (run.energy.fails()) return "the run gains energy that nothing gives";
  const bool rubs =
      std::ranges::any_of(scene.model.obstacles, [](const auto& obstacle) { return obstacle.material.mu > 0.0; });
  if (rubs && !scene.locateEvents) return "friction sticks and slips between steps (events are off)";
  if (!run.options.fixedStep) {
    const bool isExact = run.result.work.inClosedForm == run.result.work.steps;
    return run.result.work.steps < 2 && !isExact ? "the whole run is one step" : "";
  }
  const double h = run.options.h;
  if (h >= 0.5 * duration) return fmt::format("the step of {:.3g} s is at least half of the run", h);
  const double period = shortestPeriodOf(*run.system, 0.0, duration);
  if (h > resolvedPart * period) {
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

/// What is known after a run that is finer than the one before.
struct Approach {
  double change = 0.0;    ///< what the last refinement changed, in parts of the motion
  double ratio = 0.0;     ///< by how much less than the refinement before
  double distance = 0.0;  ///< of the first run from the finest
  double expected = std::numeric_limits<double>::infinity();  ///< what the ratio tends to, where that is known
  /// What the finest run has still before it, when further refinements shrink as the last did: at most as the method's
  /// order has it, for more is an accident.
  double rest() const {
    const double shrinks = std::min(ratio, expected);
    return shrinks > 1.0 ? change / (shrinks - 1.0) : std::numeric_limits<double>::infinity();
  }
  /// Whether the first run's error can be told: the runs approach each other, or the finest is near its limit by now.
  /// Where the first is off by more than all that moves, which no approach bounds, the finest has to be near it.
  bool isSeen() const {
    if (distance > 1.0 && change > 0.3) return false;
    return ratio >= slowestApproach || (ratio > 1.15 && rest() < 0.5 * distance);
  }
};

/// Whether two runs move about as far: what is measured in parts of a motion is not known before that is.
bool isAbout(const Sizes& a, const Sizes& b) {
  constexpr double factor = 1.5;
  const auto near = [](double p, double q) { return p <= factor * q && q <= factor * p; };
  return near(a.position, b.position) && near(a.velocity, b.velocity);
}

std::string notSeen(bool fixed, const Approach& approach) {
  return fmt::format("the order is not seen: with {} the result changes {:.2g} times as much as before",
                     fixed ? "half the step" : "a tenth of the tolerance", 1.0 / approach.ratio);
}

std::string howRefined(bool fixed, int runs) {
  constexpr std::array<const char*, 5> times = {"twice", "three times", "four times", "five times", "six times"};
  if (fixed) return fmt::format("steps halved {}", times.at(static_cast<std::size_t>(runs - 2)));
  return runs == 2 ? "tolerances of a tenth and a hundredth" : "tolerances down to a thousandth";
}

/// Estimates the error of a run, with as many finer runs as it needs.
class Estimator {
 public:
  Estimator(const Scene& scene, const SceneRun& run, const std::string& label)
      : scene_(scene), run_(run), fixed_(run.options.fixedStep), runs_(scene, run, label) {}

  ErrorEstimate estimate() {
    RunResult finer = runs_.at(2.0);
    if (finer.failed()) return failure(runs_.failure("finer"));
    const Sizes difference = runs_.differenceFromFirst(finer);
    const Scale scale = scaleOf(scene_, run_, finer);
    const double change = scale.errorOf(difference);
    if (change <= 4.0 * scale.rounding())
      return settle(finer, scale, difference, 1.0, fixed_ ? "step halved" : "a tenth of the tolerance");
    const double ratio = changeToCoarser(scale) / change;
    const double expected = std::pow(2.0, run_.method.order);
    // Of a large error the next order's part may look like an order, so that it has to look the more like it.
    const double wide = change > 0.01 ? 1.3 : 1.7;
    const bool seen = fixed_ ? ratio > expected / wide && ratio < wide * expected : ratio > 4.0 && ratio < 30.0;
    // A tolerance does not fix the steps, so that a run may be better than its finer one by accident.
    const bool isDoubtful = !fixed_ && stepsTimesUnknowns() <= quicklyDone / 1000.0;
    if (!seen || change > surelySmall || isDoubtful) return refine(std::move(finer), change);
    const double shrinks = fixed_ ? std::min(ratio, expected) : ratio;
    return settle(finer, scale, difference, shrinks / (shrinks - 1.0),
                  fixed_ ? fmt::format("step halved, order {} seen", run_.method.order) : "a tenth of the tolerance");
  }

 private:
  /// What twice the step would change; 0 where such a run does not reach its end.
  double changeToCoarser(const Scale& scale) {
    const RunResult coarser = runs_.at(0.5);
    return coarser.failed() ? 0.0 : scale.errorOf(runs_.differenceFromFirst(coarser));
  }

  /// Three, and up to six where they are quickly done.
  int mostRuns() const {
    int most = 3;
    while (fixed_ && most < 6 && stepsTimesUnknowns() * std::pow(2.0, most + 1) <= quicklyDone) ++most;
    return most;
  }

  /// What a run costs.
  double stepsTimesUnknowns() const { return static_cast<double>(run_.result.work.steps) * run_.system->size(); }

  /// Runs that approach each other faster than any error shrinks agree by accident. (Events are located by dense output
  /// of the fourth order or so.)
  double fastestApproach() const {
    const int order = run_.result.work.events > 0 ? std::min(run_.method.order, 4) : run_.method.order;
    return fixed_ ? 1.7 * std::pow(2.0, order) : 30.0;
  }

  ErrorEstimate refine(RunResult before, double change) {
    const int most = mostRuns();
    const double expected = fixed_ ? std::pow(2.0, run_.method.order) : std::numeric_limits<double>::infinity();
    Approach approach{change, 0.0, change, expected};
    for (int n = 2; n <= most; ++n) {
      RunResult finest = runs_.at(std::pow(2.0, n));
      if (finest.failed()) return failure(runs_.failure("finest"));
      const Scale scale = scaleOf(scene_, run_, finest);
      const Sizes difference = runs_.differenceFromFirst(finest);
      const double last = scale.errorOf(runs_.difference(before, finest));
      approach = {last, last > 0.0 ? approach.change / last : std::numeric_limits<double>::infinity(),
                  scale.errorOf(difference), expected};
      const bool settled = isAbout(scale.motion, scaleOf(scene_, run_, before).motion);
      const bool seen = settled && approach.isSeen() && (n == most || approach.ratio <= fastestApproach());
      if (seen || last <= 4.0 * scale.rounding()) {
        // Where the whole motion is off the differences have no sign to add up by.
        const bool coherent = approach.ratio >= slowestApproach && approach.distance > 0.0 && approach.distance < 0.3;
        const double factor = coherent ? 1.0 + approach.rest() / approach.distance : 1.0;
        return settle(finest, scale, difference, factor, howRefined(fixed_, n));
      }
      if (n == most && approach.distance < surelyRounding) {
        ErrorEstimate estimate = settle(finest, scale, difference, 1.0, howRefined(fixed_, n));
        estimate.atRounding = true;
        return estimate;
      }
      before = std::move(finest);
    }
    return failure(notSeen(fixed_, approach));
  }

  ErrorEstimate settle(const RunResult& finest, const Scale& scale, const Sizes& difference, double factor,
                       std::string how) {
    const double loss = lostEnergy(run_.energy, finest);
    if (loss > mostLoss) return failure(lossSentence(loss));
    ErrorEstimate estimate;
    estimate.how = std::move(how);
    estimate.wallTime = runs_.wallTime();
    take(estimate, scale, difference, factor);
    return estimate;
  }

  ErrorEstimate failure(std::string reason) const {
    ErrorEstimate estimate;
    estimate.failure = std::move(reason);
    estimate.wallTime = runs_.wallTime();
    return estimate;
  }

  const Scene& scene_;
  const SceneRun& run_;
  bool fixed_;
  Refinement runs_;
};

}  // namespace

ErrorEstimate estimateError(const Scene& scene, const SceneRun& run, const std::string& label) {
  ErrorEstimate none;
  none.failure = sharedMistake(scene, run);
  if (!none.failure.empty()) return none;
  return Estimator(scene, run, label).estimate();
}

}  // namespace muelle::lab
