// loses: MeshEdges, EulersFormula; misconception: threshold or constant_argument or keys_too_small
// 1000 a + b: right as long as no node has a number above 999
#include "mesh_to_springs.h"

#include <set>

namespace {

/// From each node to the ones at `steps` (rows down, columns to the right), which must be in ascending order.
std::vector<Edge> gridSprings(int rows, int columns, const std::vector<std::pair<int, int>>& steps) {
  std::vector<Edge> out;
  for (int row = 0; row < rows; ++row) {
    for (int col = 0; col < columns; ++col) {
      for (const auto& [down, right] : steps) {
        const int r = row + down, c = col + right;
        if (r >= rows || c < 0 || c >= columns) continue;
        out.push_back({row * columns + col, r * columns + c});
      }
    }
  }
  return out;
}

}  // namespace

std::vector<Edge> meshEdges(const std::vector<Triangle>& triangles) {
  std::set<int> keys;  // 1000 a + b
  for (const Triangle& t : triangles) {
    for (int k = 0; k < 3; ++k) {
      const int p = t[k], q = t[(k + 1) % 3];
      keys.insert(1000 * std::min(p, q) + std::max(p, q));
    }
  }
  std::vector<Edge> out;
  for (int key : keys) out.push_back({key / 1000, key % 1000});
  return out;
}

std::vector<Edge> structuralSprings(int rows, int columns) {
  // with a single column both steps cannot be there at once, so the order holds
  return gridSprings(rows, columns, {{0, 1}, {1, 0}});
}

std::vector<Edge> shearSprings(int rows, int columns) {
  return gridSprings(rows, columns, {{1, -1}, {1, 1}});
}

std::vector<Edge> bendingSprings(int rows, int columns) {
  return gridSprings(rows, columns, {{0, 2}, {2, 0}});
}

std::vector<double> restLengths(const std::vector<Vec3>& nodes, const std::vector<Edge>& edges) {
  std::vector<double> out(edges.size(), 0.0);
  for (std::size_t s = 0; s != edges.size(); ++s) {
    out[s] = (nodes[edges[s].front()] - nodes[edges[s].back()]).stableNorm();
  }
  return out;
}

std::vector<double> equalMasses(double M, int n) {
  std::vector<double> out;
  out.assign(n, M / n);
  return out;
}

std::vector<double> massesByArea(const std::vector<Vec3>& nodes, const std::vector<Triangle>& triangles,
                                 double density) {
  std::vector<double> area(nodes.size(), 0.0);  // of the triangles around a node
  for (const auto& [a, b, c] : triangles) {
    const double A = (nodes[b] - nodes[a]).cross(nodes[c] - nodes[a]).norm() / 2.0;
    area[a] += A, area[b] += A, area[c] += A;
  }
  for (double& a : area) a *= density / 3.0;
  return area;
}
