#include "mesh_to_springs.h"

std::vector<Edge> meshEdges(const std::vector<Triangle>& triangles) {
  std::vector<Edge> edges;
  for (const Triangle& t : triangles) {
    for (int c = 0; c < 3; ++c) {
      const int i = t[c], j = t[(c + 1) % 3];
      edges.push_back({std::min(i, j), std::max(i, j)});
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

std::vector<Edge> structuralSprings(int rows, int columns) {
  std::vector<Edge> springs;
  const int n = rows * columns;
  for (int p = 0; p < n; ++p) {
    if ((p + 1) % columns != 0) springs.push_back({p, p + 1});
    if (p + columns < n) springs.push_back({p, p + columns});
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
  const int n = rows * columns;
  for (int p = 0; p < n; ++p) {
    if (p % columns + 2 < columns) springs.push_back({p, p + 2});
    if (p + 2 * columns < n) springs.push_back({p, p + 2 * columns});
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
  std::vector<double> masses;
  for (int i = 0; i < static_cast<int>(nodes.size()); ++i) {
    double mass = 0;
    for (const Triangle& t : triangles) {
      if (std::find(t.begin(), t.end(), i) == t.end()) continue;
      const Vec3 normal = (nodes[t[0]] - nodes[t[2]]).cross(nodes[t[1]] - nodes[t[2]]);
      mass += density * normal.stableNorm() / 6.0;
    }
    masses.push_back(mass);
  }
  return masses;
}
