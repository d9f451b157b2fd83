#include "mesh_to_springs.h"

namespace {

int number(int i, int j, int columns) { return i * columns + j; }

std::vector<Edge> springsByOffsets(int rows, int columns, const std::vector<std::pair<int, int>>& offsets) {
  std::vector<Edge> springs;
  for (const auto& [di, dj] : offsets) {
    for (int i = 0; i < rows; ++i) {
      for (int j = 0; j < columns; ++j) {
        if (i + di >= rows || j + dj >= columns || j + dj < 0) continue;
        springs.push_back({number(i, j, columns), number(i + di, j + dj, columns)});
      }
    }
  }
  std::sort(springs.begin(), springs.end());
  return springs;
}

}  // namespace

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
  return springsByOffsets(rows, columns, {{1, 0}, {0, 1}});
}

std::vector<Edge> shearSprings(int rows, int columns) {
  return springsByOffsets(rows, columns, {{1, 1}, {1, -1}});
}

std::vector<Edge> bendingSprings(int rows, int columns) {
  return springsByOffsets(rows, columns, {{2, 0}, {0, 2}});
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
  std::vector<double> masses(nodes.size(), 0.0);
  for (const Triangle& t : triangles) {
    const Vec3 u = nodes[t[1]] - nodes[t[0]];
    const Vec3 v = nodes[t[2]] - nodes[t[0]];
    const double third = density * 0.5 * u.cross(v).norm() / 3;
    for (int i : t) masses[i] += third;
  }
  return masses;
}
