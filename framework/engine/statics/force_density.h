#pragma once
#include "engine/statics/tension_shape.h"

namespace muelle::engine {

/// Puts the nodes of a shape where springs of rest length 0 would hold the loads, each with a force density of its own
/// (Schek 1974, The force density method: one linear system), in a few passes such that each spring has the length that
/// its stiffness gives it under its tension. All tensions become unknowns, with the values of these densities.
///
/// False, with the shape anywhere, where the springs alone do not hold it: some node is not tied to a fixed one, there
/// is no load, or a spring has no rest length or no stiffness.
bool placeByForceDensity(TensionShape& shape);

}  // namespace muelle::engine
