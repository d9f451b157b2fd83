// loses: GridSprings; misconception: round_the_end
// n + 1 is the neighbour of n, at the end of a row, too
#include "mesh_to_springs.h"

#include <set>

std::vector<Edge> meshEdges(const std::vector<Triangle>& triangles) {
  std::set<Edge> found;
  for (const Triangle& t : triangles) {
    for (int k = 0; k < 3; k++) {
      int a = t[k];
      int b = t[(k + 1) % 3];
      if (a > b) std::swap(a, b);
      found.insert({a, b});
    }
  }
  return std::vector<Edge>(found.begin(), found.end());
}

std::vector<Edge> structuralSprings(int rows, int columns) {
  std::set<Edge> springs;
  int n = rows * columns;
  for (int a = 0; a < n; a++) {
    if (a + 1 < n) springs.insert({a, a + 1});
    if (a + columns < n) springs.insert({a, a + columns});
  }
  return std::vector<Edge>(springs.begin(), springs.end());
}

std::vector<Edge> shearSprings(int rows, int columns) {
  std::set<Edge> springs;
  for (int i = 0; i + 1 < rows; i++) {
    for (int j = 0; j < columns; j++) {
      int here = i * columns + j;
      if (j + 1 < columns) springs.insert({here, here + columns + 1});
      if (j > 0) springs.insert({here, here + columns - 1});
    }
  }
  return std::vector<Edge>(springs.begin(), springs.end());
}

std::vector<Edge> bendingSprings(int rows, int columns) {
  std::set<Edge> springs;
  for (int i = 0; i < rows; i++) {
    for (int j = 0; j < columns; j++) {
      int here = i * columns + j;
      if (j + 2 < columns) springs.insert({here, here + 2});
      if (i + 2 < rows) springs.insert({here, here + 2 * columns});
    }
  }
  return std::vector<Edge>(springs.begin(), springs.end());
}

std::vector<double> restLengths(const std::vector<Vec3>& nodes, const std::vector<Edge>& edges) {
  std::vector<double> L;
  for (const Edge& e : edges) L.push_back((nodes[e[1]] - nodes[e[0]]).norm());
  return L;
}

std::vector<double> equalMasses(double M, int n) {
  return std::vector<double>(n, M / n);
}

std::vector<double> massesByArea(const std::vector<Vec3>& nodes, const std::vector<Triangle>& triangles,
                                 double density) {
  std::vector<double> mass(nodes.size(), 0.0);
  for (const Triangle& t : triangles) {
    Vec3 u = nodes[t[1]] - nodes[t[0]];
    Vec3 v = nodes[t[2]] - nodes[t[0]];
    double area = 0.5 * u.cross(v).norm();
    double third = density * area / 3;
    mass[t[0]] += third;
    mass[t[1]] += third;
    mass[t[2]] += third;
  }
  return mass;
}
