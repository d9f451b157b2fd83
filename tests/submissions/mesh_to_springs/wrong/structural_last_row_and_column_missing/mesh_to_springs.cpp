// loses: GridSprings; misconception: last_row_and_column
// both loops stop one before the end
#include "mesh_to_springs.h"

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
  std::vector<Edge> out;
  // each edge goes to its place, if it is not there yet
  const auto add = [&out](int a, int b) {
    const Edge e = {std::min(a, b), std::max(a, b)};
    const auto place = std::lower_bound(out.begin(), out.end(), e);
    if (place == out.end() || *place != e) out.insert(place, e);
  };
  for (const Triangle& t : triangles) {
    add(t[0], t[1]);
    add(t[0], t[2]);
    add(t[1], t[2]);
  }
  return out;
}

std::vector<Edge> structuralSprings(int rows, int columns) {
  std::vector<Edge> out;
  for (int i = 0; i < rows - 1; ++i) {
    for (int j = 0; j < columns - 1; ++j) {
      const int a = i * columns + j;
      out.push_back({a, a + 1});
      out.push_back({a, a + columns});
    }
  }
  return out;
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
