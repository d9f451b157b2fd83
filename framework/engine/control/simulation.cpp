#include "engine/control/simulation.h"

#include "engine/control/failure_report.h"
#include "engine/control/run_checks.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace muelle::engine {

namespace {

constexpr int mostRetries = 30;
constexpr std::size_t mostKeptEvents = 10'000;

/// The energy of all that has one, for the monitor; empty when the system has none.
std::function<double(const State&)> potentialEnergyOf(const DynamicalSystem& system) {
  const Potential* potential = system.potential();
  if (potential == nullptr) return {};
  return [potential](const State& state) { return potential->energy(state.t, state.x, state.z); };
}

/// The state, after a look at whether it and the options make sense: they have to before anything is made of them.
State checked(const DynamicalSystem& system, const MethodInfo& method, State start, const StepOptions& options) {
  checkSizes(system, start);
  checkStepOptions(options, start, method.adaptive && !options.fixedStep);
  checkForesight(system, method, options);
  checkRodsAreHeld(system, method);
  if (start.z.empty()) start.z.assign(static_cast<std::size_t>(system.internalSize()), 0.0);
  return start;
}

/// With the energy of all that has one, and the system's names.
RunMonitor monitorOf(const DynamicalSystem& system, const StepOptions& options) {
  return {system, options.explosion, options.duration,
          [&system](std::size_t unknown) { return laneName(system, static_cast<int>(unknown)); },
          potentialEnergyOf(system)};
}

}  // namespace

Simulation::Simulation(const DynamicalSystem& system, Integrator& method, State start, StepOptions options)
    : system_(system),
      method_(method),
      options_(std::move(options)),
      adaptive_(method.info().adaptive && !options_.fixedStep),
      state_(checked(system, method.info(), std::move(start), options_)),
      stepper_(system, method, options_.compensated, adaptive_ && options_.locateEvents, state_.x.size()),
      planner_(system, options_, adaptive_, adaptive_ || options_.locateEvents, state_.t),
      modes_(system, stepper_, options_.locateEvents),
      monitor_(monitorOf(system, options_)) {
  method_.resetWork();
  if (goesOn(monitor_.checkStart(state_))) begin();
}

void Simulation::begin() {
  method_.prepare(system_, options_.tolerance);  // first of all: it says what the system lacks
  method_.resetWork();
  modes_.commitStart(state_);
  other_ = state_;
  toStart_ = toRestart_ = true;
  if (options_.compensated && !method_.hasIncrements()) {
    warn(fmt::format("{} does not give its increments: compensated summation removes none of its rounding",
                     method_.info().name));
  }
  if (!modes_.frozen() && !adaptive_ && !declaredTimes(system_, state_.t, planner_.end()).empty()) {
    warn("events are not located: the force jumps at declared times, which a step may pass over");
  }
  startErrorControl();
}

void Simulation::startErrorControl() {
  if (!adaptive_) return;
  if (scale_) {
    scale_->follow(system_, state_);
  } else {
    scale_.emplace(system_, state_, options_.duration);
  }
  method_.measureErrorsBy(scale_->scale());
  chooseFirstStep();
  toChooseStep_ = stepper_.closedForm(state_).exists();
}

void Simulation::chooseFirstStep() {
  planner_.chooseFirstStep(state_, std::max(1, method_.info().order), scale_->scale(), work_);
  toChooseStep_ = false;
}

void Simulation::setState(State state) {
  if (state.t != state_.t) {
    throw std::invalid_argument(
        fmt::format("setState: the state is one of t = {} s; now it is t = {} s", state.t, state_.t));
  }
  checkSizes(system_, state);
  for (const std::vector<double>* values : {&state.x, &state.v}) {
    const auto bad = std::ranges::find_if_not(*values, [](double value) { return std::isfinite(value); });
    if (bad == values->end()) continue;
    throw std::invalid_argument(fmt::format("setState: {}: the {} is not finite",
                                            laneName(system_, static_cast<int>(bad - values->begin())),
                                            values == &state.x ? "position" : "velocity"));
  }
  if (state.z.empty()) state.z.assign(static_cast<std::size_t>(system_.internalSize()), 0.0);
  if (toAccept_) stepper_.accept();
  toAccept_ = false;
  stepper_.forget();
  state_ = std::move(state);
  restart();
}

void Simulation::restart() {
  if (!goesOn(monitor_.checkStart(state_))) return;
  setMethodAside();
  prepareAgain();  // what the method keeps of the system may have changed
  modes_.commitAnew(state_);
  other_ = state_;
  planner_.restart(state_.t);
  toStart_ = true;
  startErrorControl();
}

