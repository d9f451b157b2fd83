// loses: GridSprings; misconception: round_the_end
// shearSprings does not ask whether column j - 1 is inside the grid, so each first node of a row gets a spring to the
// last node of its own row.
#include "mesh_to_springs.h"

#include <set>

std::vector<Edge> meshEdges(const std::vector<Triangle>& triangles) {
  std::set<Edge> found;
  auto add = [&found](int a, int b) {
    if (a < b)
      found.insert(Edge{a, b});
    else
      found.insert(Edge{b, a});
  };
  for (std::size_t i = 0; i < triangles.size(); i++) {
    add(triangles[i][0], triangles[i][1]);
    add(triangles[i][1], triangles[i][2]);
    add(triangles[i][2], triangles[i][0]);
  }
  std::vector<Edge> result;
  for (const Edge& e : found) result.push_back(e);
  return result;
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
  for (int i = 0; i < rows - 1; i++) {
    for (int j = 0; j < columns; j++) {
      const int here = i * columns + j;
      if (j + 1 < columns) out.push_back({here, (i + 1) * columns + (j + 1)});
      out.push_back({here, (i + 1) * columns + (j - 1)});
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
  std::vector<double> lengths;
  for (const Edge& edge : edges) lengths.push_back((nodes[edge[0]] - nodes[edge[1]]).norm());
  return lengths;
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
