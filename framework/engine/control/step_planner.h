#pragma once
#include "engine/control/step_controller.h"
#include "engine/control/step_grid.h"
#include "engine/control/step_options.h"

#include <limits>
#include <optional>

namespace muelle::engine {

/// Plans where each step ends: after the tolerance's step or at the next point of the grid, no later than the next time
/// at which a step has to end, no further than obstacles allow, and in pieces after a step that failed.
class StepPlanner {
 public:
  /// \param adaptive      steps by the error estimate, else by the grid of options.h
  /// \param stopsAtJumps  steps end at the declared times of the system
  /// \param start         time of the first step [s]
  StepPlanner(const DynamicalSystem& system, const StepOptions& options, bool adaptive, bool stopsAtJumps,
              double start);

  /// Chooses the first step of a method of this order with an error estimate; two force evaluations at most, which are
  /// added to `work`.
  void chooseFirstStep(const State& from, int order, const ErrorScale& scale, Work& work);
  /// Takes the system's declared times anew, for it may have changed, and forgets failures.
  void restart(double t);

  /// The next step from time t, before obstacles are looked at.
  PlannedStep plan(double t) const;
  /// The same in closed form, to which no error sets a limit. \param longest [s]
  PlannedStep planClosedForm(double t, double longest) const;
  /// Cuts the step so that no node passes through an obstacle; whether that was needed.
  bool cutAtObstacles(const State& from, PlannedStep& step) const;
  /// Lets the step end at `length` from time t.
  static void shorten(PlannedStep& step, double t, double length);
  /// The step that a shorter one is tried for: by the error estimate, or in pieces.
  void shortenAfterFailure(PlannedStep& step, double t) const;

  void accept(double length, double error);  ///< such a step was good; later it may still be cut at an event
  void reject(double length, double error);  ///< it was not exact enough
  void fail(double length);                  ///< it could not be taken
  /// Whether steps failed again and again since the grid was last met: shorter ones do not help.
  bool failsTooOften() const { return failures_ > mostFailures; }
  void moved(const PlannedStep& step);  ///< time has passed by it

  /// The step [s] where nothing cuts it.
  double nominal() const { return adaptive_ ? controller_->h() : options_.h; }
  /// A step [s] below this one is lost in the rounding of time t.
  double shortest(double t) const;
  bool finished() const { return stops_.finished(); }
  /// The time that a step had to end at is reached.
  StopTimes::Stop reachStop();
  double end() const { return end_; }

 private:
  static constexpr int mostFailures = 60;

  StopTimes stopsFrom(double t) const;
  PlannedStep planByError(double t) const;

  const DynamicalSystem& system_;
  const StepOptions& options_;
  bool adaptive_;
  bool stopsAtJumps_;
  double end_;
  StopTimes stops_;
  TimeGrid grid_;
  std::optional<StepController> controller_;
  double piece_ = std::numeric_limits<double>::infinity();  // longest step after failures of a fixed step
  int failures_ = 0;  // since the grid was last met; of an adaptive method since the last step
};

/// The times in (from, to] at which the system's force jumps [s], ascending.
std::vector<double> declaredTimes(const DynamicalSystem& system, double from, double to);

}  // namespace muelle::engine
