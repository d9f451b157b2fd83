#pragma once
#include "harness/state.h"

namespace muelle::engine {

/// The state inside a step, theta in [0, 1]: the cubic through both ends' positions and velocities, and its slope. For
/// methods to which the forces at the ends say nothing of the motion between them; errors are of order h^4 in positions
/// and h^3 in velocities.
void interpolateByVelocities(const State& from, const State& to, double theta, State& out);

}  // namespace muelle::engine
