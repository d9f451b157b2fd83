#include "lab/meshes/marching_tetrahedra.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <Eigen/Geometry>
#include <map>
#include <utility>
#include <vector>

namespace muelle::lab {

using engine::SurfaceMesh;

namespace {

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

}  // namespace

SurfaceMesh cutSurface(const ImplicitBody& body, double spacing) {
  const Grid grid(body, spacing);
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

}  // namespace muelle::lab
