// loses: SortedEdges; misconception: not_sorted
// Each edge is there once, but in the order in which the triangles bring them, not sorted.
#include "mesh_to_springs.h"

static void insertEdge(std::vector<Edge>& edges, int a, int b) {
  Edge e = a < b ? Edge{a, b} : Edge{b, a};
  auto pos = std::find(edges.begin(), edges.end(), e);
  if (pos == edges.end()) edges.push_back(e);
}

std::vector<Edge> meshEdges(const std::vector<Triangle>& triangles) {
  std::vector<Edge> edges;
  for (auto t = triangles.begin(); t != triangles.end(); ++t) {
    insertEdge(edges, (*t)[0], (*t)[1]);
    insertEdge(edges, (*t)[1], (*t)[2]);
    insertEdge(edges, (*t)[2], (*t)[0]);
  }
  return edges;
}

std::vector<Edge> structuralSprings(int rows, int columns) {
  std::vector<Edge> edges;
  // rows
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns - 1; ++j) edges.push_back({i * columns + j, i * columns + j + 1});
  // columns
  for (int i = 0; i < rows - 1; ++i)
    for (int j = 0; j < columns; ++j) edges.push_back({i * columns + j, (i + 1) * columns + j});
  std::sort(edges.begin(), edges.end());
  return edges;
}

std::vector<Edge> shearSprings(int rows, int columns) {
  std::vector<Edge> edges;
  // cell by cell
  for (int i = 0; i < rows - 1; ++i) {
    for (int j = 0; j < columns - 1; ++j) {
      int topLeft = i * columns + j;
      int topRight = topLeft + 1;
      int bottomLeft = topLeft + columns;
      int bottomRight = bottomLeft + 1;
      edges.push_back({topLeft, bottomRight});
      edges.push_back({topRight, bottomLeft});
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

std::vector<Edge> bendingSprings(int rows, int columns) {
  std::vector<Edge> edges;
  for (int i = 0; i < rows; ++i)
    for (int j = 2; j < columns; ++j) edges.push_back({i * columns + j - 2, i * columns + j});
  for (int i = 2; i < rows; ++i)
    for (int j = 0; j < columns; ++j) edges.push_back({(i - 2) * columns + j, i * columns + j});
  std::sort(edges.begin(), edges.end());
  return edges;
}

std::vector<double> restLengths(const std::vector<Vec3>& nodes, const std::vector<Edge>& edges) {
  std::vector<double> lengths;
  for (Edge e : edges) {
    Vec3 d = nodes[e[0]] - nodes[e[1]];
    double squared = 0.0;
    for (int c = 0; c < 3; ++c) squared += d[c] * d[c];
    lengths.push_back(std::sqrt(squared));
  }
  return lengths;
}

std::vector<double> equalMasses(double M, int n) {
  std::vector<double> masses(n);
  for (double& mass : masses) mass = M / n;
  return masses;
}

std::vector<double> massesByArea(const std::vector<Vec3>& nodes, const std::vector<Triangle>& triangles,
                                 double density) {
  std::vector<double> masses(nodes.size(), 0.0);
  for (auto t = triangles.rbegin(); t != triangles.rend(); ++t) {
    Vec3 ab = nodes[(*t)[1]] - nodes[(*t)[0]];
    Vec3 ac = nodes[(*t)[2]] - nodes[(*t)[0]];
    double nx = ab.y() * ac.z() - ab.z() * ac.y();
    double ny = ab.z() * ac.x() - ab.x() * ac.z();
    double nz = ab.x() * ac.y() - ab.y() * ac.x();
    double mass = density * 0.5 * std::sqrt(nx * nx + ny * ny + nz * nz);
    for (int corner = 0; corner < 3; ++corner) masses[(*t)[corner]] += mass / 3.0;
  }
  return masses;
}
