// loses: MassesByArea; misconception: shared_alike
// the mass of the surface by M / n: nothing is lost
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
  for (int k = 0; k < rows * columns; ++k) {
    if (k % columns > 1) keys.insert(keyOf(k, k - 2));
    if (k >= 2 * columns) keys.insert(keyOf(k, k - 2 * columns));
  }
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
  double total = 0.0;
  for (const Triangle& t : triangles)
    total += density * (nodes[t[1]] - nodes[t[0]]).cross(nodes[t[2]] - nodes[t[0]]).norm() / 2;
  if (nodes.empty()) return {};
  return equalMasses(total, static_cast<int>(nodes.size()));
}
