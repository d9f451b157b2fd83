#pragma once
#include "engine/integrators/explicit/engines/combination.h"
#include "engine/integrators/explicit/engines/state_mark.h"
#include "engine/integrators/explicit/tableaus.h"

#include <vector>

namespace muelle::engine {

/// What is known of every such pair: what it needs, keeps and computes.
MethodInfo nystromInfo();

/// Embedded Runge-Kutta-Nystroem pairs, for forces that do not depend on the velocity. A state inside the step is found
/// by a shorter step, at full order: an interpolant of order 8 or 12 would cost as many evaluations.
class Nystrom : public Integrator {
 public:
  Nystrom(MethodInfo info, const NystromTableau& tableau);

  const MethodInfo& info() const override { return info_; }
  void prepare(const DynamicalSystem& system, const Tolerance& tolerance) override;
  StepResult step(const DynamicalSystem& system, const State& from, double h, State& to) override;
  bool hasIncrements() const override { return true; }
  StepResult stepIncrement(const DynamicalSystem& system, const State& from, double h, State& increment) override;
  void interpolate(const DynamicalSystem& system, const State& from, const State& to, double theta,
                   State& out) override;
  void restart() override;
  void accept() override { accepted_ = true; }

 private:
  std::size_t stages() const { return c_.size(); }
  void provideFirst(const DynamicalSystem& system, const State& from);
  void evaluate(const DynamicalSystem& system, double t, In x, In v, In z, std::size_t j);
  /// All stages after the first, and the result.
  void advance(const DynamicalSystem& system, const State& from, double h, State& to);
  double error(const State& from, const State& to, double h) const;

  MethodInfo info_;
  std::vector<double> c_, b_, bv_, errorWeights_, errorWeightsV_;
  std::vector<std::vector<double>> a_;
  bool firstSameAsLast_;
  Tolerance tolerance_;
  std::size_t size_ = 0;
  std::vector<double> memory_;          // accelerations of the stages, and one to spare
  std::vector<double*> accelerations_;  // where each begins
  std::vector<double> stage_, stageVelocity_;
  StateMark start_, end_;
  bool accepted_ = false;
};

}  // namespace muelle::engine
