// loses: MeshEdges, EulersFormula; misconception: border_only
// an edge that is there already is taken out: it was meant as "once only"
#include "mesh_to_springs.h"

#include <set>

std::vector<Edge> meshEdges(const std::vector<Triangle>& triangles) {
  std::set<Edge> found;
  for (const Triangle& t : triangles) {
    for (int k = 0; k < 3; k++) {
      Edge e = {std::min(t[k], t[(k + 1) % 3]), std::max(t[k], t[(k + 1) % 3])};
      if (found.count(e)) {
        found.erase(e);
      } else {
        found.insert(e);
      }
    }
  }
  return std::vector<Edge>(found.begin(), found.end());
}

std::vector<Edge> structuralSprings(int rows, int columns) {
  std::set<Edge> springs;
  for (int i = 0; i < rows; i++) {
    for (int j = 0; j < columns; j++) {
      int here = i * columns + j;
      if (j + 1 < columns) springs.insert({here, here + 1});
      if (i + 1 < rows) springs.insert({here, here + columns});
    }
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
