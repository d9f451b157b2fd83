// loses: MeshEdges, EachEdgeOnce, EulersFormula, SortedEdges; misconception: stateful
// static set: the second mesh has the edges of the first, too
#include "mesh_to_springs.h"

#include <set>

std::vector<Edge> meshEdges(const std::vector<Triangle>& triangles) {
  static std::set<Edge> known;
  for (const auto& [a, b, c] : triangles) {
    known.insert({std::min(a, b), std::max(a, b)});
    known.insert({std::min(b, c), std::max(b, c)});
    known.insert({std::min(c, a), std::max(c, a)});
  }
  return {known.begin(), known.end()};
}

std::vector<Edge> structuralSprings(int rows, int columns) {
  const auto number = [columns](int i, int j) { return i * columns + j; };
  std::vector<Edge> springs;
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < columns; ++j) {
      const bool right = j + 1 < columns, down = i + 1 < rows;
      if (right) springs.push_back({number(i, j), number(i, j + 1)});
      if (down) springs.push_back({number(i, j), number(i + 1, j)});
    }
  }
  std::ranges::sort(springs);
  return springs;
}

std::vector<Edge> shearSprings(int rows, int columns) {
  const auto number = [columns](int i, int j) { return i * columns + j; };
  std::vector<Edge> springs;
  for (int i = 0; i < rows - 1; ++i) {
    for (int j = 0; j < columns - 1; ++j) {
      springs.push_back({number(i, j), number(i + 1, j + 1)});
      springs.push_back({number(i, j + 1), number(i + 1, j)});
    }
  }
  std::ranges::sort(springs);
  return springs;
}

std::vector<Edge> bendingSprings(int rows, int columns) {
  const auto number = [columns](int i, int j) { return i * columns + j; };
  std::vector<Edge> springs;
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns - 2; ++j) springs.push_back({number(i, j), number(i, j + 2)});
  for (int i = 0; i < rows - 2; ++i)
    for (int j = 0; j < columns; ++j) springs.push_back({number(i, j), number(i + 2, j)});
  std::ranges::sort(springs);
  return springs;
}

std::vector<double> restLengths(const std::vector<Vec3>& nodes, const std::vector<Edge>& edges) {
  std::vector<double> result;
  result.reserve(edges.size());
  for (const auto& [from, to] : edges) {
    const Vec3& p = nodes[from];
    const Vec3& q = nodes[to];
    result.emplace_back(std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]));
  }
  return result;
}

std::vector<double> equalMasses(double M, int n) {
  const double m = M / n;
  std::vector<double> result(static_cast<std::size_t>(n));
  for (double& mass : result) mass = m;
  return result;
}

std::vector<double> massesByArea(const std::vector<Vec3>& nodes, const std::vector<Triangle>& triangles,
                                 double density) {
  const auto weight = [&](const Triangle& t) {
    const Vec3 p = nodes[t[0]] - nodes[t[2]], q = nodes[t[1]] - nodes[t[2]];
    return density * 0.5 * p.cross(q).norm();
  };
  std::vector<double> result(nodes.size(), 0.0);
  for (const Triangle& t : triangles) {
    const double w = weight(t);
    for (const int i : t) result[i] += w / 3.0;
  }
  return result;
}
