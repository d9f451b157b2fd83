// loses: GridSprings; misconception: inside_only or last_row_and_column
// bendingSprings ends both loops two nodes early for both directions, so the springs along the last two rows and the
// last two columns are missing.
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
  for (int i = 0; i < rows - 2; ++i) {
    for (int j = 0; j < columns - 2; ++j) {
      const int node = i * columns + j;
      springs.push_back({node, node + 2});
      springs.push_back({node, node + 2 * columns});
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
    const Vec3 u = nodes[t[1]] - nodes[t[0]], v = nodes[t[2]] - nodes[t[0]];
    const double third = density * 0.5 * u.cross(v).norm() / 3;
    for (int corner : t) masses[corner] += third;
  }
  return masses;
}
