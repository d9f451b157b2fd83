// loses: GridSprings; misconception: one_diagonal
// Shear springs go one way only, down and to the right.
#include "mesh_to_springs.h"

#include <cstdint>
#include <unordered_set>

namespace {

std::int64_t pack(int a, int b) { return static_cast<std::int64_t>(std::min(a, b)) * 1000000 + std::max(a, b); }

std::vector<Edge> unpack(const std::unordered_set<std::int64_t>& keys) {
  std::vector<std::int64_t> sorted(keys.begin(), keys.end());
  std::sort(sorted.begin(), sorted.end());
  std::vector<Edge> edges;
  for (std::int64_t key : sorted) edges.push_back({static_cast<int>(key / 1000000), static_cast<int>(key % 1000000)});
  return edges;
}

struct Grid {
  int rows, columns;
  bool has(int i, int j) const { return i >= 0 && i < rows && j >= 0 && j < columns; }
  int number(int i, int j) const { return i * columns + j; }
  std::vector<Edge> springs(const std::vector<std::array<int, 2>>& steps) const {
    std::unordered_set<std::int64_t> keys;
    for (int j = 0; j < columns; ++j) {
      for (int i = 0; i < rows; ++i) {
        for (const auto& [down, right] : steps) {
          if (has(i + down, j + right)) keys.insert(pack(number(i, j), number(i + down, j + right)));
        }
      }
    }
    return unpack(keys);
  }
};

}  // namespace

std::vector<Edge> meshEdges(const std::vector<Triangle>& triangles) {
  std::unordered_set<std::int64_t> keys;
  for (const auto& [a, b, c] : triangles) {
    keys.insert(pack(a, b));
    keys.insert(pack(b, c));
    keys.insert(pack(c, a));
  }
  return unpack(keys);
}

std::vector<Edge> structuralSprings(int rows, int columns) {
  return Grid{rows, columns}.springs({{0, 1}, {0, -1}, {1, 0}, {-1, 0}});
}

std::vector<Edge> shearSprings(int rows, int columns) { return Grid{rows, columns}.springs({{1, 1}}); }

std::vector<Edge> bendingSprings(int rows, int columns) { return Grid{rows, columns}.springs({{0, 2}, {2, 0}}); }

std::vector<double> restLengths(const std::vector<Vec3>& nodes, const std::vector<Edge>& edges) {
  std::vector<double> lengths;
  lengths.reserve(edges.size());
  for (const auto& edge : edges) {
    const Vec3& p = nodes[edge[0]];
    const Vec3& q = nodes[edge[1]];
    lengths.push_back(std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]));
  }
  return lengths;
}

std::vector<double> equalMasses(double M, int n) {
  std::vector<double> masses;
  masses.assign(n, M * (1.0 / n));
  return masses;
}

std::vector<double> massesByArea(const std::vector<Vec3>& nodes, const std::vector<Triangle>& triangles,
                                 double density) {
  std::vector<std::vector<std::size_t>> trianglesOf(nodes.size());
  std::vector<double> areas;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (int node : triangles[t]) trianglesOf[node].push_back(t);
    const Vec3 base = nodes[triangles[t][1]] - nodes[triangles[t][0]];
    const Vec3 side = nodes[triangles[t][2]] - nodes[triangles[t][0]];
    const Vec3 height = side - base * (base.dot(side) / base.squaredNorm());
    areas.push_back(base.norm() * height.norm() / 2);
  }
  std::vector<double> masses;
  for (const auto& mine : trianglesOf) {
    double area = 0;
    for (std::size_t t : mine) area += areas[t];
    masses.push_back(density / 3 * area);
  }
  return masses;
}
