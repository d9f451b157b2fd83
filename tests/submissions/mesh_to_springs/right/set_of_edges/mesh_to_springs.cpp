#include "mesh_to_springs.h"

#include <set>

namespace {

Edge edgeBetween(int i, int j) { return i < j ? Edge{i, j} : Edge{j, i}; }

}  // namespace

std::vector<Edge> meshEdges(const std::vector<Triangle>& triangles) {
  std::set<Edge> all;
  for (auto [a, b, c] : triangles) {
    all.insert(edgeBetween(a, b));
    all.insert(edgeBetween(b, c));
    all.insert(edgeBetween(c, a));
  }
  return std::vector<Edge>(all.begin(), all.end());
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
  return springs;
}

std::vector<Edge> shearSprings(int rows, int columns) {
  std::vector<Edge> springs;
  for (int i = 0; i + 1 < rows; ++i) {
    for (int j = 0; j + 1 < columns; ++j) {
      const int node = i * columns + j;
      springs.push_back({node, node + columns + 1});
      springs.push_back({node + 1, node + columns});
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
  return springs;
}

std::vector<double> restLengths(const std::vector<Vec3>& nodes, const std::vector<Edge>& edges) {
  std::vector<double> lengths;
  for (const Edge& edge : edges) lengths.push_back((nodes[edge[0]] - nodes[edge[1]]).norm());
  return lengths;
}

std::vector<double> equalMasses(double M, int n) {
  return std::vector<double>(n, M / n);
}

std::vector<double> massesByArea(const std::vector<Vec3>& nodes, const std::vector<Triangle>& triangles,
                                 double density) {
  std::vector<double> m(nodes.size());
  for (auto [a, b, c] : triangles) {
    const double la = (nodes[b] - nodes[c]).norm(), lb = (nodes[a] - nodes[c]).norm(), lc = (nodes[a] - nodes[b]).norm();
    const double s = (la + lb + lc) / 2;
    const double area = std::sqrt(s * (s - la) * (s - lb) * (s - lc));  // Heron
    m[a] += area * density / 3;
    m[b] += area * density / 3;
    m[c] += area * density / 3;
  }
  return m;
}
