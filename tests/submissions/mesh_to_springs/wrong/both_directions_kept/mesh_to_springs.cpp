// loses: MeshEdges, EachEdgeOnce, EulersFormula; misconception: both_ways_round
// meshEdges removes repeats before it puts the smaller node first, so an edge that two triangles run along in
// opposite directions stays in the list twice.
#include "mesh_to_springs.h"

#include <set>

std::vector<Edge> meshEdges(const std::vector<Triangle>& triangles) {
  std::set<Edge> edges;  // a set keeps each edge once
  for (const Triangle& t : triangles) {
    edges.insert({t[0], t[1]});
    edges.insert({t[1], t[2]});
    edges.insert({t[2], t[0]});
  }
  std::vector<Edge> list(edges.begin(), edges.end());
  for (Edge& edge : list) {
    if (edge[0] > edge[1]) std::swap(edge[0], edge[1]);
  }
  std::sort(list.begin(), list.end());
  return list;
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
  std::vector<double> masses(nodes.size(), 0.0);
  for (const Triangle& t : triangles) {
    const Vec3 u = nodes[t[1]] - nodes[t[0]], v = nodes[t[2]] - nodes[t[0]];
    const double third = density * 0.5 * u.cross(v).norm() / 3;
    for (int corner : t) masses[corner] += third;
  }
  return masses;
}
