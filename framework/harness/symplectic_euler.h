#pragma once
#include "harness/integrator.h"

#include <vector>

namespace muelle {

/// Symplectic Euler, the method given to students (no exercise asks for it):
///
///     v1 = v0 + h M^-1 F(t0, x0, v0),   x1 = x0 + h v1,
///
/// order 1, stable on an undamped oscillator while h omega < 2. Its energy error does not grow: it conserves a
/// neighbouring energy, E + O(h). Source: Hairer, Lubich, Wanner, Geometric Numerical Integration, I.1.2.
class SymplecticEuler : public Integrator {
 public:
  const char* name() const override { return "symplectic Euler"; }
  void prepare(const DynamicalSystem& system) override;
  void step(const DynamicalSystem& system, const State& from, double h, State& to) override;

 private:
  std::vector<double> force_;
};

}  // namespace muelle
