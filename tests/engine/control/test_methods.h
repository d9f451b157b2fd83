#pragma once
#include "engine/integrator.h"

#include <memory>

namespace muelle::engine::testing {

/// Classical Runge-Kutta of order 4, fixed step.
std::unique_ptr<Integrator> classicalRungeKutta();
/// Bogacki-Shampine 3(2) with its error estimate: order 3, adaptive.
std::unique_ptr<Integrator> bogackiShampine();
/// Velocity Verlet with its increments, for compensated sums.
std::unique_ptr<Integrator> verletWithIncrements();

}  // namespace muelle::engine::testing
