#include "lab/meshes/even_triangles.h"

#include "engine/scene/connectivity.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <Eigen/Geometry>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace muelle::lab {

using engine::SurfaceMesh;
using engine::Triangle;

namespace {

constexpr double leastTurn = 0.5;   // cosine of the angle by which a turned edge may tilt its triangles
constexpr double clearGain = 1e-3;  // a gain below this is a tie, which round-off must not decide

const Vec3& vertex(const SurfaceMesh& mesh, int i) { return mesh.vertices[static_cast<std::size_t>(i)]; }

Vec3 normalOf(const SurfaceMesh& mesh, int a, int b, int c) {
  return (vertex(mesh, b) - vertex(mesh, a)).cross(vertex(mesh, c) - vertex(mesh, a)).normalized();
}

/// The angle at a of the triangle abc [rad].
double angleAt(const SurfaceMesh& mesh, int a, int b, int c) {
  const Vec3 ab = vertex(mesh, b) - vertex(mesh, a);
  const Vec3 ac = vertex(mesh, c) - vertex(mesh, a);
  return std::atan2(ab.cross(ac).norm(), ab.dot(ac));
}

/// An edge ab with the third vertices of its triangles abc and bad.
struct Hinge {
  int a, b, c, d;
};

/// Whether turning the edge of a hinge keeps the shape: both new triangles face as both old ones do.
bool keepsShape(const SurfaceMesh& mesh, const Hinge& h) {
  const Vec3 before[] = {normalOf(mesh, h.a, h.b, h.c), normalOf(mesh, h.b, h.a, h.d)};
  const Vec3 after[] = {normalOf(mesh, h.a, h.d, h.c), normalOf(mesh, h.b, h.c, h.d)};
  return std::ranges::all_of(before, [&](const Vec3& m) {
    return std::ranges::all_of(after, [&](const Vec3& n) { return m.dot(n) > leastTurn; });
  });
}

/// Turns edges for which `isBetter` says so; each triangle at most once in one pass.
template <class IsBetter>
void turnEdges(SurfaceMesh& mesh, const IsBetter& isBetter) {
  std::map<std::pair<int, int>, int> triangleOf;  // by directed edge
  for (int t = 0; t < std::ssize(mesh.triangles); ++t) {
    const Triangle& corners = mesh.triangles[static_cast<std::size_t>(t)];
    for (std::size_t i = 0; i < 3; ++i) triangleOf[{corners[i], corners[(i + 1) % 3]}] = t;
  }
  std::vector<bool> isTurned(mesh.triangles.size(), false);
  for (const auto& [a, b, c, d] : engine::hingesOf(mesh.triangles)) {
    const auto first = static_cast<std::size_t>(triangleOf.at({a, b}));
    const auto second = static_cast<std::size_t>(triangleOf.at({b, a}));
    const Hinge hinge = {a, b, c, d};
    const bool isEdge = triangleOf.contains({c, d}) || triangleOf.contains({d, c});
    if (isTurned[first] || isTurned[second] || isEdge || !isBetter(hinge) || !keepsShape(mesh, hinge)) continue;
    mesh.triangles[first] = {a, d, c};
    mesh.triangles[second] = {b, c, d};
    isTurned[first] = isTurned[second] = true;
    triangleOf[{c, d}] = triangleOf[{d, c}] = static_cast<int>(first);  // for isEdge alone
  }
}

double lengthOf(const SurfaceMesh& mesh, int a, int b) { return (vertex(mesh, a) - vertex(mesh, b)).norm(); }

/// The vertices about each vertex, and its triangles.
struct Surroundings {
  explicit Surroundings(const SurfaceMesh& mesh) : neighbours(mesh.vertices.size()), triangles(mesh.vertices.size()) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      for (const int i : mesh.triangles[t]) {
        triangles[static_cast<std::size_t>(i)].push_back(t);
        for (const int j : mesh.triangles[t]) {
          if (i != j) neighbours[static_cast<std::size_t>(i)].insert(j);
        }
      }
    }
  }
  std::vector<std::set<int>> neighbours;
  std::vector<std::vector<std::size_t>> triangles;
};

