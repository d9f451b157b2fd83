#pragma once
#include "engine/integrator.h"
#include "engine/integrators/explicit/engines/drag_factors.h"
#include "engine/integrators/explicit/engines/kick.h"
#include "engine/integrators/explicit/tableaus.h"

#include <vector>

namespace muelle::engine {

/// A symmetric composition of kick-drift-kick steps of fractions of h, some of them negative.
///
/// A linear drag belongs to the drift, whose flow x' = v, v' = -d v / m is exact, so that each step stays symmetric and
/// the composition keeps its order; in the negative steps velocities grow by exp(|h| d / m), which bounds the drag that
/// it can bear. Other velocity-dependent forces are evaluated at a predicted velocity, twice a substep; the substep is
/// then of second order but not symmetric, and the whole of third.
class Composition : public Integrator {
 public:
  Composition(MethodInfo info, const Coefficients& fractions);

  const MethodInfo& info() const override { return info_; }
  void prepare(const DynamicalSystem& system, const Tolerance& tolerance) override;
  StepResult step(const DynamicalSystem& system, const State& from, double h, State& to) override;
  bool hasIncrements() const override { return true; }
  StepResult stepIncrement(const DynamicalSystem& system, const State& from, double h, State& increment) override;
  /// Above order 4 by a shorter step: the Hermite interpolant would be the largest error.
  void interpolate(const DynamicalSystem& system, const State& from, const State& to, double theta,
                   State& out) override;
  void sketch(const DynamicalSystem& system, const State& from, const State& to, double theta, State& out) override {
    Integrator::interpolate(system, from, to, theta, out);
  }
  void restart() override { kick_.restart(); }
  void accept() override { kick_.accept(); }

 private:
  /// dv += kick a, then the drift of h; leaves the velocity predicted for the end of the substep.
  void kickAndDrift(const DynamicalSystem& system, const State& from, double kick, double h, DragFactors& factors,
                    State& to);
  void kick(const State& from, double h, State& to);

  MethodInfo info_;
  std::vector<double> fractions_;
  Kick kick_, aside_;
  std::vector<DragFactors> factors_;  // of each substep: the fractions differ, so their factors do
  std::vector<double> predicted_;
  std::vector<double> dx_, dv_;  // change since the start: each substep's is rounded to its own size
};

}  // namespace muelle::engine
