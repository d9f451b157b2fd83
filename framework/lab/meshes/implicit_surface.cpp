#include "lab/meshes/implicit_surface.h"

#include "engine/scene/connectivity.h"
#include "lab/meshes/even_triangles.h"
#include "lab/meshes/marching_tetrahedra.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace muelle::lab {

namespace {

using engine::SurfaceMesh;

constexpr int rounds = 32;  // of turning edges and moving vertices

Vec3 gradient(const ImplicitBody& body, const Vec3& x, double step) {
  Vec3 g;
  for (int i = 0; i < 3; ++i) {
    const Vec3 d = step * Vec3::Unit(i);
    g[i] = (body.value(x + d) - body.value(x - d)) / (2.0 * step);
  }
  return g;
}

/// Moves a point to the surface: Newton's method along the gradient.
void project(const ImplicitBody& body, Vec3& x, double size) {
  for (int i = 0; i < 4; ++i) {
    const double value = body.value(x);
    if (std::abs(value) < 1e-12 * size) return;
    const Vec3 g = gradient(body, x, 1e-4 * size);
    x -= std::clamp(value / g.squaredNorm(), -size, size) * g;
  }
}

/// Moves every vertex half way to the middle of its neighbours, within the surface.
void relax(SurfaceMesh& mesh, const ImplicitBody& body, double size) {
  std::vector<Vec3> sum(mesh.vertices.size(), Vec3::Zero());
  std::vector<int> count(mesh.vertices.size(), 0);
  for (const auto& [a, b] : engine::edgesOf(mesh.triangles)) {
    const auto i = static_cast<std::size_t>(a);
    const auto j = static_cast<std::size_t>(b);
    sum[i] += mesh.vertices[j];
    sum[j] += mesh.vertices[i];
    ++count[i];
    ++count[j];
  }
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    Vec3& x = mesh.vertices[i];
    const Vec3 n = gradient(body, x, 1e-4 * size).normalized();
    const Vec3 move = 0.5 * (sum[i] / count[i] - x);
    x += move - move.dot(n) * n;
    project(body, x, size);
  }
}

}  // namespace

engine::SurfaceMesh triangulate(const ImplicitBody& body, double size) {
  SurfaceMesh mesh = cutSurface(body, size);
  for (Vec3& x : mesh.vertices) project(body, x, size);
  for (int i = 0; i < rounds; ++i) {
    const bool isEven = i >= rounds / 2;  // from then on the vertices stay as they are joined, but for wide angles
    if (!isEven) {
      splitLongEdges(mesh, 4.0 / 3.0 * size);
      mergeShortEdges(mesh, 4.0 / 5.0 * size, 4.0 / 3.0 * size);
      evenValences(mesh);
    } else {
      openAngles(mesh);
    }
    relax(mesh, body, size);
  }
  return mesh;
}

}  // namespace muelle::lab
