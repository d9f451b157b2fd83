#include "mesh_to_springs.h"

#include <cstdint>
#include <utility>

namespace {

/// All springs of a grid that go from a node by one of the steps (rows down, columns to the right).
std::vector<Edge> springsAlong(int rows, int columns, std::vector<std::pair<int, int>> steps) {
  // by the number of the other end, so that the list comes out in order by itself
  std::sort(steps.begin(), steps.end());
  std::vector<Edge> springs;
  const int count = rows * columns;
  for (int node = 0; node < count; ++node) {
    const int row = node / columns, column = node % columns;
    for (const auto& [down, right] : steps) {
      const bool inside = row + down < rows && column + right >= 0 && column + right < columns;
      if (inside) springs.push_back({node, node + down * columns + right});
    }
  }
  return springs;
}

class Surface {
 public:
  explicit Surface(const std::vector<Vec3>& nodes) : nodes_(nodes) {}

  double doubleArea(const Triangle& t) const {
    const Vec3 &a = at(t[0]), &b = at(t[1]), &c = at(t[2]);
    return (a - c).cross(b - c).norm();
  }

  const Vec3& at(int i) const { return nodes_[static_cast<std::size_t>(i)]; }

 private:
  const std::vector<Vec3>& nodes_;
};

}  // namespace

// For each node the list of its neighbours with a larger number; then these lists one after the other.
std::vector<Edge> meshEdges(const std::vector<Triangle>& triangles) {
  int most = -1;
  for (const Triangle& t : triangles) most = std::max({most, t[0], t[1], t[2]});
  std::vector<std::vector<int>> larger(static_cast<std::size_t>(most + 1));
  for (Triangle t : triangles) {
    std::sort(t.begin(), t.end());
    larger[static_cast<std::size_t>(t[0])].push_back(t[1]);
    larger[static_cast<std::size_t>(t[0])].push_back(t[2]);
    larger[static_cast<std::size_t>(t[1])].push_back(t[2]);
  }
  std::vector<Edge> edges;
  for (int node = 0; node <= most; ++node) {
    std::vector<int>& neighbours = larger[static_cast<std::size_t>(node)];
    std::sort(neighbours.begin(), neighbours.end());
    int last = -1;
    for (const int neighbour : neighbours) {
      if (neighbour != last) edges.push_back({node, neighbour});
      last = neighbour;
    }
  }
  return edges;
}

std::vector<Edge> structuralSprings(int rows, int columns) { return springsAlong(rows, columns, {{0, 1}, {1, 0}}); }

std::vector<Edge> shearSprings(int rows, int columns) { return springsAlong(rows, columns, {{1, 1}, {1, -1}}); }

std::vector<Edge> bendingSprings(int rows, int columns) { return springsAlong(rows, columns, {{2, 0}, {0, 2}}); }

std::vector<double> restLengths(const std::vector<Vec3>& nodes, const std::vector<Edge>& edges) {
  const Surface surface(nodes);
  std::vector<double> lengths(edges.size());
  std::transform(edges.begin(), edges.end(), lengths.begin(), [&surface](const Edge& edge) {
    const Vec3 &a = surface.at(edge[0]), &b = surface.at(edge[1]);
    return std::hypot(b.x() - a.x(), b.y() - a.y(), b.z() - a.z());
  });
  return lengths;
}

std::vector<double> equalMasses(double M, int n) {
  std::vector<double> masses;
  masses.resize(static_cast<std::size_t>(n));
  std::fill(masses.rbegin(), masses.rend(), M / static_cast<double>(n));
  return masses;
}

// Areas first, all of them; the density and the sixth at the end, once a node.
std::vector<double> massesByArea(const std::vector<Vec3>& nodes, const std::vector<Triangle>& triangles,
                                 double density) {
  const Surface surface(nodes);
  std::vector<double> masses(nodes.size(), 0.0);
  for (auto t = triangles.rbegin(); t != triangles.rend(); ++t) {
    const double area = surface.doubleArea(*t);
    for (const int node : *t) masses[static_cast<std::size_t>(node)] += area;
  }
  for (double& mass : masses) mass *= density / 6;
  return masses;
}
