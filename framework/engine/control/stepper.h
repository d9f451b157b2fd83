#pragma once
#include "engine/integrator.h"
#include "engine/lane_motion.h"

#include <vector>

namespace muelle::engine {

/// Takes steps of a method, with compensated summation of the state when asked for. Where every lane goes its own way
/// (DynamicalSystem::laneMotion), as in free flight, it may be taken in closed form instead: exact, for no force.
///
/// Compensated: the state is the sum of two numbers, its double and a low part that the doubles have lost. A step gives
/// the increment dx (Integrator::stepIncrement); x + (low + dx) is rounded to the new double, and what the rounding
/// loses is the new low part (Kahan; the exact error by Knuth's two-sum). What remains is the rounding of the
/// increments, smaller than that of the state by |dx| / |x|, and of the force at the rounded state. Hairer, Lubich and
/// Wanner, VIII.5.
class Stepper {
 public:
  /// \param mayUseClosedForm whether it does where it can
  Stepper(const DynamicalSystem& system, Integrator& method, bool compensated, bool mayUseClosedForm, std::size_t size);

  /// The motion of a step from there in closed form; none where the method takes it.
  LaneMotion closedForm(const State& from) const {
    return mayUseClosedForm_ ? system_.laneMotion(from.z) : LaneMotion{};
  }
  /// Whether the last step was in closed form.
  bool wasInClosedForm() const { return inClosedForm_; }

  /// A step from `from` of length h that ends at time t. May be called again from the same state.
  StepResult step(const State& from, double h, double t, State& to);
  /// The state inside the last step: Integrator::interpolate() and sketch(), or the closed form; with moved
  /// nodes in their places.
  void interpolate(const State& from, const State& to, double theta, State& out);
  void sketch(const State& from, const State& to, double theta, State& out);
  /// The last step was accepted: its low parts become those of the state. The method's accept() is called if it was
  /// its.
  void accept();
  /// The state was put elsewhere: it has no low parts.
  void forget();

 private:
  struct Low {
    std::vector<double> x, v;
  };

  StepResult advance(const State& from, double h, State& to);

  const DynamicalSystem& system_;
  Integrator& method_;
  bool compensated_;
  bool mayUseClosedForm_;
  bool inClosedForm_ = false;  ///< the last step was
  Low low_, nextLow_;
};

}  // namespace muelle::engine
