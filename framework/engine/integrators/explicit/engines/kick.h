#pragma once
#include "engine/dynamical_system.h"
#include "engine/integrators/explicit/engines/lane_arrays.h"
#include "engine/integrators/explicit/engines/state_mark.h"
#include "engine/work.h"

namespace muelle::engine {

/// The acceleration by all forces that a Verlet step treats by kicks: those without the drag when the system has one.
/// Knows whether it may be kept from the end of a step to the start of the next.
class Kick {
 public:
  void prepare(const DynamicalSystem& system);
  void restart();
  /// Acceleration [m/s^2] at a state; the one before stays in before().
  void evaluate(const DynamicalSystem& system, double t, In x, In v, In z, Work& work);
  /// Acceleration at the start of a step: the one kept from the accepted step before, when `from` is its end.
  void start(const DynamicalSystem& system, const State& from, Work& work);
  /// The present acceleration is the one that the step after `to` begins with.
  void finish(const State& to);
  void accept() { accepted_ = true; }

  bool usesVelocity() const { return usesVelocity_; }
  const double* acceleration() const { return accelerations_.data(0); }
  const double* before() const { return accelerations_.data(1); }

 private:
  const Drag* drag_ = nullptr;
  bool usesVelocity_ = true;
  bool accepted_ = false;
  StateMark end_;
  LaneArrays accelerations_;  // the present one and the one before
};

}  // namespace muelle::engine
