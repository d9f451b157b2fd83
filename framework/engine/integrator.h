#pragma once
#include "engine/dynamical_system.h"
#include "engine/method_info.h"
#include "engine/work.h"

#include <string>

namespace muelle::engine {

/// How exact a step should be.
struct Tolerance {
  /// Bounds the estimated error of a step in every unknown, in parts of the motion's size (ErrorScale); at most 1. A
  /// method without error estimate ignores it.
  double relative = 1e-6;
  double newton = 1e-12;  ///< residual of implicit equations, relative to the forces that balance in them
};

/// What the error of a step is measured by: the size of the motion, which does not depend on where the origin lies, how
/// fast all of it flies by, or the unit of length (see MotionScale).
struct ErrorScale {
  double position = 1.0;  ///< [m]
  double velocity = 1.0;  ///< [m/s]
};

/// What became of a step.
struct StepResult {
  /// True: all numbers of `to` are finite, nobody looks again. False: the step could not be taken, `to` is meaningless.
  bool done = true;
  double error = 0.0;   ///< estimated local error over the tolerance; at most 1 is good. 0 without an estimate
  std::string failure;  ///< one line when not done: what failed, and by how much
  bool retry = true;    ///< when not done: whether a shorter step is worth a try
};

/// A method that advances a system by one step and does nothing else: step control, events, output, commits and failure
/// reports belong to Simulation.
class Integrator {
 public:
  virtual ~Integrator() = default;

  virtual const MethodInfo& info() const = 0;
  /// Called once before the first step, and again for another system: checks that the system has what the method needs
  /// (std::invalid_argument names the method and the missing capability) and allocates, so that a step does not.
  virtual void prepare(const DynamicalSystem& system, const Tolerance& tolerance) = 0;
  /// One step of h [s], positive, from `from` to `to`: another object with the same sizes. z is copied, t advanced.
  virtual StepResult step(const DynamicalSystem& system, const State& from, double h, State& to) = 0;

  /// Whether stepIncrement() knows the change over a step better than the difference of two rounded states does.
  virtual bool hasIncrements() const { return false; }
  /// As step(), but `increment` receives the change of x and v over the step instead of the state after it, for
  /// compensated summation: an increment is rounded to its own size, a state to the size of the state. On entry its x
  /// and v hold the low parts of the state, which its doubles have lost (or are empty); a method may add them to the
  /// positions at which it evaluates forces, and does not add them to the increment. The default is the difference of
  /// the states.
  virtual StepResult stepIncrement(const DynamicalSystem& system, const State& from, double h, State& increment);

  /// Forgets what was kept from earlier steps (last force, earlier states): after a discontinuity.
  virtual void restart() {}
  /// Called when the last step() was accepted: methods with memory shift it here, so that a rejected step leaves none.
  virtual void accept() {}
  /// The state inside the last step, theta in [0, 1], for output and to find events (moved nodes are the caller's to
  /// place); asked for only between step() and
  /// the accept() or restart() that follows it. The default is the quintic (x) and cubic (v) Hermite interpolant, with
  /// two force evaluations a step; methods with a dense output of their own use it. None looks at to.z, which may have
  /// been committed already.
  virtual void interpolate(const DynamicalSystem& system, const State& from, const State& to, double theta, State& out);

  /// The same as roughly as will do to look where an event may be, for two force evaluations a step at most.
  virtual void sketch(const DynamicalSystem& system, const State& from, const State& to, double theta, State& out) {
    interpolate(system, from, to, theta, out);
  }

  /// What the tolerance is a part of, from the next step on. Without a call 1 m and 1 m/s.
  void measureErrorsBy(const ErrorScale& scale) { errorScale_ = scale; }

  const Work& work() const { return work_; }
  /// Starts counting afresh, and forgets the forces kept for interpolate(), so that counts do not depend on earlier
  /// runs.
  void resetWork() {
    work_ = {};
    ends_ = {};
  }

 protected:
  Work work_;              ///< added to by step()
  ErrorScale errorScale_;  ///< what the error estimate is measured by

 private:
  /// The accelerations at both ends of the step that the default interpolate() was last asked about.
  struct Ends {
    const DynamicalSystem* system = nullptr;
    State from, to;
    std::vector<double> accelerationFrom, accelerationTo;
  };
  void updateEnds(const DynamicalSystem& system, const State& from, const State& to);

  Ends ends_;
};

}  // namespace muelle::engine
