#pragma once
#include "engine/method.h"

#include <memory>

namespace muelle::engine::testing {

/// Classical Runge-Kutta of order 4, fixed step.
std::unique_ptr<Method> classicalRungeKutta();
/// Bogacki-Shampine 3(2) with its error estimate: order 3, adaptive.
std::unique_ptr<Method> bogackiShampine();
/// Velocity Verlet with its increments, for compensated sums.
std::unique_ptr<Method> verletWithIncrements();

}  // namespace muelle::engine::testing
