// loses: MassesByArea; misconception: none
// massesByArea gives two thirds of each triangle to its second node and nothing to its third one (copy-paste slip in
// the index).
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
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < columns; ++j) {
      const int node = i * columns + j;
      if (j + 1 < columns) springs.push_back({node, node + 1});
      if (i + 1 < rows) springs.push_back({node, node + columns});
    }
  }
  std::sort(springs.begin(), springs.end());
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
  std::vector<double> masses(nodes.size(), 0.0);
  for (const Triangle& t : triangles) {
    const Vec3 ab = nodes[t[1]] - nodes[t[0]];
    const Vec3 ac = nodes[t[2]] - nodes[t[0]];
    const double area = 0.5 * ab.cross(ac).norm();
    masses[t[0]] += density * area / 3;
    masses[t[1]] += density * area / 3;
    masses[t[1]] += density * area / 3;
  }
  return masses;
}