void Simulation::lendMethod(const std::function<void(Integrator& method)>& use) {
  setMethodAside();
  use(method_);
  prepareAgain();
}

/// The last step is done with: its cost is noted, and one can no longer look into it.
void Simulation::setMethodAside() {
  if (toAccept_) stepper_.accept();
  toAccept_ = hasStep_ = false;
  work_ = work();
  method_.resetWork();
}

void Simulation::prepareAgain() {
  method_.prepare(system_, options_.tolerance);
  method_.resetWork();
  if (scale_) method_.measureErrorsBy(scale_->scale());
  toRestart_ = true;
}

/// What the last step has left to be said to the method.
void Simulation::tellMethod() {
  if (toAccept_) stepper_.accept();
  if (toRestart_) method_.restart();
  if (toStart_) modes_.start(state_, planner_.nominal());
  toAccept_ = toRestart_ = toStart_ = hasStep_ = false;
}

Advance Simulation::advance() {
  if (report_.stopped) return {.kind = Advance::Kind::Stopped};
  if (finished()) return {.kind = Advance::Kind::Finished};
  if (tried_ && !limitsHold()) return {.kind = Advance::Kind::Stopped};
  tellMethod();
  tried_ = true;
  retries_ = 0;
  const LaneMotion motion = stepper_.closedForm(state_);
  if (!motion.exists() && toChooseStep_) chooseFirstStep();  // no flight tells how long the method's steps should be
  PlannedStep step = motion.exists() ? planner_.planClosedForm(state_.t, motion.longest) : planner_.plan(state_.t);
  cutAtObstacles(step);
  if (!take(step)) return {.kind = Advance::Kind::Stopped};
  return finishStep(step);
}

bool Simulation::advanceTo(double t) {
  while (time() < t) {
    if (!advance().goesOn()) return false;
  }
  return true;
}

double Simulation::stepBegin() const { return hasStep_ ? other_.t : state_.t; }

const State& Simulation::at(double t) {
  if (t == state_.t) return state_;
  if (!(t >= stepBegin() && t < state_.t)) {
    throw std::out_of_range(
        fmt::format("at: t = {} s is not in the last step, which goes from {} to {} s", t, stepBegin(), state_.t));
  }
  stepper_.interpolate(other_, state_, (t - other_.t) / (state_.t - other_.t), inside_);
  inside_.t = t;
  return inside_;
}

void Simulation::cutAtObstacles(PlannedStep& step) {
  if (!planner_.cutAtObstacles(state_, step)) return;
  ++subdividedSteps_;
  if (warnedOfCuts_) return;
  warnOnce(warnedOfCuts_,
           fmt::format("t = {:.6g} s: the step is cut to {:.3g} s so that no node passes through an obstacle", state_.t,
                       step.length));
}

bool Simulation::take(PlannedStep& step) {
  for (;;) {
    const StepResult result = stepper_.step(state_, step.length, step.t, other_);
    bool again = false;
    if (!result.done) {
      again = retryFailed(step, result);
    } else if (adaptive_ && !(result.error <= 1.0)) {
      again = retryInexact(step, result);
    } else {
      if (looksAtEnergy() && !goesOn(monitor_.checkEnergy(state_, other_))) return false;
      if (!stepper_.wasInClosedForm()) planner_.accept(step.length, result.error);
      if (!modes_.frozen()) return true;  // no events are looked for
      const StepResult located = locateEvent(step);
      if (located.done) return true;
      again = retryFailed(step, located);
    }
    if (!again) return false;
    planner_.shortenAfterFailure(step, state_.t);
  }
}

/// A step that is done is finite; that the energy explodes shows in some later step as well, and with many lanes it
/// costs a tenth of a step to look.
bool Simulation::looksAtEnergy() const {
  constexpr std::size_t many = 64;
  return state_.x.size() < many || work_.steps % 4 == 0;
}

