#include "mesh_to_springs.h"

namespace {

/// Nodes first, first + step, ..., count of them: joins each with the one `over` places on.
void addChain(std::vector<Edge>& edges, int first, int step, int count, int over) {
  for (int i = 0; i + over < count; ++i) edges.push_back({first + i * step, first + (i + over) * step});
}

std::vector<Edge> rowsAndColumns(int rows, int columns, int over) {
  std::vector<Edge> edges;
  for (int i = 0; i < rows; ++i) addChain(edges, i * columns, 1, columns, over);
  for (int j = 0; j < columns; ++j) addChain(edges, j, columns, rows, over);
  std::sort(edges.begin(), edges.end());
  return edges;
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

std::vector<Edge> structuralSprings(int rows, int columns) { return rowsAndColumns(rows, columns, 1); }

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

std::vector<Edge> bendingSprings(int rows, int columns) { return rowsAndColumns(rows, columns, 2); }

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
