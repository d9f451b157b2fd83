#pragma once
#include "harness/state.h"

namespace muelle::engine {

/// The cubic at theta in [0, 1] from values and slopes at both ends, slopes in units of the step.
inline double cubic(double theta, double x0, double slope0, double x1, double slope1) {
  const double d = x1 - x0;
  return x0 + theta * (slope0 + theta * (3.0 * d - 2.0 * slope0 - slope1 + theta * (slope0 + slope1 - 2.0 * d)));
}

/// The state inside a step, theta in [0, 1]: the cubic through both ends' positions and velocities, and its slope. For
/// methods to which the forces at the ends say nothing of the motion between them; errors are of order h^4 in positions
/// and h^3 in velocities.
void interpolateByVelocities(const State& from, const State& to, double theta, State& out);

}  // namespace muelle::engine
