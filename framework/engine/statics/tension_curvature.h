#pragma once
#include "engine/statics/curvature.h"
#include "engine/statics/tension_matrix.h"

namespace muelle::engine {

/// The smallest eigenvalue of the stiffness matrix where the shape is now, by inverse iteration with `matrix`, which is
/// linearised anew; where something is negative, or nothing holds it, with the least shift that makes all positive.
Curvature curvatureOf(TensionShape& shape, TensionMatrix& matrix);

}  // namespace muelle::engine
