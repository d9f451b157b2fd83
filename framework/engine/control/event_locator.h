#pragma once
#include "engine/control/stepper.h"

#include <vector>

namespace muelle::engine {

/// Watches the guards of a system over each step, and finds the state at the first sign change.
///
/// A sign change is seen at the step's end or, when the guard's values and slopes at both ends allow a double crossing,
/// inside: at seven points, and where guards that turn back are farthest out. A sketch of the step, or its dense
/// output, tells about when; then steps of shorter length from the step's begin locate it, so that the state at the
/// event has the method's own accuracy. The state returned lies on the far side of the guard (or exactly on it), at
/// most a few roundings of the time beyond it.
///
/// The side of a guard is remembered, not read off a value that is only rounding: a guard does not trigger again when
/// it is exactly 0 or on the near side by a rounding just after its event.
class EventLocator {
 public:
  EventLocator(const DynamicalSystem& system, Stepper& stepper);

  /// Takes the sides at the begin of a run, or after commits that may have changed any mode. When a guard is exactly 0
  /// there, z is set for the state a moment later (a fraction of h), so that the mode fits where the motion goes.
  void start(State& state, double h);

  struct Found {
    bool event = false;
    double length = 0.0;  ///< of the step to the event [s]; 0: it is at `from` itself, and `to` is a copy of it
    StepResult step;      ///< not done: a step on the way to the event failed
  };
  /// Looks for the first event in the step from `from` to `to` that the stepper has just taken. When there is one, `to`
  /// becomes the state at the event, and the step to it is the stepper's last.
  Found locate(const State& from, State& to);
  /// The guards that have changed sign at the event.
  const std::vector<int>& crossed() const { return crossed_; }
  /// To be called after each commit: the system may have redefined its guards.
  void settle(const State& state);

 private:
  /// A state inside the step, exact or as a sketch.
  using Look = void (Stepper::*)(const State& from, const State& to, double theta, State& out);

  /// Where a guard is 0, in parts of the step, and how fast it goes beyond there, a step.
  struct Root {
    double theta = 0.0, slope = 0.0;
  };

  double guard(int i, const State& state);
  const std::vector<double>& guards(const State& state);
  bool isBeyond(int i, double value) const;
  bool anyBeyond(const std::vector<double>& values) const;
  bool mayCrossTwice(const State& from, const State& to);
  void takeScanTimes();
  void seeBeyond(const State& state, const std::vector<double>& values, double low, double high);
  void slopes(const State& state, const std::vector<double>& here, double dt, std::vector<double>& out);
  bool turnsBack(std::size_t i) const;
  bool scan(const State& from, const State& to, Look look);
  Root parabolaRoot(std::size_t i) const;
  Root guessOf(int i, const State& from, const State& to, Look look);
  Root denseRoot(int i, const State& from, const State& to, Look look);
  int wellBeyond(int but) const;
  Found refine(int i, const Root& guess, const State& from, State& to);

  const DynamicalSystem& system_;
  const Switching& switching_;
  Stepper& stepper_;
  std::vector<int> side_;  // +1, -1, or 0 while a guard has been exactly 0 since the start
  std::vector<double> values_, atFrom_, atTo_, slopeFrom_, slopeTo_;
  std::vector<int> crossed_;
  double scanLow_ = 0.0, scanHigh_ = 1.0;  // the part of the step in which scan() saw the first change
  double stepLength_ = 0.0;                // [s], of the step that mayCrossTwice() has seen
  std::vector<double> acceleration_;       // [m/s^2] by lanes, the mean of that step, or in closed form at one end
  std::vector<double> scanTimes_;          // looked at, in parts of the step
  std::vector<int> scanChanged_;
  State inside_;
  State beyond_;  // a state clearly beyond the event
};

}  // namespace muelle::engine
