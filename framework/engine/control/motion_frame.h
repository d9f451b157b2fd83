#pragma once
#include "engine/integrator.h"

#include <vector>

namespace muelle::engine {

/// The frame in which a run's motion is measured: y(t) = x(t) - x(0) - V t of every node, with V the mean initial
/// velocity (by mass) where nothing ties the system to a place, else 0. So a motion has one size, wherever the origin
/// lies and however fast all of it flies by.
class MotionFrame {
 public:
  /// \param start  the state of the run's beginning
  MotionFrame(const DynamicalSystem& system, const State& start);

  /// The largest |y| [m] and |v - V| [m/s] of a node in this state.
  ErrorScale sizeAt(const DynamicalSystem& system, const State& state);
  /// V [m/s], a component for each dimension.
  const std::vector<double>& drift() const { return drift_; }
  /// The longest side of the box around all nodes at the start [m].
  double extent() const { return extent_; }

 private:
  std::size_t dimension_;
  double startTime_;
  std::vector<double> start_;
  std::vector<double> drift_;
  double extent_ = 0.0;
  std::vector<double> x_, v_;  // of every node, in the state looked at
};

/// What the errors of an adaptive method are measured by as its run goes on: the largest |y| so far, at least a
/// thousandth of the extent, and the largest |v - V| so far, at least the former over the duration. Where both are 0
/// (one node that starts from rest) they are what the first acceleration makes of the duration; where nothing acts, 1.
class MotionScale {
 public:
  /// \param duration of the run [s]
  MotionScale(const DynamicalSystem& system, const State& start, double duration);

  /// Takes note of an accepted state.
  void follow(const DynamicalSystem& system, const State& state);
  ErrorScale scale() const;

 private:
  MotionFrame frame_;
  double duration_;
  ErrorScale largest_{0.0, 0.0};
  double leastPosition_;
};

}  // namespace muelle::engine
