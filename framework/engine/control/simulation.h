#pragma once
#include "engine/control/mode_keeper.h"
#include "engine/control/motion_frame.h"
#include "engine/control/step_options.h"
#include "engine/control/step_planner.h"
#include "engine/control/stepper.h"
#include "harness/run_monitor.h"
#include "harness/trajectory.h"

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace muelle::engine {

/// Something found while steps are taken, with its time.
struct RunEvent {
  double t = 0.0;
  std::string what;  ///< "node 3 touches 'ground'", "declared time"
};

/// What a call of Simulation::advance() has done.
struct Advance {
  enum class Kind {
    Step,      ///< an accepted step
    Event,     ///< an event at the very place where the step would have begun: time has not passed
    Finished,  ///< nothing: the duration has passed
    Stopped,   ///< nothing: the step failed, or a limit is reached; Simulation::stop() says why
  };
  Kind kind = Kind::Finished;
  double length = 0.0;     ///< of the step [s]
  bool atOutput = false;   ///< it ends at one of StepOptions::outputTimes, or at the end
  bool hasJumped = false;  ///< the force may have changed at its end: an event, a declared time, another mode

  /// Whether a further call may do something.
  bool goesOn() const { return kind == Kind::Step || kind == Kind::Event; }
};

/// A system on its way through time, a step at a call: for players, who look and push between steps, and for whoever
/// needs more of a run than simulate() keeps. What simulate() runs inside, with the same numbers to the last bit.
///
///     Simulation simulation(system, method, start, options);
///     while (simulation.advance().goesOn()) draw(simulation.state());
///
/// Steps are chosen by the error estimate of an adaptive method, else they are options.h; they end at declared times,
/// at zeros of guards and at options.outputTimes, and are cut where a node could pass through an obstacle. A look
/// (at(), state()) changes no number that comes after; but that DOP853 keeps a force that it has evaluated for a look,
/// so that with friction, whose anchors move between the steps, the last digits differ.
///
/// It holds on to the system and the method, which have to outlive it; the method serves nobody else meanwhile.
class Simulation {
 public:
  /// \param start  its z may be empty: it is set by the system
  /// Throws std::invalid_argument on sizes, masses or options that make no sense, and when the system lacks what the
  /// method needs. A start that is not finite is no error but a stop().
  Simulation(const DynamicalSystem& system, Integrator& method, State start, StepOptions options);
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  /// Takes the next accepted step: as often and as short as it needs, to the first event in it at most. What happens at
  /// its end (modes, anchors) is in state() when the call returns.
  ///
  /// The state never holds numbers that are not finite: then, as in every failure, it stays the last good one.
  Advance advance();
  /// Advances until t [s] lies in the last step, which is not cut for it: at(t) is the state there, and the steps are
  /// those that would have been taken without the look. False when that is not reached.
  bool advanceTo(double t);

  double time() const { return state_.t; }       ///< [s], of state()
  const State& state() const { return state_; }  ///< after the last accepted step, with its internal variables
  double stepBegin() const;                      ///< [s], of the last step; time() when there is none to look into
  /// The state at t [s] inside the last step, stepBegin() <= t <= time(), by the method's dense output; valid until the
  /// next call of anything else. Throws std::out_of_range for another time. What it costs is counted in work().
  const State& at(double t);

  /// Puts the nodes elsewhere, as a player does who pulls one; then as restart(). It also takes back a stop that a
  /// failure has brought.
  /// \param state  at time(), with the sizes of the system; its z may be empty: anchors of friction are then forgotten
  /// Throws std::invalid_argument on another time, sizes that differ or numbers that are not finite.
  void setState(State state);
  /// To be called when the system has changed between two steps (a stiffness, a force, a declared time): the method
  /// forgets its earlier steps, which were those of another problem, modes are decided anew, and step and error control
  /// start as at the beginning. Anchors of friction, time and grid stay.
  void restart();
  /// Lends the method to `use`, for steps of other systems between two steps of this one. It is prepared again
  /// afterwards, and so has forgotten its earlier steps; what it did meanwhile is not in work().
  void lendMethod(const std::function<void(Integrator& method)>& use);

  bool finished() const { return planner_.finished(); }            ///< the duration has passed
  const StopReport& stop() const { return report_; }               ///< why it goes no further before the end
  Work work() const;                                               ///< so far, the cost of looks included
  const std::vector<RunEvent>& events() const { return events_; }  ///< at most 10000 are kept; work().events counts all
  const std::vector<std::string>& warnings() const { return warnings_; }  ///< one line each, with times
  void warn(std::string line) { warnings_.push_back(std::move(line)); }   ///< adds one of the caller's
  long long subdividedSteps() const { return subdividedSteps_; }  ///< steps cut so that nothing passes an obstacle
  double smallestStep() const { return smallestStep_; }           ///< [s] taken; infinite before the first
  bool isAdaptive() const { return adaptive_; }                   ///< steps follow the error estimate

 private:
  void begin();
  void startErrorControl();
  void chooseFirstStep();
  void tellMethod();
  void setMethodAside();
  void prepareAgain();
  bool limitsHold();
  bool take(PlannedStep& step);
  bool looksAtEnergy() const;
  bool retryFailed(const PlannedStep& step, const StepResult& result);
  bool retryInexact(const PlannedStep& step, const StepResult& result);
  void cutAtObstacles(PlannedStep& step);
  StepResult locateEvent(PlannedStep& step);
  Advance finishStep(const PlannedStep& step);
  void move(const PlannedStep& step);
  bool crossGuards();
  bool commit(bool jump);
  bool goesOn(StopReport report);
  void warnOnce(bool& given, std::string text);
  void addEvent(std::string what);

  const DynamicalSystem& system_;
  Integrator& method_;
  StepOptions options_;
  bool adaptive_;
  State state_, other_;  // other_: the begin of the last step, or the end of one that is tried
  State inside_;         // what at() returns
  Stepper stepper_;
  StepPlanner planner_;
  ModeKeeper modes_;
  RunMonitor monitor_;
  std::optional<MotionScale> scale_;  // of an adaptive run
  // What the method is told only before the next step, as its dense output is that of the last one until then.
  bool toAccept_ = false, toRestart_ = false, toStart_ = false;
  bool hasStep_ = false;       // other_ is the begin of the last step
  bool toChooseStep_ = false;  // the method has made no step yet, all were in closed form
  bool tried_ = false;         // a step has been tried
  int retries_ = 0;            // of the present step
  StopReport report_;
  Work work_;  // that the method does not count
  std::vector<RunEvent> events_;
  std::vector<std::string> warnings_;
  long long subdividedSteps_ = 0;
  double smallestStep_ = std::numeric_limits<double>::infinity();
  bool warnedOfChatter_ = false, warnedOfCuts_ = false, warnedOfFailures_ = false;
};

}  // namespace muelle::engine
