#include "mesh_to_springs.h"

#include <set>

namespace {

/// A set keeps each edge once, and in order.
std::vector<Edge> listOf(const std::set<Edge>& edges) { return {edges.begin(), edges.end()}; }

/// The edges from each node of a grid to the one that is `down` rows below and `right` columns beside it, where there
/// is one.
void addSteps(std::set<Edge>& edges, int rows, int columns, int down, int right) {
  for (int i = 0; i + down < rows; ++i) {
    for (int j = 0; j < columns; ++j) {
      const int to = j + right;
      if (0 <= to && to < columns) edges.insert({i * columns + j, (i + down) * columns + to});
    }
  }
}

const Vec3& at(const std::vector<Vec3>& nodes, int i) { return nodes[static_cast<std::size_t>(i)]; }

}  // namespace

std::vector<Edge> meshEdges(const std::vector<Triangle>& triangles) {
  std::set<Edge> edges;
  for (const auto& [a, b, c] : triangles) {
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
      edges.insert({std::min(from, to), std::max(from, to)});
    }
  }
  return listOf(edges);
}

std::vector<Edge> structuralSprings(int rows, int columns) {
  std::set<Edge> edges;
  addSteps(edges, rows, columns, 0, 1);
  addSteps(edges, rows, columns, 1, 0);
  return listOf(edges);
}

std::vector<Edge> shearSprings(int rows, int columns) {
  std::set<Edge> edges;
  addSteps(edges, rows, columns, 1, 1);
  addSteps(edges, rows, columns, 1, -1);
  return listOf(edges);
}

std::vector<Edge> bendingSprings(int rows, int columns) {
  std::set<Edge> edges;
  addSteps(edges, rows, columns, 0, 2);
  addSteps(edges, rows, columns, 2, 0);
  return listOf(edges);
}

std::vector<double> restLengths(const std::vector<Vec3>& nodes, const std::vector<Edge>& edges) {
  std::vector<double> lengths;
  for (const auto& [a, b] : edges) lengths.push_back((at(nodes, a) - at(nodes, b)).norm());
  return lengths;
}

std::vector<double> equalMasses(double M, int n) { return std::vector<double>(static_cast<std::size_t>(n), M / n); }

std::vector<double> massesByArea(const std::vector<Vec3>& nodes, const std::vector<Triangle>& triangles,
                                 double density) {
  std::vector<double> masses(nodes.size(), 0.0);
  for (const auto& [a, b, c] : triangles) {
    const double area = 0.5 * (at(nodes, b) - at(nodes, a)).cross(at(nodes, c) - at(nodes, a)).norm();
    for (const int i : {a, b, c})
      masses[static_cast<std::size_t>(i)] += density * area / 3;  // +=: nodes share triangles
  }
  return masses;
}
