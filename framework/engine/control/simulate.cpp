#include "engine/control/simulate.h"

#include "base/progress_bar.h"
#include "base/text/count.h"
#include "engine/analysis/numerical_damping.h"
#include "engine/analysis/stability.h"
#include "engine/control/event_locator.h"
#include "engine/control/motion_frame.h"
#include "engine/control/run_checks.h"
#include "engine/control/run_recorder.h"
#include "engine/control/step_controller.h"
#include "engine/control/step_grid.h"
#include "engine/control/stepper.h"
#include "harness/run_monitor.h"

#include <fmt/format.h>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

namespace muelle::engine {

namespace {

constexpr int mostRetries = 30;
constexpr int mostFailures = 60;  // within one step of the grid
constexpr std::size_t mostKeptEvents = 10'000;
constexpr int mostLooks = 3;       // at the stability during a run
constexpr int mostCrossings = 20;  // of one guard within a step

std::vector<double> declaredTimes(const DynamicalSystem& system, double from, double to) {
  std::vector<double> times;
  if (system.switching() != nullptr) system.switching()->declaredTimes(from, to, times);
  return times;
}

/// The energy of all that has one, for the monitor; empty when the system has none.
std::function<double(const State&)> potentialEnergyOf(const DynamicalSystem& system) {
  const Potential* potential = system.potential();
  if (potential == nullptr) return {};
  return [potential](const State& state) { return potential->energy(state.t, state.x, state.z); };
}

/// One run: plans each step, takes it, looks at what came out, and goes on from there.
class Run {
 public:
  Run(const DynamicalSystem& system, Integrator& method, State start, const RunOptions& options);
  RunResult go();

 private:
  void warnBefore();
  void warnOfBounces();
  void lookAtStabilityAgain();
  void begin();
  bool advance();
  PlannedStep plan() const;
  PlannedStep planByError() const;
  void cutAtObstacles(PlannedStep& step);
  StepResult locateEvent(PlannedStep& step);
  bool take(PlannedStep& step);
  bool forceIsFinite(double t);
  bool retryFailed(const PlannedStep& step, const StepResult& result);
  bool retryInexact(const PlannedStep& step, const StepResult& result);
  void shorten(PlannedStep& step, double length) const;
  void finishStep(const PlannedStep& step);
  void move(const PlannedStep& step);
  bool crossGuards();
  bool chatters(const std::vector<int>& crossed);
  void goLive(int guard);
  void updateModes(bool jump);
  double nominalStep() const { return adaptive_ ? controller_->h() : options_.h; }
  bool limitsHold();
  bool stop(StopReport report);
  void warnOnce(bool& given, std::string text);
  void addEvent(std::string what);
  double shortestStep() const;
  RunResult finish();

