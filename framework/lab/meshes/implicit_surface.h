#pragma once
#include "engine/scene/surface_mesh.h"

#include <functional>

namespace muelle::lab {

/// A body: the points where `value` is negative. Near its surface `value` is smooth and about the distance [m].
struct ImplicitBody {
  std::function<double(const Vec3&)> value;
  Vec3 least = Vec3::Zero();  ///< corners of a box that holds the body with room to spare [m]
  Vec3 most = Vec3::Ones();
};

/// The surface of a body as triangles with edges of about `size` [m], anticlockwise seen from outside. It is cut out of
/// the tetrahedra of a grid, and is closed for that; then long edges are parted, short ones are merged, edges are
/// turned where that evens the number of edges at a vertex, and vertices move to the middle of their neighbours within
/// the surface (Botsch, Kobbelt 2004), so that no slivers remain. What is thinner than `size` may be lost.
engine::SurfaceMesh triangulate(const ImplicitBody& body, double size);

}  // namespace muelle::lab
