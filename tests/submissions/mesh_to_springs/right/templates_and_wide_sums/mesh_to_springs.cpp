#include "mesh_to_springs.h"

#include <set>

namespace {

template <class Inside>
std::vector<Edge> pairsWhere(int rows, int columns, Inside isSpring) {
  std::vector<Edge> edges;
  const int reach = 2 * columns;  // no spring goes further
  for (int a = 0; a < rows * columns; ++a) {
    for (int b = a + 1; b <= std::min(a + reach, rows * columns - 1); ++b) {
      const int di = b / columns - a / columns;
      const int dj = std::abs(b % columns - a % columns);
      if (isSpring(di, dj)) edges.push_back({a, b});
    }
  }
  return edges;
}

}  // namespace

std::vector<Edge> meshEdges(const std::vector<Triangle>& triangles) {
  std::set<Edge> edges;
  const std::size_t next[3] = {1, 2, 0};
  for (const Triangle& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      Edge e{t[k], t[next[k]]};
      std::sort(e.begin(), e.end());
      edges.insert(e);
    }
  }
  return {edges.begin(), edges.end()};
}

std::vector<Edge> structuralSprings(int rows, int columns) {
  return pairsWhere(rows, columns, [](int di, int dj) { return di + dj == 1; });
}

std::vector<Edge> shearSprings(int rows, int columns) {
  return pairsWhere(rows, columns, [](int di, int dj) { return di == 1 && dj == 1; });
}

std::vector<Edge> bendingSprings(int rows, int columns) {
  return pairsWhere(rows, columns, [](int di, int dj) { return (di == 2 && dj == 0) || (di == 0 && dj == 2); });
}

std::vector<double> restLengths(const std::vector<Vec3>& nodes, const std::vector<Edge>& edges) {
  std::vector<double> lengths;
  for (const Edge& e : edges) {
    long double sum = 0.0L;
    for (int k = 0; k < 3; ++k) {
      const long double d = static_cast<long double>(nodes[e[0]][k]) - nodes[e[1]][k];
      sum += d * d;
    }
    lengths.push_back(static_cast<double>(std::sqrt(sum)));
  }
  return lengths;
}

std::vector<double> equalMasses(double M, int n) {
  return n > 0 ? std::vector<double>(n, M / n) : std::vector<double>{};
}

std::vector<double> massesByArea(const std::vector<Vec3>& nodes, const std::vector<Triangle>& triangles,
                                 double density) {
  std::vector<long double> sums(nodes.size(), 0.0L);
  for (const auto& [a, b, c] : triangles) {
    const Vec3 cross = (nodes[a] - nodes[b]).cross(nodes[c] - nodes[b]);
    const long double share = static_cast<long double>(density) * cross.norm() / 6.0L;
    sums[a] += share;
    sums[b] += share;
    sums[c] += share;
  }
  return std::vector<double>(sums.begin(), sums.end());
}