  const DynamicalSystem& system_;
  Integrator& method_;
  const RunOptions& options_;
  const Switching* switching_;
  bool adaptive_;
  bool frozen_;
  double start_;
  double end_;
  State from_, to_;
  StopTimes stops_;
  TimeGrid grid_;
  std::optional<StepController> controller_;
  std::optional<MotionScale> scale_;  // of an adaptive run
  Stepper stepper_;
  std::optional<EventLocator> locator_;
  RunRecorder recorder_;
  RunMonitor monitor_;
  StopReport report_;
  RunResult result_;
  double piece_ = std::numeric_limits<double>::infinity();  // longest step after failures of a fixed step
  int retries_ = 0;                                         // of the present step
  int failures_ = 0;                                        // of a fixed step since the grid was last met
  std::vector<int> crossings_;                              // of each guard since windowStart_
  double windowStart_ = 0.0;
  double liveUntil_ = 0.0;  // after chatter: events are not located before this time
  bool warnedOfChatter_ = false;
  int looks_ = 0;  // at the stability, after modes have switched
  bool warnedOfInstability_ = false;
  bool warnedOfCuts_ = false;
  bool warnedOfFailures_ = false;
};

Run::Run(const DynamicalSystem& system, Integrator& method, State start, const RunOptions& options)
    : system_(system),
      method_(method),
      options_(options),
      switching_(system.switching()),
      adaptive_(method.info().adaptive && !options.fixedStep),
      frozen_(options.locateEvents && system.switching() != nullptr),
      start_(start.t),
      end_(start.t + options.duration),
      from_(std::move(start)),
      stops_(start_, end_, frozen_ ? declaredTimes(system, start_, end_) : std::vector<double>{}, options.outputTimes),
      grid_(start_, options.h),
      stepper_(system, method, options.compensated, from_.x.size()),
      recorder_(options, start_),
      monitor_(
          system, options.explosion, options.duration,
          [&system](std::size_t unknown) { return system.unknownName(static_cast<int>(unknown)); },
          potentialEnergyOf(system)) {
  if (from_.z.empty()) from_.z.assign(static_cast<std::size_t>(system.internalSize()), 0.0);
  if (!frozen_) return;
  locator_.emplace(system, method, stepper_);
  crossings_.assign(static_cast<std::size_t>(switching_->guardCount()), 0);
  windowStart_ = start_;
}

RunResult Run::go() {
  using Clock = std::chrono::steady_clock;
  const auto begun = Clock::now();
  ProgressBar progress(options_.label);
  report_ = monitor_.checkStart(from_);
  if (!report_.stopped) {
    begin();
    while (!stops_.finished() && advance()) progress.update((from_.t - start_) / options_.duration);
  } else {
    recorder_.record(from_);
  }
  RunResult result = finish();
  result.wallTime = std::chrono::duration<double>(Clock::now() - begun).count() - result.checkTime;
  return result;
}

/// What can be said of a fixed step before the run; the method is run on other systems for it.
void Run::warnBefore() {
  if (adaptive_) return;
  if (options_.checkStability) {
    const double steps = options_.duration / options_.h;
    std::string warning = instabilityWarning(system_, method_, from_, options_.h, steps);
    if (!warning.empty()) warnOnce(warnedOfInstability_, std::move(warning));
  }
  if (options_.checkStability) {
    warnOfBounces();
    std::string warning = unresolvedWarning(system_, start_, end_, options_.h);
    if (!warning.empty()) result_.warnings.push_back(std::move(warning));
  }
  if (options_.checkNumericalDamping) {
    const NumericalDamping damping = numericalDamping(system_, method_, from_, options_.h, options_.duration);
    if (damping.exceeds) result_.warnings.push_back(damping.sentence);
  }
}

/// A bounce is a jump of the force when few steps fall into it.
void Run::warnOfBounces() {
  if (switching_ == nullptr) return;
  constexpr double enough = 20.0;
  const double bounce = switching_->shortestBounce(from_);
  if (!(options_.h * enough > bounce) || options_.duration < bounce) return;
  result_.warnings.push_back(
      fmt::format("a bounce off an obstacle lasts {:.3g} s: h = {:.3g} s leaves {:.2g} steps for it, and {:.0f} are "
                  "wanted (h up to "
                  "{:.3g} s)",
                  bounce, options_.h, bounce / options_.h, enough, bounce / enough));
}

/// Modes have switched on that the look before the run may not have counted: several contacts at once.
void Run::lookAtStabilityAgain() {
  if (adaptive_ || !options_.checkStability || warnedOfInstability_ || ++looks_ > mostLooks) return;
  std::string warning = lateInstabilityWarning(system_, method_.info(), from_, options_.h);
  if (!warning.empty()) warnOnce(warnedOfInstability_, std::move(warning));
}

void Run::begin() {
  method_.prepare(system_, options_.tolerance);  // first of all: it says what the system lacks
  if (options_.checkStability || options_.checkNumericalDamping) {
    using Clock = std::chrono::steady_clock;
    const auto begun = Clock::now();
    warnBefore();
    method_.prepare(system_, options_.tolerance);
    result_.checkTime = std::chrono::duration<double>(Clock::now() - begun).count();
  }
  method_.resetWork();
  if (switching_ != nullptr) switching_->commit(from_, frozen_);
  method_.restart();
  to_ = from_;
  recorder_.record(from_);
  result_.smallestStep = std::numeric_limits<double>::infinity();
  if (options_.compensated && !method_.hasIncrements()) {
    result_.warnings.push_back(fmt::format(
        "{} does not give its increments: compensated summation removes none of its rounding", method_.info().name));
  }
  if (switching_ != nullptr && !frozen_ && !declaredTimes(system_, start_, end_).empty()) {
    result_.warnings.push_back("events are not located: the force jumps at declared times, which a step may pass over");
  }
  if (adaptive_) {
    scale_.emplace(system_, from_, options_.duration);
    method_.measureErrorsBy(scale_->scale());
    const int order = std::max(1, method_.info().order);
    const double h = options_.h > 0.0 ? options_.h
                                      : firstStep(system_, from_, order, options_.tolerance.relative, scale_->scale(),
                                                  options_.duration, result_.work);
    controller_.emplace(order, h, options_.largestStep);
  }
  if (locator_) locator_->start(from_, nominalStep());
}

double Run::shortestStep() const { return std::max(2.0 * timeRounding(from_.t, end_), 1e-15 * options_.duration); }

PlannedStep Run::planByError() const {
  // Lest a vibration looks like none.
  const double h = std::min(controller_->h(), system_.shortestPeriod(from_.t) / options_.stepsAPeriod);
  const double rest = stops_.next().t - from_.t;
  if (rest <= h * (1.0 + 1e-6)) return {stops_.next().t, rest, true, false};
  // Two equal steps to the stop instead of a long one and a sliver.
  const double t = from_.t + (rest < 2.0 * h ? 0.5 * rest : h);
  // The length is the difference of the two times, which is exact, so that the time never drifts from the sum of steps.
  return {t, t - from_.t, false, false};
}

PlannedStep Run::plan() const {
  PlannedStep step = adaptive_ ? planByError() : grid_.plan(from_.t, stops_.next());
  // Pieces that end by rounding short of the grid would leave a sliver of a step.
  if (step.length > piece_ * (1.0 + 1e-6)) shorten(step, piece_);
  return step;
}

void Run::shorten(PlannedStep& step, double length) const {
  step.t = from_.t + length;
  step.length = step.t - from_.t;
  step.reachesStop = step.reachesGrid = false;
}

void Run::cutAtObstacles(PlannedStep& step) {
  if (switching_ == nullptr) return;
  const double bound = switching_->sweptBound(from_.t, from_.x, from_.v, from_.z, step.length);
  if (bound >= step.length) return;
  const double pieces = std::ceil(step.length / std::max(bound, shortestStep()));
  shorten(step, step.length / pieces);
  ++result_.subdividedSteps;
  if (warnedOfCuts_) return;
  warnOnce(warnedOfCuts_,
           fmt::format("t = {:.6g} s: the step is cut to {:.3g} s so that no node passes through an obstacle", from_.t,
                       step.length));
}

bool Run::advance() {
  retries_ = 0;
  PlannedStep step = plan();
  cutAtObstacles(step);
  if (!take(step)) return false;
  finishStep(step);
  return limitsHold();
}

bool Run::take(PlannedStep& step) {
  for (;;) {
    const StepResult result = stepper_.step(from_, step.length, step.t, to_);
    bool again = false;
    if (!result.done) {
      again = retryFailed(step, result);
    } else if (adaptive_ && !(result.error <= 1.0)) {
      again = retryInexact(step, result);
    } else {
      if (!stop(monitor_.checkStep(from_, to_))) return false;
      if (adaptive_) controller_->accept(step.length, result.error);
      const StepResult located = locateEvent(step);
      if (located.done) return true;
      again = retryFailed(step, located);
    }
    if (!again) return false;
    shorten(step, adaptive_ ? std::min(controller_->h(), step.length) : piece_);
  }
}

/// Looks for the cause of a failed step: the force at its begin, or at another time from there.
bool Run::forceIsFinite(double t) {
  std::vector<double> force(from_.x.size());
  system_.force(t, from_.x, from_.v, from_.z, force);
  for (std::size_t i = 0; i < force.size(); ++i) {
    if (std::isfinite(force[i])) continue;
    const int unknown = static_cast<int>(i);
    return stop(
        {true, t, unknown, fmt::format("t = {:.6g} s, {}: the force is not finite", t, system_.unknownName(unknown))});
  }
  return true;
}

bool Run::retryFailed(const PlannedStep& step, const StepResult& result) {
  if (!forceIsFinite(from_.t)) return false;
  ++result_.work.rejectedSteps;
  if (adaptive_) controller_->fail(step.length);
  piece_ = adaptive_ ? piece_ : 0.5 * step.length;
  if (++failures_ > mostFailures) {
    return stop({true, from_.t, -1,
                 fmt::format("t = {:.6g} s: {} fails in pieces of h = {:.3g} s again and again, the last of {:.3g} s: "
                             "{}; take a shorter step, or look for a place where the force jumps",
                             from_.t, method_.info().name, nominalStep(), step.length, result.failure)});
  }
  if (result.retry && ++retries_ <= mostRetries && 0.25 * step.length > shortestStep()) {
    if (!warnedOfFailures_) {
      warnOnce(warnedOfFailures_, fmt::format("t = {:.6g} s: a step of {:.3g} s failed ({}) and is taken in pieces",
                                              from_.t, step.length, result.failure));
    }
    return true;
  }
  if (!forceIsFinite(from_.t + 2.0 * step.length)) return false;  // compositions look beyond the step's end
  return stop({true, from_.t, -1,
               fmt::format("t = {:.6g} s: {} fails even with a step of {:.3g} s: {}", from_.t, method_.info().name,
                           step.length, result.failure)});
}

bool Run::retryInexact(const PlannedStep& step, const StepResult& result) {
  ++result_.work.rejectedSteps;
  controller_->reject(step.length, result.error);
  const bool overflow = !std::isfinite(result.error);
  ++retries_;
  if (retries_ <= mostRetries && controller_->h() > shortestStep()) return true;
  if (overflow && !stop(monitor_.checkStep(from_, to_))) return false;
  if (overflow && !forceIsFinite(from_.t + step.length)) return false;
  return stop({true, from_.t, -1,
               fmt::format("t = {:.6g} s: the step falls below {:.3g} s and its error is still {:.3g} times the "
                           "tolerance; look for a force that jumps, or ask for less than {:.1g} of the motion",
                           from_.t, step.length, result.error, options_.tolerance.relative)});
}

/// Shortens the step that has just been taken to the first event in it.
StepResult Run::locateEvent(PlannedStep& step) {
  if (!frozen_) return {};
  const EventLocator::Found found = locator_->locate(from_, to_);
  if (!found.event || to_.t == step.t) return found.step;
  step.t = to_.t;
  step.length = found.length;
  step.reachesStop = step.reachesGrid = false;
  return found.step;
}

void Run::finishStep(const PlannedStep& step) {
  if (step.length > 0.0) move(step);
  bool asked = false;
  bool jump = false;
  if (step.reachesStop) {
    asked = stops_.next().output;
    jump = stops_.next().declared;
    stops_.advance();
    if (jump) addEvent("declared time");
  }
  if (frozen_ && crossGuards()) jump = true;
  updateModes(jump);
  if (step.length > 0.0) recorder_.recordEnd(from_, asked);
}

void Run::move(const PlannedStep& step) {
  recorder_.recordInside(system_, method_, from_, to_);
  stepper_.accept();
  std::swap(from_, to_);
  ++result_.work.steps;
  result_.smallestStep = std::min(result_.smallestStep, step.length);
  if (adaptive_) {
    scale_->follow(system_, from_);
    method_.measureErrorsBy(scale_->scale());
  } else {
    grid_.moved(step.reachesGrid);
  }
  if (adaptive_ || step.reachesGrid) failures_ = 0;
  // After a failure the pieces grow again, at most to the grid's step.
  if (piece_ < options_.h) piece_ *= 2.0;
}

bool Run::crossGuards() {
  const std::vector<int> crossed = locator_->crossed();
  for (const int guard : crossed) {
    switching_->cross(guard, from_);
    addEvent(switching_->eventName(guard, from_));
  }
  if (chatters(crossed)) goLive(crossed.front());
  return !crossed.empty();
}

/// Whether a guard crosses to and fro so often that the events make no headway.
bool Run::chatters(const std::vector<int>& crossed) {
  if (from_.t - windowStart_ > nominalStep()) {
    windowStart_ = from_.t;
    std::fill(crossings_.begin(), crossings_.end(), 0);
  }
  bool often = false;
  for (const int guard : crossed) often |= ++crossings_[static_cast<std::size_t>(guard)] > mostCrossings;
  return often;
}

/// Takes the next step with live modes: the force then switches within the step, as it does without event location.
void Run::goLive(int guard) {
  frozen_ = false;
  liveUntil_ = from_.t + nominalStep();
  std::fill(crossings_.begin(), crossings_.end(), 0);
  if (warnedOfChatter_) return;
  warnOnce(warnedOfChatter_,
           fmt::format("t = {:.6g} s: '{}' happens more than {} times within a step; the next step is "
                       "taken without locating events",
                       from_.t, switching_->guardName(guard), mostCrossings));
}

/// Commits the state, and tells method and locator what that has changed.
void Run::updateModes(bool jump) {
  if (switching_ == nullptr) return;
  const bool freezeAgain = locator_ && !frozen_ && from_.t >= liveUntil_;
  frozen_ = frozen_ || freezeAgain;
  if (switching_->commit(from_, frozen_)) jump = true;
  if (jump || freezeAgain) method_.restart();
  if (jump) lookAtStabilityAgain();
  if (freezeAgain) {
    locator_->start(from_, nominalStep());
  } else if (frozen_) {
    locator_->settle(from_);
  }
}

bool Run::limitsHold() {
  if (stops_.finished()) return true;
  if (result_.work.steps >= options_.mostSteps) {
    return stop(
        {true, from_.t, -1,
         fmt::format("t = {:.6g} s: the limit of {} is reached", from_.t, counted(options_.mostSteps, "step"))});
  }
  const long long evaluations = result_.work.forceEvaluations + method_.work().forceEvaluations;
  if (evaluations < options_.mostForceEvaluations) return true;
  return stop({true, from_.t, -1,
               fmt::format("t = {:.6g} s: the limit of {} is reached", from_.t,
                           counted(options_.mostForceEvaluations, "force evaluation"))});
}

/// Takes the report; true when there is nothing to stop for.
bool Run::stop(StopReport report) {
  report_ = std::move(report);
  return !report_.stopped;
}

void Run::warnOnce(bool& given, std::string text) {
  if (!given) result_.warnings.push_back(std::move(text));
  given = true;
}

void Run::addEvent(std::string what) {
  ++result_.work.events;
  if (result_.events.size() < mostKeptEvents) result_.events.push_back({from_.t, std::move(what)});
}

RunResult Run::finish() {
  recorder_.recordOnce(from_);
  if (recorder_.kept() > 1) {
    result_.warnings.push_back(fmt::format("the outputs would take more than {:.0f} MiB: every {}th is kept",
                                           options_.mostMemory / (1024.0 * 1024.0), recorder_.kept()));
  }
  result_.trajectory = recorder_.finish(std::move(report_));
  result_.last = std::move(from_);
  const Work own = result_.work;
  Work method = method_.work();
  method.steps = method.rejectedSteps = method.events = 0;  // counted here
  result_.work = own;
  result_.work += method;
  if (!std::isfinite(result_.smallestStep)) result_.smallestStep = 0.0;
  return std::move(result_);
}

}  // namespace

RunResult simulate(const DynamicalSystem& system, Integrator& method, State start, const RunOptions& options) {
  checkSizes(system, start);
  checkOptions(options, start, method.info().adaptive && !options.fixedStep);
  checkForesight(system, method.info(), options);
  checkRodsAreHeld(system, method.info());
  return Run(system, method, std::move(start), options).go();
}

}  // namespace muelle::engine
