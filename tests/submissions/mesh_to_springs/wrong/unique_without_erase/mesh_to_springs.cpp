// loses: MeshEdges, EachEdgeOnce, EulersFormula, SortedEdges; misconception: not_erased
// meshEdges calls std::unique but does not erase what lies behind its result, so the list still has three entries a
// triangle, with left-overs at its end.
#include "mesh_to_springs.h"

std::vector<Edge> meshEdges(const std::vector<Triangle>& triangles) {
  std::vector<Edge> edges;
  for (const auto& [a, b, c] : triangles) {
    edges.push_back({std::min(a, b), std::max(a, b)});
    edges.push_back({std::min(b, c), std::max(b, c)});
    edges.push_back({std::min(a, c), std::max(a, c)});
  }
  std::sort(edges.begin(), edges.end());
  (void)std::unique(edges.begin(), edges.end());
  return edges;
}

std::vector<Edge> structuralSprings(int rows, int columns) {
  std::vector<Edge> out;
  for (int i = 0; i < rows; i++)
    for (int j = 0; j < columns - 1; j++) out.push_back({i * columns + j, i * columns + j + 1});
  for (int i = 0; i < rows - 1; i++)
    for (int j = 0; j < columns; j++) out.push_back({i * columns + j, (i + 1) * columns + j});
  std::sort(out.begin(), out.end());
  return out;
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
  std::vector<Edge> out;
  for (int i = 0; i < rows; i++)
    for (int j = 0; j < columns - 2; j++) out.push_back({i * columns + j, i * columns + j + 2});
  for (int i = 0; i < rows - 2; i++)
    for (int j = 0; j < columns; j++) out.push_back({i * columns + j, (i + 2) * columns + j});
  std::sort(out.begin(), out.end());
  return out;
}

std::vector<double> restLengths(const std::vector<Vec3>& nodes, const std::vector<Edge>& edges) {
  std::vector<double> L0(edges.size());
  for (std::size_t s = 0; s < edges.size(); s++) {
    const Vec3 d = nodes[edges[s][1]] - nodes[edges[s][0]];
    L0[s] = std::sqrt(d.dot(d));
  }
  return L0;
}

std::vector<double> equalMasses(double M, int n) {
  std::vector<double> masses;
  for (int i = 0; i < n; i++) masses.push_back(M / n);
  return masses;
}

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
