#pragma once
#include "engine/integrator.h"

#include <vector>

namespace muelle::engine {

/// What the position based methods share: the check that constraints cover the system's forces, and external forces.
class PositionMethod : public Integrator {
 public:
  explicit PositionMethod(MethodInfo info) : info_(std::move(info)) {}

  const MethodInfo& info() const override { return info_; }
  /// Throws std::invalid_argument when the system has no constraints, when they leave out a force (friction), or when
  /// one is no distance and the method takes distances only.
  void prepare(const DynamicalSystem& system, const Tolerance& tolerance) override;

 protected:
  /// Advances v by the external forces over h: node drag -d v as backward Euler does, all others as constant. Sets
  /// mass_ to m + h d, the mass that the other forces of the step then see; held nodes have 0 and an inverse of 0.
  void accelerate(const DynamicalSystem& system, double t, double h, State& state);
  /// Sets the time and checks that x and v are finite.
  StepResult finish(const State& from, double h, State& to) const;

  MethodInfo info_;
  std::vector<double> external_, mass_, inverseMass_;
};

/// A MethodInfo with what the position based methods have in common.
MethodInfo positionBasedInfo(std::string id, std::string name);

}  // namespace muelle::engine
