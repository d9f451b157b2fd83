#pragma once
#include "engine/scene/surface_mesh.h"

#include <vector>

namespace muelle::engine {

/// Cuts a polygon into triangles of its own sense of rotation: a convex one into those that share its first corner, any
/// other one by ears (Meisters 1975), so that a polygon with a dent, or one whose outline goes to a hole and back over
/// a bridge, covers no more than its inside. A corner that follows itself, and a last one that repeats the first, are
/// dropped. Empty where fewer than three different corners are left, or nothing but a way there and back.
///
/// \param corners indices of `vertices`
std::vector<Triangle> cutPolygon(std::vector<int> corners, const std::vector<Vec3>& vertices);

}  // namespace muelle::engine
