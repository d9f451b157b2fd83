#pragma once
#include "engine/integrators/explicit/engines/lane_arrays.h"
#include "engine/integrators/explicit/engines/stage_sum.h"
#include "engine/integrators/explicit/engines/state_mark.h"
#include "engine/integrators/explicit/engines/step_finish.h"
#include "engine/integrators/explicit/tableaus.h"

#include <limits>
#include <utility>
#include <vector>

namespace muelle::engine {

/// A method for x'' = a(t, x, v) by stages of the accelerations alone:
///
///     X_i = x + c_i h v + h^2 sum_j ax_ij A_j,   V_i = v + h sum_j av_ij A_j,   A_i = a(t + c_i h, X_i, V_i)
///     x+  = x + h v + h^2 sum_j bx_j A_j,        v+  = v + h sum_j bv_j A_j
struct AccelerationTableau {
  Coefficients c;
  std::vector<Coefficients> ax;
  std::vector<Coefficients> av;  ///< empty: for accelerations that do not depend on the velocity
  Coefficients bx, bv;
  std::vector<Coefficients> ex, ev;  ///< weights of error estimates, of which there are up to two
  bool firstSameAsLast = false;      ///< the last stage is at the end of the step
};

/// A Nystroem method as it stands.
AccelerationTableau accelerationTableau(const NystromTableau& tableau);
/// A Runge-Kutta method, whose positions V_j are sums of accelerations themselves: ax = a a, bx = a^T b ("the squared
/// tableau"). One pass over the accelerations then gives both x and v of a stage.
/// \param more weights of a second estimate; may be empty
AccelerationTableau accelerationTableau(const ButcherTableau& tableau, const Coefficients& more = {});

/// sum_i w_i a_ij for each j: what is only rounding of terms that cancel is 0.
Coefficients squared(const Coefficients& w, const std::vector<Coefficients>& a);

/// A method of that kind: what is known of it and its sums. Made once for all runs: a short one takes less time than
/// this does.
struct StagePlan {
  StagePlan(MethodInfo facts, const AccelerationTableau& tableau);
  /// \param more weights of a second error estimate; may be empty
  StagePlan(MethodInfo facts, const ButcherTableau& tableau, const Coefficients& more = {})
      : StagePlan(std::move(facts), accelerationTableau(tableau, more)) {}

  MethodInfo info;
  std::vector<double> c;
  std::vector<StageSum> sums;  ///< of each stage, of which the first is empty, and of the end
  bool firstSameAsLast;
};

/// What explicit Runge-Kutta and Nystroem methods share: stages in one pass over the accelerations before them, reuse
/// of accelerations between steps, error estimates and finiteness in the pass that writes the end of the step.
class StageIntegrator : public Integrator {
 public:
  /// \param plan is read as long as the method lives
  explicit StageIntegrator(const StagePlan& plan) : plan_(plan), sums_(plan.sums) {}

  const MethodInfo& info() const override { return plan_.info; }
  void prepare(const DynamicalSystem& system, const Tolerance& tolerance) override;
  StepResult step(const DynamicalSystem& system, const State& from, double h, State& to) override;
  bool hasIncrements() const override { return true; }
  StepResult stepIncrement(const DynamicalSystem& system, const State& from, double h, State& increment) override;
  void restart() override;
  void accept() override { accepted_ = true; }

 protected:
  /// The estimated error of a step over the tolerance from those of the embedded methods.
  virtual double combined(const StageEnd& end) const { return end.largest[0]; }

  std::size_t stages() const { return plan_.c.size(); }
  std::size_t lanes() const { return size_; }
  const Tolerance& tolerance() const { return tolerance_; }
  /// Room for this many accelerations after the stages; before prepare().
  void reserve(std::size_t extra) { extra_ = extra; }
  Out acceleration(std::size_t j) { return accelerations_[j]; }
  void swapAccelerations(std::size_t i, std::size_t j) {
    accelerations_.swap(i, j);
    moved_ = true;
  }

  /// Acceleration number 0, evaluated unless it is known.
  void provideFirst(const DynamicalSystem& system, const State& from);
  /// The same inside the step that begins there, whose end stays known.
  void recallFirst(const DynamicalSystem& system, const State& from);
  /// Acceleration number j at positions and velocities that are placed first.
  void evaluate(const DynamicalSystem& system, double t, Out x, Out v, In z, std::size_t j);
  /// All stages after the first, and the end of a step.
  StageEnd advance(const DynamicalSystem& system, const State& from, double h, State& to);
  /// x, v = those of `from` and h (c v + h sum wx_j A_j), h sum wv_j A_j.
  void sum(StageSum& weights, double c, const State& from, double h, Out x, Out v);
  /// Acceleration at the end of the step, as number stages() or, where the last stage is that, stages() - 1.
  void ensureEnd(const DynamicalSystem& system, const State& from, const State& to);

 private:
  void bind(double h);
  /// The changes of x and v in the step whose accelerations are held.
  void increments(const State& from, double h, State& increment);

  const StagePlan& plan_;
  std::vector<StageSum> sums_;
  bool velocities_ = true;  ///< the force of the system uses them
  bool places_ = true;      ///< the system has nodes that are moved
  Tolerance tolerance_;
  std::size_t extra_ = 1;
  std::size_t size_ = 0;
  const StageKernels* kernels_ = nullptr;
  LaneArrays accelerations_;
  LaneArrays stage_;                                     ///< x and v of the present one
  double h_ = std::numeric_limits<double>::quiet_NaN();  ///< that is in the sums
  bool moved_ = true;                                    ///< accelerations have changed their places since bind()
  std::vector<double> zeros_;
  StateMark startMark_, endMark_;
  bool accepted_ = false, endKnown_ = false;
};

}  // namespace muelle::engine
