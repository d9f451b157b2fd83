#pragma once
#include "harness/dynamical_system.h"

namespace muelle {

/// One step of symplectic Euler, the method given to students (no exercise asks for it):
///
///     v1 = v0 + h M^-1 F(t0, x0, v0),   x1 = x0 + h v1,
///
/// order 1, stable on an undamped oscillator while h omega < 2. Its energy error does not grow: it conserves a
/// neighbouring energy, E + O(h). Source: Hairer, Lubich, Wanner, Geometric Numerical Integration, I.1.2.
///
/// `to` has the sizes of `from` and is another object; h in s. to.v holds the forces for a moment: no memory is needed.
void symplecticEulerStep(const DynamicalSystem& system, const State& from, double h, State& to);

}  // namespace muelle
