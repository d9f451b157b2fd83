#pragma once
#include "engine/integrators/implicit/implicit_method.h"

#include <vector>

namespace muelle::engine {

/// A diagonally implicit Runge-Kutta method for y' = f(t, y), y = (x, v), whose first stage is explicit, whose other
/// stages have one diagonal entry (so one matrix), and whose last stage is the step.
struct EsdirkTableau {
  double diagonal = 0.0;
  std::vector<std::vector<double>> a;  ///< row i: weights of stages 0 .. i-1; row 0 is empty, the last row is the step
  std::vector<double> error;           ///< weights of the step minus those of the embedded one; one a stage, sum 0
  int errorPower = 0;                  ///< the estimate falls with this power of h; see stepTolerance()
};

/// Steps of an ESDIRK method on M v' = F(t, x, v). Each stage is eliminated to one equation in n unknowns,
///
///     M w = c F(t + c_i h, X0 + c w, V0 + w),  c = diagonal h,  matrix M + c D + c^2 K.
///
/// The slope at the end of a step is the next one's first. It is taken from the solved equation, a = w / c, not from a
/// force at rounded positions, which a stiff spring would blow up; and the error estimate goes through the matrix, for
/// else it grows with the stiffness without bound where the error does not (Hosea, Shampine: Analysis and
/// Implementation of TR-BDF2, 1996, sections 3 and 4).
class Esdirk : public ImplicitMethod {
 public:
  Esdirk(MethodInfo info, EsdirkTableau tableau);

  void prepare(const DynamicalSystem& system, const Tolerance& tolerance) override;
  void accept() override;
  void restart() override { known_ = false; }

 private:
  StepResult advance(const DynamicalSystem& system, const State& from, double h) override;
  void provideFirstSlope(const DynamicalSystem& system, const State& from, double h);
  StepResult solve(const DynamicalSystem& system, const State& from, std::size_t i, double h);
  double error(const DynamicalSystem& system, const State& from, double h);
  double overTolerance(const State& from) const;
  void filterError(const DynamicalSystem& system, double c);
  void addDamped(const DynamicalSystem& system, double c);

  EsdirkTableau tableau_;
  std::vector<double> c_;  ///< times of the stages, in steps
  double allowed_ = 1e-6;  ///< of the estimate, in parts of the motion
  bool known_ = false;
  State end_, pendingEnd_;
  std::vector<Vector> dvs_;  ///< change of velocity up to each stage [m/s]
  std::vector<Vector> as_;   ///< acceleration at each stage [m/s^2]
  Vector errorX_, errorV_, right_, scratch_, probe_;
};

}  // namespace muelle::engine
