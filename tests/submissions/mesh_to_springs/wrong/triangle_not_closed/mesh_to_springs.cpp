// loses: MeshEdges, EachEdgeOnce, EulersFormula; misconception: closing_edge_missing
// Walks along a triangle from corner to corner but does not close it: the edge from the third node to the first is
// missing.
#include "mesh_to_springs.h"

std::vector<Edge> meshEdges(const std::vector<Triangle>& triangles) {
  std::vector<Edge> edges;
  edges.reserve(3 * triangles.size());
  for (const Triangle& t : triangles) {
    for (int k = 0; k < 2; k++) {
      int a = t[k];
      int b = t[(k + 1) % 3];
      if (a > b) std::swap(a, b);
      edges.push_back({a, b});
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

std::vector<Edge> structuralSprings(int rows, int columns) {
  std::vector<Edge> edges;
  for (int i = 0; i < rows; i++) {
    for (int j = 0; j < columns; j++) {
      int node = i * columns + j;
      if (j + 1 < columns) edges.push_back({node, node + 1});
      if (i + 1 < rows) edges.push_back({node, node + columns});
    }
  }
  return edges;
}

std::vector<Edge> shearSprings(int rows, int columns) {
  std::vector<Edge> edges;
  for (int i = 0; i < rows - 1; i++) {
    for (int j = 0; j < columns; j++) {
      int node = i * columns + j;
      if (j > 0) edges.push_back({node, node + columns - 1});
      if (j < columns - 1) edges.push_back({node, node + columns + 1});
    }
  }
  return edges;
}

std::vector<Edge> bendingSprings(int rows, int columns) {
  std::vector<Edge> edges;
  for (int i = 0; i < rows; i++) {
    for (int j = 0; j < columns; j++) {
      int node = i * columns + j;
      if (j + 2 < columns) edges.push_back({node, node + 2});
      if (i + 2 < rows) edges.push_back({node, node + 2 * columns});
    }
  }
  return edges;
}

std::vector<double> restLengths(const std::vector<Vec3>& nodes, const std::vector<Edge>& edges) {
  std::vector<double> L(edges.size());
  for (size_t s = 0; s < edges.size(); s++) {
    Vec3 d = nodes[edges[s][1]] - nodes[edges[s][0]];
    L[s] = sqrt(d.x() * d.x() + d.y() * d.y() + d.z() * d.z());
  }
  return L;
}

std::vector<double> equalMasses(double M, int n) {
  std::vector<double> m;
  for (int i = 0; i < n; i++) m.push_back(M / n);
  return m;
}

std::vector<double> massesByArea(const std::vector<Vec3>& nodes, const std::vector<Triangle>& triangles,
                                 double density) {
  std::vector<double> m(nodes.size(), 0.0);
  for (size_t t = 0; t < triangles.size(); t++) {
    int a = triangles[t][0], b = triangles[t][1], c = triangles[t][2];
    Vec3 u = nodes[b] - nodes[a];
    Vec3 v = nodes[c] - nodes[a];
    double area = u.cross(v).norm() / 2;
    double third = density * area / 3;
    m[a] += third;
    m[b] += third;
    m[c] += third;
  }
  return m;
}
