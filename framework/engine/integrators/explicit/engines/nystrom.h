#pragma once
#include "engine/integrators/explicit/engines/nystrom_drag.h"
#include "engine/integrators/explicit/engines/stage_integrator.h"

#include <optional>

namespace muelle::engine {

/// What is known of every such pair: what it needs, keeps and computes.
MethodInfo nystromInfo();

/// Embedded Runge-Kutta-Nystroem pairs, for forces that do not depend on the velocity but by a drag of each unknown
/// alone, of which NystromDrag takes care. A state inside the step is found by a shorter step, at full order: an
/// interpolant of order 6, 8 or 12 would cost as many evaluations.
class Nystrom : public StageIntegrator {
 public:
  /// \param tableau what the plan was made of
  Nystrom(const StagePlan& plan, NystromTableau (*tableau)()) : StageIntegrator(plan), tableau_(tableau) {}

  void prepare(const DynamicalSystem& system, const Tolerance& tolerance) override;
  StepResult step(const DynamicalSystem& system, const State& from, double h, State& to) override;
  StepResult stepIncrement(const DynamicalSystem& system, const State& from, double h, State& increment) override;
  void interpolate(const DynamicalSystem& system, const State& from, const State& to, double theta,
                   State& out) override;
  void sketch(const DynamicalSystem& system, const State& from, const State& to, double theta, State& out) override {
    Integrator::interpolate(system, from, to, theta, out);
  }
  void restart() override;
  void accept() override;

 private:
  NystromTableau (*tableau_)();
  std::optional<NystromDrag> drag_;  ///< where the system has a drag
};

}  // namespace muelle::engine
