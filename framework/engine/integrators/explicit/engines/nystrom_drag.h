#pragma once
#include "engine/integrators/explicit/engines/lane_arrays.h"
#include "engine/integrators/explicit/engines/stage_sum.h"
#include "engine/integrators/explicit/engines/state_mark.h"
#include "engine/integrators/explicit/engines/step_finish.h"
#include "engine/integrators/explicit/tableaus.h"

#include <vector>

namespace muelle::engine {

/// A Nystroem method on x'' = a(t, x) - c x', c = d_i / m_i of each lane alone. In each step the free flight is taken
/// out and the rest written so that no velocity is left (s = t - t_n; Liouville's transformation, exact for every c):
///
///     x = x_n + (1 - exp(-c s)) / c v_n + exp(-c s / 2) y,   y(0) = y'(0) = 0
///     y'' = exp(c s / 2) a(t, x) + c^2 / 4 y
///
/// on which the method keeps its order; where no force acts y is 0, and the step exact. With x' = exp(-c s) w alone the
/// lanes would have to share one c.
class NystromDrag {
 public:
  explicit NystromDrag(const NystromTableau& tableau);

  void prepare(const DynamicalSystem& system, const Tolerance& tolerance);
  void restart();
  void accept() { accepted_ = true; }
  StepResult step(const DynamicalSystem& system, const State& from, double h, const ErrorScale& scale, State& to,
                  Work& work);
  /// The changes of x and v in the last step.
  void increments(State& increment) const;
  /// The state after `h` of the last step, which is left as it is.
  void inside(const DynamicalSystem& system, const State& from, double h, const ErrorScale& scale, State& out,
              Work& work);

 private:
  /// What the drag does in a time s to a lane.
  struct Factors {
    double free;    ///< (1 - exp(-c s)) / c [s]
    double half;    ///< exp(-c s / 2)
    double growth;  ///< exp(c s / 2)
    double loss;    ///< exp(-c s) - 1
  };
  const Factors& factors(std::size_t stage, std::size_t lane) const {
    return factors_[stage * kinds() + (kinds() == 1 ? 0 : lane)];
  }
  std::size_t kinds() const { return uniform_ ? 1 : rate_.size(); }
  double rate(std::size_t lane) const { return rate_[lane]; }
  void updateFactors(double h);
  void provideFirst(const DynamicalSystem& system, const State& from, Work& work);
  /// All stages and the end; the estimated error over the tolerance.
  double advance(const DynamicalSystem& system, const State& from, double h, const ErrorScale& scale, State& to,
                 Work& work);

  std::vector<double> c_;
  std::vector<StageSum> sums_;
  StageSum end_, error_;
  bool firstSameAsLast_;
  Tolerance tolerance_;
  std::vector<double> rate_;  ///< c [1/s]
  bool uniform_ = false;      ///< one c for all unknowns
  double h_ = 0.0;            ///< of the factors
  std::vector<Factors> factors_;
  LaneArrays g_;  ///< right-hand sides of y'' of each stage
  std::vector<double> x_, y_, v_, ye_, ve_, zeros_, dx_, dv_;
  std::vector<double> last_, kept_;  ///< acceleration at the end of the step
  StateMark startMark_, endMark_;
  bool accepted_ = false, endKnown_ = false;
};

}  // namespace muelle::engine
