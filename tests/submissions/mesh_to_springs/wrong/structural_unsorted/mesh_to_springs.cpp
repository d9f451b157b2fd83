// loses: SortedEdges; misconception: not_sorted
// structuralSprings lists all springs along rows before those along columns and never sorts the list.
#include "mesh_to_springs.h"

std::vector<Edge> meshEdges(const std::vector<Triangle>& triangles) {
  std::vector<Edge> edges;
  edges.reserve(3 * triangles.size());
  for (const auto& [a, b, c] : triangles) {
    edges.push_back({std::min(a, b), std::max(a, b)});
    edges.push_back({std::min(b, c), std::max(b, c)});
    edges.push_back({std::min(c, a), std::max(c, a)});
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

std::vector<Edge> structuralSprings(int rows, int columns) {
  std::vector<Edge> springs;
  // along the rows
  for (int i = 0; i < rows; ++i) {
    for (int j = 1; j < columns; ++j) springs.push_back({i * columns + j - 1, i * columns + j});
  }
  // along the columns
  for (int i = 1; i < rows; ++i) {
    for (int j = 0; j < columns; ++j) springs.push_back({(i - 1) * columns + j, i * columns + j});
  }
  return springs;
}

std::vector<Edge> shearSprings(int rows, int columns) {
  std::vector<Edge> out;
  // two diagonals in each cell
  for (int i = 0; i < rows - 1; i++) {
    for (int j = 0; j < columns - 1; j++) {
      const int a = i * columns + j, b = a + 1, c = a + columns, d = c + 1;
      out.push_back({a, d});
      out.push_back({b, c});
    }
  }
  std::sort(out.begin(), out.end());
  return out;
}

std::vector<Edge> bendingSprings(int rows, int columns) {
  std::vector<Edge> springs;
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < columns; ++j) {
      const int node = i * columns + j;
      if (j + 2 < columns) springs.push_back({node, node + 2});
      if (i + 2 < rows) springs.push_back({node, node + 2 * columns});
    }
  }
  std::sort(springs.begin(), springs.end());
  return springs;
}

std::vector<double> restLengths(const std::vector<Vec3>& nodes, const std::vector<Edge>& edges) {
  std::vector<double> lengths;
  for (const Edge& edge : edges) lengths.push_back((nodes[edge[0]] - nodes[edge[1]]).norm());
  return lengths;
}

std::vector<double> equalMasses(double M, int n) { return std::vector<double>(static_cast<std::size_t>(n), M / n); }

std::vector<double> massesByArea(const std::vector<Vec3>& nodes, const std::vector<Triangle>& triangles,
                                 double density) {
  std::vector<double> masses(nodes.size());
  for (std::size_t i = 0; i < triangles.size(); i++) {
    const int a = triangles[i][0], b = triangles[i][1], c = triangles[i][2];
    const double area = (nodes[b] - nodes[a]).cross(nodes[c] - nodes[a]).norm() / 2.0;
    const double mass = density * area / 3.0;
    masses[a] += mass;
    masses[b] += mass;
    masses[c] += mass;
  }
  return masses;
}
