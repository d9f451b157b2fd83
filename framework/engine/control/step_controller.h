#pragma once
#include "engine/integrator.h"

namespace muelle::engine {

/// Chooses the steps of a method with an error estimate: the PI controller of Gustafsson in the form of Hairer, Norsett
/// and Wanner I, section II.4 (safety 0.9, beta = 0.3/order, growth between 0.2 and 10, none after a rejected step),
/// with a dead band: where the best step lies within 0.8 .. 1 of the present one, that stays. Steps that vary for
/// nothing cost a method of high order more error than they save. A smaller beta, as is usual for smooth problems, lets
/// steps that stability binds go up and down: with 0.2 a third of dop853's on a stiff swing were rejected, and its
/// error went up where the tolerance went down.
class StepController {
 public:
  /// \param order of the method: the local error is taken to be proportional to h^order
  /// \param h first step [s]
  StepController(int order, double h, double largestStep);

  double h() const { return h_; }
  /// A step of `length` was good (error <= 1). A step cut short for another reason does not shorten the next.
  void accept(double length, double error);
  /// A step of `length` had an error above 1, or one that is not finite.
  void reject(double length, double error);
  /// A step of `length` could not be taken at all.
  void fail(double length);

 private:
  static constexpr double deadBand = 0.8, deadBandLog2 = -0.32192809488736235;

  static double roughLog2(double value);
  double factor(double error) const;

  double beta_;
  double exponent_;
  double h_;
  double largest_;
  double lastError_ = 1e-4;
  bool afterRejection_ = false;
};

/// A first step [s] after Hairer, Norsett and Wanner I, section II.4: such that an explicit Euler step changes the
/// state by a hundredth of the motion's scale, and the method's first error is about a hundredth of the tolerance. Two
/// force evaluations, which are added to `work`.
double firstStep(const DynamicalSystem& system, const State& start, int order, double tolerance,
                 const ErrorScale& scale, double duration, Work& work);

}  // namespace muelle::engine
