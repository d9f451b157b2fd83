// loses: GridSprings; misconception: in_rows_only
#include "mesh_to_springs.h"

#include <unordered_set>

namespace {

using Key = long long;
constexpr Key shift = 1LL << 32;

Key keyOf(int a, int b) { return std::min(a, b) * shift + std::max(a, b); }

std::vector<Edge> edgesOf(const std::unordered_set<Key>& keys) {
  std::vector<Edge> edges;
  for (Key key : keys) edges.push_back({static_cast<int>(key / shift), static_cast<int>(key % shift)});
  std::sort(edges.begin(), edges.end());
  return edges;
}

}  // namespace

std::vector<Edge> meshEdges(const std::vector<Triangle>& triangles) {
  std::unordered_set<Key> keys;
  for (const Triangle& t : triangles)
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < i; ++j) keys.insert(keyOf(t[i], t[j]));
  return edgesOf(keys);
}

std::vector<Edge> structuralSprings(int rows, int columns) {
  std::unordered_set<Key> keys;
  for (int k = 0; k < rows * columns; ++k) {
    if (k % columns > 0) keys.insert(keyOf(k, k - 1));
    if (k >= columns) keys.insert(keyOf(k, k - columns));
  }
  return edgesOf(keys);
}

std::vector<Edge> shearSprings(int rows, int columns) {
  std::unordered_set<Key> keys;
  for (int k = columns; k < rows * columns; ++k) {
    if (k % columns > 0) keys.insert(keyOf(k, k - columns - 1));
    if (k % columns + 1 < columns) keys.insert(keyOf(k, k - columns + 1));
  }
  return edgesOf(keys);
}

std::vector<Edge> bendingSprings(int rows, int columns) {
  std::unordered_set<Key> keys;
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j + 2 < columns; ++j) keys.insert(keyOf(i * columns + j, i * columns + j + 2));
  return edgesOf(keys);
}

std::vector<double> restLengths(const std::vector<Vec3>& nodes, const std::vector<Edge>& edges) {
  std::vector<double> lengths;
  for (const Edge& e : edges) {
    const Vec3 r = nodes[e[1]] - nodes[e[0]];
    lengths.push_back(std::sqrt(r.dot(r)));
  }
  return lengths;
}

std::vector<double> equalMasses(double M, int n) {
  std::vector<double> shares(n, M);
  for (auto& share : shares) share /= n;
  return shares;
}

std::vector<double> massesByArea(const std::vector<Vec3>& nodes, const std::vector<Triangle>& triangles,
                                 double density) {
  std::vector<double> masses(nodes.size(), 0.0);
  for (const Triangle& t : triangles) {
    const Vec3 sideB = nodes[t[2]] - nodes[t[0]];
    const Vec3 sideC = nodes[t[1]] - nodes[t[0]];
    const Vec3 normal = sideC.cross(sideB);
    const double perNode = density * std::sqrt(normal.squaredNorm()) / 6.0;
    for (std::size_t c = 0; c < 3; ++c) masses[t[c]] += perNode;
  }
  return masses;
}
