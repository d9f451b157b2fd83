#pragma once
/// \file
/// Systems whose motion is known in closed form.

#include "harness/function_system.h"
#include "harness/march.h"
#include "harness/symplectic_euler.h"

namespace muelle {

/// x'' = -w^2 x with w the angular frequency [rad/s].
inline FunctionSystem oscillator(double w) {
  return {{1.0}, [w](double, In x, In, Out f) { f[0] = -w * w * x[0]; }};
}

/// A single node under a constant force [N].
inline FunctionSystem projectile(double m, const Vec3& force) {
  return {{m, m, m}, [force](double, In, In, Out f) { node3(f, 0) = force; }};
}

/// Runs symplectic Euler.
inline Trajectory run(const DynamicalSystem& system, State start, const MarchOptions& options) {
  return march(system, std::move(start), options);
}

}  // namespace muelle
