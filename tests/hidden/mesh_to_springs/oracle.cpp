/// \file
/// The expected values, by other ways than the usual one: neighbours of each node in place of a set of pairs, all pairs
/// of a grid's nodes in place of loops over its cells, areas by the sides' scalar products.

#include "mesh_to_springs.h"

#include <map>
#include <set>

namespace {

std::size_t place(int i) { return static_cast<std::size_t>(i); }

/// Pairs of nodes of a grid whose rows and columns are so far apart, either way.
std::vector<Edge> pairsApart(int rows, int columns, std::set<std::pair<int, int>> apart) {
  std::vector<Edge> pairs;
  for (int p = 0; p < rows * columns; ++p) {
    const int last = std::min(rows * columns - 1, p + 2 * columns);  // no spring reaches further
    for (int q = p + 1; q <= last; ++q) {
      const std::pair way(q / columns - p / columns, std::abs(q % columns - p % columns));
      if (apart.contains(way)) pairs.push_back({p, q});
    }
  }
  return pairs;
}

/// Area of a triangle by the sides from its first corner: |u x v|^2 = u^2 v^2 - (u . v)^2, with v made perpendicular
/// to u first, so that nothing cancels.
double areaOf(const Vec3& u, const Vec3& v) {
  const Vec3 height = v - u.dot(v) / u.squaredNorm() * u;
  return std::sqrt(u.squaredNorm() * height.squaredNorm()) / 2;
}

}  // namespace

namespace oracle {

std::vector<Edge> meshEdges(const std::vector<Triangle>& triangles) {
  std::map<int, std::set<int>> above;  // of each node its neighbours of higher number
  for (const Triangle& t : triangles) {
    for (const int i : t) {
      for (const int j : t) {
        if (i < j) above[i].insert(j);
      }
    }
  }
  std::vector<Edge> edges;
  for (const auto& [i, neighbours] : above) {
    for (const int j : neighbours) edges.push_back({i, j});
  }
  return edges;
}

std::vector<Edge> structuralSprings(int rows, int columns) { return pairsApart(rows, columns, {{0, 1}, {1, 0}}); }
std::vector<Edge> shearSprings(int rows, int columns) { return pairsApart(rows, columns, {{1, 1}}); }
std::vector<Edge> bendingSprings(int rows, int columns) { return pairsApart(rows, columns, {{0, 2}, {2, 0}}); }

std::vector<double> restLengths(const std::vector<Vec3>& nodes, const std::vector<Edge>& edges) {
  std::vector<double> lengths;
  for (const auto& [a, b] : edges) {
    const Vec3 apart = nodes.at(place(b)) - nodes.at(place(a));
    lengths.push_back(std::hypot(apart[0], apart[1], apart[2]));
  }
  return lengths;
}

std::vector<double> equalMasses(double M, int n) {
  std::vector<double> masses;
  for (int i = 0; i < n; ++i) masses.push_back(M / n);
  return masses;
}

std::vector<double> massesByArea(const std::vector<Vec3>& nodes, const std::vector<Triangle>& triangles,
                                 double density) {
  std::vector<double> areas(nodes.size());
  for (const auto& [a, b, c] : triangles) {
    const Vec3 u = nodes.at(place(b)) - nodes.at(place(a));
    const double area = areaOf(u, nodes.at(place(c)) - nodes.at(place(a)));
    if (!(area > 0)) throw std::out_of_range("a triangle without area is not of the contract");
    for (const int i : {a, b, c}) areas[place(i)] += area;
  }
  for (double& area : areas) area *= density / 3;
  return areas;
}

}  // namespace oracle
