// loses: MassesByArea, TotalMass; misconception: stateful
// massesByArea keeps its masses in a static vector that is not set to zero, so every call adds to what the calls
// before it have left.
#include "mesh_to_springs.h"

#include <set>

std::vector<Edge> meshEdges(const std::vector<Triangle>& triangles) {
  std::set<Edge> edges;
  for (const Triangle& t : triangles) {
    for (int i = 0; i < 3; ++i) {
      const int a = t[i], b = t[(i + 1) % 3];
      edges.insert({std::min(a, b), std::max(a, b)});
    }
  }
  return std::vector<Edge>(edges.begin(), edges.end());
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
  std::vector<Edge> springs;
  for (int i = 0; i + 1 < rows; ++i) {
    for (int j = 0; j < columns; ++j) {
      const int node = i * columns + j;
      if (j > 0) springs.push_back({node, node + columns - 1});
      if (j + 1 < columns) springs.push_back({node, node + columns + 1});
    }
  }
  std::sort(springs.begin(), springs.end());
  return springs;
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
  static std::vector<double> masses;
  masses.resize(nodes.size(), 0.0);
  for (const Triangle& t : triangles) {
    const Vec3 side1 = nodes[t[1]] - nodes[t[0]];
    const Vec3 side2 = nodes[t[2]] - nodes[t[0]];
    const double area = side1.cross(side2).norm() / 2;
    for (int i = 0; i < 3; ++i) masses[t[i]] += density * area / 3;
  }
  return masses;
}
