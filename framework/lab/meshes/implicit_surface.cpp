#include "lab/meshes/implicit_surface.h"

#include "engine/scene/connectivity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <Eigen/Geometry>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace muelle::lab {

namespace {

using engine::SurfaceMesh;
using engine::Triangle;

constexpr int rounds = 32;          // of turning edges and moving vertices
constexpr double leastTurn = 0.5;   // cosine of the angle by which a turned edge may tilt its triangles
constexpr double clearGain = 1e-3;  // a gain below this is a tie, which round-off must not decide

// --- the first surface ---

using Index = std::array<int, 3>;

/// The samples of a body on a grid.
class Grid {
 public:
  Grid(const ImplicitBody& body, double spacing) : spacing_(spacing), least_(body.least) {
    for (std::size_t a = 0; a < 3; ++a) {
      const auto axis = static_cast<Eigen::Index>(a);
      cells_[a] = static_cast<int>(std::ceil((body.most[axis] - body.least[axis]) / spacing));
    }
    for (int k = 0; k <= cells_[2]; ++k) {
      for (int j = 0; j <= cells_[1]; ++j) {
        for (int i = 0; i <= cells_[0]; ++i) values_.push_back(body.value(point({i, j, k})));
      }
    }
  }

  const Index& cells() const { return cells_; }
  Vec3 point(const Index& p) const { return least_ + spacing_ * Vec3(p[0], p[1], p[2]); }
  double value(const Index& p) const { return values_[static_cast<std::size_t>(number(p))]; }
  int number(const Index& p) const { return (p[2] * (cells_[1] + 1) + p[1]) * (cells_[0] + 1) + p[0]; }

 private:
  double spacing_;
  Vec3 least_;
  Index cells_{};
  std::vector<double> values_;
};

/// Cuts the surface out of the tetrahedra of a grid; each edge that it crosses has one vertex.
class Cutter {
 public:
  Cutter(const Grid& grid, SurfaceMesh& mesh) : grid_(grid), mesh_(mesh) {}

  /// The part within one tetrahedron: none, a triangle, or a quadrangle as two of them.
  void cut(const std::array<Index, 4>& corners) {
    std::vector<Index> in, out;
    for (const Index& p : corners) (grid_.value(p) < 0.0 ? in : out).push_back(p);
    if (in.empty() || out.empty()) return;
    const Vec3 outwards = middle(out) - middle(in);
    if (in.size() == 2) {
      const std::array<int, 4> quad = {crossing(in[0], out[0]), crossing(in[0], out[1]), crossing(in[1], out[1]),
                                       crossing(in[1], out[0])};
      add(quad[0], quad[1], quad[2], outwards);
      add(quad[0], quad[2], quad[3], outwards);
    } else if (in.size() == 1) {
      add(crossing(in[0], out[0]), crossing(in[0], out[1]), crossing(in[0], out[2]), outwards);
    } else {
      add(crossing(in[0], out[0]), crossing(in[1], out[0]), crossing(in[2], out[0]), outwards);
    }
  }

 private:
  Vec3 middle(const std::vector<Index>& points) const {
    Vec3 sum = Vec3::Zero();
    for (const Index& p : points) sum += grid_.point(p);
    return sum / static_cast<double>(points.size());
  }

  int crossing(const Index& p, const Index& q) {
    const auto [found, isNew] = vertexOn_.try_emplace(std::minmax({grid_.number(p), grid_.number(q)}),
                                                      static_cast<int>(std::ssize(mesh_.vertices)));
    if (isNew) {
      const double s = grid_.value(p) / (grid_.value(p) - grid_.value(q));
      mesh_.vertices.push_back((1.0 - s) * grid_.point(p) + s * grid_.point(q));
    }
    return found->second;
  }

  void add(int a, int b, int c, const Vec3& outwards) {
    const auto at = [this](int i) -> const Vec3& { return mesh_.vertices[static_cast<std::size_t>(i)]; };
    if ((at(b) - at(a)).cross(at(c) - at(a)).dot(outwards) < 0.0) std::swap(b, c);
    mesh_.triangles.push_back({a, b, c});
  }

  const Grid& grid_;
  SurfaceMesh& mesh_;
  std::map<std::pair<int, int>, int> vertexOn_;
};

/// Each cell of the grid as six tetrahedra about its diagonal, one for each order of the axes (Kuhn): those of
/// neighbours meet, so that the surface is closed whatever the samples are (marching tetrahedra: Doi, Koide 1991).
SurfaceMesh cutOut(const Grid& grid) {
  constexpr std::array<std::array<std::size_t, 3>, 6> orders = {
      {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};
  SurfaceMesh mesh;
  Cutter cutter(grid, mesh);
  for (int k = 0; k < grid.cells()[2]; ++k) {
    for (int j = 0; j < grid.cells()[1]; ++j) {
      for (int i = 0; i < grid.cells()[0]; ++i) {
        for (const auto& order : orders) {
          std::array<Index, 4> corners = {{{i, j, k}, {i, j, k}, {i, j, k}, {i + 1, j + 1, k + 1}}};
          ++corners[1][order[0]];
          corners[2] = corners[1];
          ++corners[2][order[1]];
          cutter.cut(corners);
        }
      }
    }
  }
  return mesh;
}

// --- evening it out ---

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

/// Towards six edges at each vertex.
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

/// Towards the larger of the smallest angles (Delaunay).
void openAngles(SurfaceMesh& mesh) {
  turnEdges(mesh, [&](const Hinge& h) {
    return angleAt(mesh, h.c, h.a, h.b) + angleAt(mesh, h.d, h.b, h.a) > M_PI + clearGain;
  });
}

double lengthOf(const SurfaceMesh& mesh, int a, int b) { return (vertex(mesh, a) - vertex(mesh, b)).norm(); }

/// Puts a vertex into the middle of edges longer than `most`; each triangle is parted at most once in one pass.
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

/// Makes one vertex of the ends of edges shorter than `least`; near one that has gone none goes in the same pass.
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
  SurfaceMesh mesh = cutOut(Grid(body, size));
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
