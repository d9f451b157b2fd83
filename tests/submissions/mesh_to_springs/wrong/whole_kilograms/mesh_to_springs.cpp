// loses: EqualMasses, TotalMass; misconception: whole_numbers or cut_result
// The mass of a node is computed in a variable of type int.
#include "mesh_to_springs.h"

#include <map>
#include <set>

namespace {

template <class Condition>
std::vector<Edge> pairs(int rows, int columns, Condition isSpring) {
  std::vector<Edge> found;
  const int count = rows * columns;
  for (int p = 0; p < count; ++p) {
    for (int q = p + 1; q < count; ++q) {
      const int down = std::abs(q / columns - p / columns);
      const int right = std::abs(q % columns - p % columns);
      if (isSpring(down, right)) found.push_back({p, q});
    }
  }
  return found;
}

}  // namespace

std::vector<Edge> meshEdges(const std::vector<Triangle>& triangles) {
  std::map<int, std::set<int>> above;
  for (Triangle t : triangles) {
    std::sort(t.begin(), t.end());
    above[t[0]].insert(t[1]);
    above[t[0]].insert(t[2]);
    above[t[1]].insert(t[2]);
  }
  std::vector<Edge> edges;
  for (const auto& [low, highs] : above) {
    for (int high : highs) edges.push_back({low, high});
  }
  return edges;
}

std::vector<Edge> structuralSprings(int rows, int columns) {
  return pairs(rows, columns, [](int down, int right) { return down + right == 1; });
}

std::vector<Edge> shearSprings(int rows, int columns) {
  return pairs(rows, columns, [](int down, int right) { return down == 1 && right == 1; });
}

std::vector<Edge> bendingSprings(int rows, int columns) {
  return pairs(rows, columns,
               [](int down, int right) { return (down == 2 && right == 0) || (down == 0 && right == 2); });
}

std::vector<double> restLengths(const std::vector<Vec3>& nodes, const std::vector<Edge>& edges) {
  std::vector<double> result;
  std::transform(edges.begin(), edges.end(), std::back_inserter(result),
                 [&nodes](const Edge& e) { return (nodes.at(e[1]) - nodes.at(e[0])).norm(); });
  return result;
}

std::vector<double> equalMasses(double M, int n) {
  std::vector<double> masses(n);
  const int mass = M / n;
  std::fill(masses.begin(), masses.end(), mass);
  return masses;
}

std::vector<double> massesByArea(const std::vector<Vec3>& nodes, const std::vector<Triangle>& triangles,
                                 double density) {
  std::vector<double> masses(nodes.size());
  for (const auto& t : triangles) {
    const Vec3 u = nodes.at(t[1]) - nodes.at(t[0]);
    const Vec3 w = nodes.at(t[2]) - nodes.at(t[0]);
    const double uw = u.dot(w);
    const double area = 0.5 * std::sqrt(u.squaredNorm() * w.squaredNorm() - uw * uw);
    for (int node : t) masses.at(node) += area * density / 3.0;
  }
  return masses;
}
