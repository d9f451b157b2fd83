#pragma once
#include "engine/integrators/explicit/engines/combination.h"
#include "engine/integrators/explicit/engines/state_mark.h"
#include "engine/integrators/explicit/tableaus.h"

#include <vector>

namespace muelle::engine {

/// Explicit Runge-Kutta methods. Each stage is one fused sum over the slopes before it; the velocity of a stage is
/// written where it serves as the position's slope, so nothing is copied.
class ExplicitRungeKutta : public Integrator {
 public:
  ExplicitRungeKutta(MethodInfo info, const ButcherTableau& tableau);

  const MethodInfo& info() const override { return info_; }
  void prepare(const DynamicalSystem& system, const Tolerance& tolerance) override;
  StepResult step(const DynamicalSystem& system, const State& from, double h, State& to) override;
  bool hasIncrements() const override { return true; }
  StepResult stepIncrement(const DynamicalSystem& system, const State& from, double h, State& increment) override;
  void restart() override;
  void accept() override;

 protected:
  /// Estimated error over the tolerance of the step whose slopes are held.
  virtual double error(const State& from, const State& to, double h) const;
  /// Largest of all unknowns' h sum_j weights_j k_j over what the tolerance allows.
  double largestError(std::span<const double> weights, const State& from, const State& to, double h) const;
  /// x, v of out = those of from + h sum_j weights_j k_j.
  void combine(std::span<const double> weights, const State& from, double h, Out x, Out v) const;
  /// Slope number j at time t: velocities must have been written to velocity(j).
  void evaluate(const DynamicalSystem& system, double t, In x, In z, std::size_t j);
  /// Extra room for slopes after the stages, for a dense output; before prepare().
  void reserveSlopes(std::size_t extra) { extraSlopes_ = extra; }
  /// Evaluates the slope at the end of the step, as slope number stages(), unless it is held already.
  void ensureEndSlope(const DynamicalSystem& system, const State& from, const State& to);

  std::size_t stages() const { return b_.size(); }
  std::span<const double> weights() const { return b_; }
  Out velocity(std::size_t j) { return {slopes_[j], size_}; }
  In velocity(std::size_t j) const { return {slopes_[j], size_}; }
  Out acceleration(std::size_t j) { return {slopes_[j] + size_, size_}; }
  Out stagePosition() { return stage_; }

 private:
  std::size_t endSlope() const { return firstSameAsLast_ ? stages() - 1 : stages(); }
  void provideFirstSlope(const DynamicalSystem& system, const State& from);

  MethodInfo info_;
  std::vector<double> c_, b_, errorWeights_;
  std::vector<std::vector<double>> a_;
  bool firstSameAsLast_ = false;
  Tolerance tolerance_;
  std::size_t extraSlopes_ = 1;
  std::size_t size_ = 0;
  std::vector<double> memory_;   // all slopes, each 2n: velocities, accelerations
  std::vector<double*> slopes_;  // where slope j begins
  std::vector<double> stage_;    // positions of the present stage
  StateMark start_, end_;        // where slope 0 and the end slope belong
  bool accepted_ = false;
  bool endKnown_ = false;
};

}  // namespace muelle::engine