bool Simulation::retryFailed(const PlannedStep& step, const StepResult& result) {
  if (!goesOn(notFiniteForce(system_, state_, state_.t))) return false;
  ++work_.rejectedSteps;
  planner_.fail(step.length);
  if (planner_.failsTooOften()) {
    return goesOn(failingPieces(method_.info(), state_.t, planner_.nominal(), step.length, result));
  }
  if (result.retry && ++retries_ <= mostRetries && 0.25 * step.length > planner_.shortest(state_.t)) {
    if (!warnedOfFailures_) {
      warnOnce(warnedOfFailures_, fmt::format("t = {:.6g} s: a step of {:.3g} s failed ({}) and is taken in pieces",
                                              state_.t, step.length, result.failure));
    }
    return true;
  }
  // Compositions look beyond the step's end.
  if (!goesOn(notFiniteForce(system_, state_, state_.t + 2.0 * step.length))) return false;
  return goesOn(failedStep(method_.info(), state_.t, step.length, result));
}

bool Simulation::retryInexact(const PlannedStep& step, const StepResult& result) {
  ++work_.rejectedSteps;
  planner_.reject(step.length, result.error);
  ++retries_;
  if (retries_ <= mostRetries && planner_.nominal() > planner_.shortest(state_.t)) return true;
  if (!std::isfinite(result.error)) {
    if (!goesOn(monitor_.checkStep(state_, other_))) return false;
    if (!goesOn(notFiniteForce(system_, state_, state_.t + step.length))) return false;
  }
  return goesOn(inexactStep(state_.t, step.length, result, options_.tolerance));
}

/// Shortens the step that has just been taken to the first event in it.
StepResult Simulation::locateEvent(PlannedStep& step) {
  const EventLocator::Found found = modes_.locate(state_, other_);
  if (!found.event || other_.t == step.t) return found.step;
  step.t = other_.t;
  step.length = found.length;
  step.reachesStop = step.reachesGrid = false;
  return found.step;
}

Advance Simulation::finishStep(const PlannedStep& step) {
  Advance done{.kind = Advance::Kind::Event, .length = step.length};
  if (step.length > 0.0) {
    done.kind = Advance::Kind::Step;
    move(step);
  }
  if (step.reachesStop) {
    const StopTimes::Stop stop = planner_.reachStop();
    done.atOutput = stop.output;
    done.hasJumped = stop.declared;
    if (stop.declared) addEvent("declared time");
  }
  if (crossGuards()) done.hasJumped = true;
  done.hasJumped = commit(done.hasJumped);
  return done;
}

void Simulation::move(const PlannedStep& step) {
  if (stepper_.wasInClosedForm()) ++work_.inClosedForm;
  std::swap(state_, other_);
  hasStep_ = toAccept_ = true;
  ++work_.steps;
  smallestStep_ = std::min(smallestStep_, step.length);
  if (adaptive_) {
    scale_->follow(system_, state_);
    method_.measureErrorsBy(scale_->scale());
  }
  planner_.moved(step);
}

bool Simulation::crossGuards() {
  if (!modes_.frozen()) return false;
  ModeKeeper::Crossing crossing = modes_.cross(state_, planner_.nominal());
  const bool any = !crossing.events.empty();
  for (std::string& event : crossing.events) addEvent(std::move(event));
  if (!crossing.chatter.empty() && !warnedOfChatter_) {
    warnOnce(warnedOfChatter_,
             fmt::format("t = {:.6g} s: '{}' happens more than {} times within a step; the next step is "
                         "taken without locating events",
                         state_.t, crossing.chatter, ModeKeeper::mostCrossings));
  }
  return any;
}

/// Commits the state that is reached; whether the force may have changed.
bool Simulation::commit(bool jump) {
  const ModeKeeper::Commit committed = modes_.commit(state_, jump, planner_.nominal());
  if (committed.restart) toRestart_ = true;
  return committed.jump;
}

bool Simulation::limitsHold() {
  const long long evaluations = method_.work().forceEvaluations + work_.forceEvaluations;
  if (work_.steps < options_.mostSteps && evaluations < options_.mostForceEvaluations) return true;
  return goesOn(reachedLimit(options_, work(), state_.t));
}

/// Takes the report; true when there is nothing to stop for.
bool Simulation::goesOn(StopReport report) {
  if (report.stopped || report_.stopped) report_ = std::move(report);
  return !report_.stopped;
}

void Simulation::warnOnce(bool& given, std::string text) {
  if (!given) warn(std::move(text));
  given = true;
}

void Simulation::addEvent(std::string what) {
  ++work_.events;
  if (events_.size() < mostKeptEvents) events_.push_back({state_.t, std::move(what)});
}

Work Simulation::work() const {
  Work all = method_.work();
  all.steps = all.inClosedForm = all.rejectedSteps = all.events = 0;  // counted here
  all += work_;
  return all;
}

}  // namespace muelle::engine