/// Whether b may be taken into a, at x: a and b have two neighbours in common, no edge becomes longer than `most`, no
/// triangle turns away.
bool mayMerge(const SurfaceMesh& mesh, const Surroundings& about, int a, int b, const Vec3& x, double most) {
  const std::set<int>& ofA = about.neighbours[static_cast<std::size_t>(a)];
  const std::set<int>& ofB = about.neighbours[static_cast<std::size_t>(b)];
  if (std::ranges::count_if(ofA, [&](int i) { return ofB.contains(i); }) != 2) return false;
  for (const int from : {a, b}) {
    for (const int i : about.neighbours[static_cast<std::size_t>(from)]) {
      if ((vertex(mesh, i) - x).norm() > most) return false;
    }
    for (const std::size_t t : about.triangles[static_cast<std::size_t>(from)]) {
      Triangle corners = mesh.triangles[t];
      if (std::ranges::count(corners, a) + std::ranges::count(corners, b) == 2) continue;  // goes
      std::rotate(corners.begin(), std::find(corners.begin(), corners.end(), from), corners.end());
      const Vec3 p = vertex(mesh, corners[1]);
      const Vec3 q = vertex(mesh, corners[2]);
      if ((p - x).cross(q - x).normalized().dot(normalOf(mesh, from, corners[1], corners[2])) < leastTurn) return false;
    }
  }
  return true;
}

}  // namespace

void evenValences(SurfaceMesh& mesh) {
  std::vector<int> valence(mesh.vertices.size(), 0);
  for (const Triangle& t : mesh.triangles) {
    for (const int i : t) ++valence[static_cast<std::size_t>(i)];
  }
  const auto excess = [&](int i, int change) { return std::abs(valence[static_cast<std::size_t>(i)] + change - 6); };
  turnEdges(mesh, [&](const Hinge& h) {
    const int before = excess(h.a, 0) + excess(h.b, 0) + excess(h.c, 0) + excess(h.d, 0);
    const int after = excess(h.a, -1) + excess(h.b, -1) + excess(h.c, 1) + excess(h.d, 1);
    return after < before;
  });
}

void openAngles(SurfaceMesh& mesh) {
  turnEdges(mesh, [&](const Hinge& h) {
    return angleAt(mesh, h.c, h.a, h.b) + angleAt(mesh, h.d, h.b, h.a) > M_PI + clearGain;
  });
}

void splitLongEdges(SurfaceMesh& mesh, double most) {
  std::map<std::pair<int, int>, std::size_t> triangleOf;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Triangle& corners = mesh.triangles[t];
    for (std::size_t i = 0; i < 3; ++i) triangleOf[{corners[i], corners[(i + 1) % 3]}] = t;
  }
  std::vector<bool> isParted(mesh.triangles.size(), false);
  for (const auto& [a, b, c, d] : engine::hingesOf(mesh.triangles)) {
    const std::size_t first = triangleOf.at({a, b});
    const std::size_t second = triangleOf.at({b, a});
    if (isParted[first] || isParted[second] || lengthOf(mesh, a, b) <= most) continue;
    const int m = static_cast<int>(std::ssize(mesh.vertices));
    mesh.vertices.push_back(0.5 * (vertex(mesh, a) + vertex(mesh, b)));
    mesh.triangles[first] = {a, m, c};
    mesh.triangles[second] = {b, m, d};
    mesh.triangles.push_back({m, b, c});
    mesh.triangles.push_back({m, a, d});
    isParted[first] = isParted[second] = true;
  }
}

void mergeShortEdges(SurfaceMesh& mesh, double least, double most) {
  const Surroundings about(mesh);
  std::vector<bool> isTouched(mesh.vertices.size(), false);
  for (const auto& [a, b] : engine::edgesOf(mesh.triangles)) {
    const auto i = static_cast<std::size_t>(a);
    const auto j = static_cast<std::size_t>(b);
    const Vec3 x = 0.5 * (mesh.vertices[i] + mesh.vertices[j]);
    if (isTouched[i] || isTouched[j] || lengthOf(mesh, a, b) >= least || !mayMerge(mesh, about, a, b, x, most))
      continue;
    mesh.vertices[i] = x;
    for (const std::size_t t : about.triangles[j]) std::ranges::replace(mesh.triangles[t], b, a);
    for (const int near : about.neighbours[i]) isTouched[static_cast<std::size_t>(near)] = true;
    for (const int near : about.neighbours[j]) isTouched[static_cast<std::size_t>(near)] = true;
  }
  std::erase_if(mesh.triangles, [](const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
  engine::dropUnused(mesh);
}

}  // namespace muelle::lab
