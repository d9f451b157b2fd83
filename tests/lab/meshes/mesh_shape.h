#pragma once
/// \file
/// What the triangles of a mesh look like.

#include "engine/scene/surface_mesh.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <numbers>
#include <utility>

namespace muelle::lab {

/// Vertices - edges + faces: 2 for what can be blown up to a ball.
inline int eulerCharacteristic(const engine::SurfaceMesh& mesh) {
  return static_cast<int>(std::ssize(mesh.vertices) - std::ssize(engine::edgesOf(mesh.triangles)) +
                          std::ssize(mesh.triangles));
}

/// The least and the greatest angle of all triangles [degrees].
inline std::pair<double, double> angleRange(const engine::SurfaceMesh& mesh) {
  double least = 180.0;
  double most = 0.0;
  for (const engine::Triangle& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3& a = mesh.vertices[static_cast<std::size_t>(t[i])];
      const Vec3 ab = mesh.vertices[static_cast<std::size_t>(t[(i + 1) % 3])] - a;
      const Vec3 ac = mesh.vertices[static_cast<std::size_t>(t[(i + 2) % 3])] - a;
      const double angle = std::atan2(ab.cross(ac).norm(), ab.dot(ac)) * 180.0 / std::numbers::pi;
      least = std::min(least, angle);
      most = std::max(most, angle);
    }
  }
  return {least, most};
}

}  // namespace muelle::lab
