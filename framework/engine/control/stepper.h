#pragma once
#include "engine/integrator.h"

#include <vector>

namespace muelle::engine {

/// Takes steps of a method, with compensated summation of the state when asked for.
///
/// Compensated: the state is the sum of two numbers, its double and a low part that the doubles have lost. A step gives
/// the increment dx (Integrator::stepIncrement); x + (low + dx) is rounded to the new double, and what the rounding
/// loses is the new low part (Kahan; the exact error by Knuth's two-sum). What remains is the rounding of the
/// increments, smaller than that of the state by |dx| / |x|, and of the force at the rounded state. Hairer, Lubich and
/// Wanner, VIII.5.
class Stepper {
 public:
  Stepper(const DynamicalSystem& system, Integrator& method, bool compensated, std::size_t size);

  /// A step from `from` of length h that ends at time t. May be called again from the same state.
  StepResult step(const State& from, double h, double t, State& to);
  /// The last step was accepted: its low parts become those of the state. The method's accept() is called.
  void accept();
  /// The state was put elsewhere: it has no low parts.
  void forget();

 private:
  struct Low {
    std::vector<double> x, v;
  };

  const DynamicalSystem& system_;
  Integrator& method_;
  bool compensated_;
  Low low_, nextLow_;
};

}  // namespace muelle::engine
