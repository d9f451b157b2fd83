#include "engine/scene/surface_mesh.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <map>
#include <numbers>
#include <utility>

namespace muelle::engine {

namespace {

const Vec3& vertex(const SurfaceMesh& mesh, int i) { return mesh.vertices[static_cast<std::size_t>(i)]; }

/// Each directed edge (a, b) with the third vertex of its triangle; the first triangle wins where two claim an edge.
std::map<std::pair<int, int>, int> directedEdges(const std::vector<Triangle>& triangles, bool& twice) {
  std::map<std::pair<int, int>, int> edges;
  for (const Triangle& t : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      twice |= !edges.emplace(std::pair(t[i], t[(i + 1) % 3]), t[(i + 2) % 3]).second;
    }
  }
  return edges;
}

}  // namespace

std::vector<std::array<int, 2>> edgesOf(const std::vector<Triangle>& triangles) {
  std::vector<std::array<int, 2>> edges;
  edges.reserve(3 * triangles.size());
  for (const Triangle& t : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      edges.push_back({std::min(t[i], t[(i + 1) % 3]), std::max(t[i], t[(i + 1) % 3])});
    }
  }
  std::ranges::sort(edges);
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

std::vector<std::array<int, 4>> hingesOf(const std::vector<Triangle>& triangles) {
  bool twice = false;
  const auto edges = directedEdges(triangles, twice);
  std::vector<std::array<int, 4>> hinges;
  for (const auto& [edge, c] : edges) {
    const auto [a, b] = edge;
    const auto opposite = a < b ? edges.find({b, a}) : edges.end();
    if (opposite != edges.end()) hinges.push_back({a, b, c, opposite->second});
  }
  return hinges;
}

bool isClosed(const SurfaceMesh& mesh) {
  bool twice = false;
  const auto edges = directedEdges(mesh.triangles, twice);
  if (twice || edges.empty()) return false;
  return std::ranges::all_of(edges, [&](const auto& e) { return edges.contains({e.first.second, e.first.first}); });
}

double signedVolume(const SurfaceMesh& mesh) {
  double sum = 0.0;
  for (const Triangle& t : mesh.triangles) {
    sum += vertex(mesh, t[0]).dot(vertex(mesh, t[1]).cross(vertex(mesh, t[2])));
  }
  return sum / 6.0;
}

double windingNumber(const SurfaceMesh& mesh, const Vec3& point) {
  double angle = 0.0;
  for (const Triangle& t : mesh.triangles) {
    const Vec3 a = vertex(mesh, t[0]) - point;
    const Vec3 b = vertex(mesh, t[1]) - point;
    const Vec3 c = vertex(mesh, t[2]) - point;
    const double la = a.norm();
    const double lb = b.norm();
    const double lc = c.norm();
    const double numerator = a.dot(b.cross(c));
    const double denominator = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
    angle += 2.0 * std::atan2(numerator, denominator);
  }
  return angle / (4.0 * std::numbers::pi);
}

}  // namespace muelle::engine
