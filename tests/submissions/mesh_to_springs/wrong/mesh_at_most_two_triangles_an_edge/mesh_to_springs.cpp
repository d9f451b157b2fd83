// loses: MeshEdges, EachEdgeOnce; misconception: shared_edges_twice or pairs_only
// after a pair the next is taken for another edge: three triangles at an edge give it twice
#include "mesh_to_springs.h"

namespace {

Edge edge(int a, int b) { return a < b ? Edge{a, b} : Edge{b, a}; }

std::vector<Edge> tidy(std::vector<Edge> list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
  return list;
}

}  // namespace

std::vector<Edge> meshEdges(const std::vector<Triangle>& triangles) {
  std::vector<Edge> all;
  for (const auto& [a, b, c] : triangles) {
    all.push_back(edge(a, b));
    all.push_back(edge(b, c));
    all.push_back(edge(c, a));
  }
  std::sort(all.begin(), all.end());
  std::vector<Edge> list;
  for (std::size_t i = 0; i < all.size(); ++i) {
    list.push_back(all[i]);
    if (i + 1 < all.size() && all[i + 1] == all[i]) ++i;  // the other triangle
  }
  return list;
}

std::vector<Edge> structuralSprings(int rows, int columns) {
  std::vector<Edge> list;
  for (int i = 0; i < rows; ++i)
    for (int j = 1; j < columns; ++j) list.push_back(edge(i * columns + j - 1, i * columns + j));
  for (int i = 1; i < rows; ++i)
    for (int j = 0; j < columns; ++j) list.push_back(edge((i - 1) * columns + j, i * columns + j));
  return tidy(list);
}

std::vector<Edge> shearSprings(int rows, int columns) {
  std::vector<Edge> list;
  for (int i = 1; i < rows; ++i) {
    for (int j = 1; j < columns; ++j) {
      const int corner = i * columns + j;
      list.push_back(edge(corner, corner - columns - 1));
      list.push_back(edge(corner - 1, corner - columns));
    }
  }
  return tidy(list);
}

std::vector<Edge> bendingSprings(int rows, int columns) {
  std::vector<Edge> list;
  for (int i = 0; i < rows; ++i)
    for (int j = 2; j < columns; ++j) list.push_back(edge(i * columns + j - 2, i * columns + j));
  for (int i = 2; i < rows; ++i)
    for (int j = 0; j < columns; ++j) list.push_back(edge((i - 2) * columns + j, i * columns + j));
  return tidy(list);
}

std::vector<double> restLengths(const std::vector<Vec3>& nodes, const std::vector<Edge>& edges) {
  std::vector<double> lengths(edges.size());
  std::transform(edges.begin(), edges.end(), lengths.begin(), [&nodes](const Edge& e) {
    const Vec3 d = nodes.at(e[0]) - nodes.at(e[1]);
    return std::hypot(d.x(), d.y(), d.z());
  });
  return lengths;
}

std::vector<double> equalMasses(double M, int n) {
  std::vector<double> masses(n);
  std::fill(masses.begin(), masses.end(), M / n);
  return masses;
}

std::vector<double> massesByArea(const std::vector<Vec3>& nodes, const std::vector<Triangle>& triangles,
                                 double density) {
  std::vector<double> masses(nodes.size());
  for (const auto& [a, b, c] : triangles) {
    const Vec3 u = nodes.at(b) - nodes.at(a), w = nodes.at(c) - nodes.at(a);
    const double nx = u.y() * w.z() - u.z() * w.y();
    const double ny = u.z() * w.x() - u.x() * w.z();
    const double nz = u.x() * w.y() - u.y() * w.x();
    const double share = density * std::hypot(nx, ny, nz) / 6;
    for (int node : {a, b, c}) masses.at(node) += share;
  }
  return masses;
}
