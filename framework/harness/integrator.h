#pragma once
#include "harness/dynamical_system.h"

namespace muelle {

/// A method that advances a system by one step; steps, output and failures are the business of simulate().
class Integrator {
 public:
  virtual ~Integrator() = default;

  /// "symplectic Euler"
  virtual const char* name() const = 0;
  /// Called once before the first step: allocate here, so that a step does not.
  virtual void prepare(const DynamicalSystem& system) = 0;
  /// One step of h [s] from `from` to `to`, which has the same sizes and is another object.
  virtual void step(const DynamicalSystem& system, const State& from, double h, State& to) = 0;
};

}  // namespace muelle
