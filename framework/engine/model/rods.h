#pragma once
#include "engine/model/model.h"

namespace muelle::engine {

/// Checks the springs that are rods: no damping, not one-sided, not on a moved node; each starts at its length, and its
/// ends at no relative velocity along it (to 1e-9); and no rod is redundant, that is, its length follows from the other
/// rods and the pins to first order, so that its force would be undetermined. Throws std::invalid_argument that names
/// the springs.
void checkRods(const Model& model);

}  // namespace muelle::engine
