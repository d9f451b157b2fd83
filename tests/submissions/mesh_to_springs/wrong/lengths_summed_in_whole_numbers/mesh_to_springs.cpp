// loses: RestLengths; misconception: whole_numbers or integer_division
// inner_product starts from the int 0
#include "mesh_to_springs.h"

#include <numeric>

namespace {

// for every node those of its neighbours that have a larger number
using Neighbours = std::vector<std::vector<int>>;

void join(Neighbours& above, int a, int b) {
  const int low = std::min(a, b), high = std::max(a, b);
  if (static_cast<int>(above.size()) <= low) above.resize(low + 1);
  std::vector<int>& list = above[low];
  if (std::find(list.begin(), list.end(), high) == list.end()) list.push_back(high);
}

std::vector<Edge> flatten(Neighbours above) {
  std::vector<Edge> edges;
  for (int a = 0; a < static_cast<int>(above.size()); ++a) {
    std::sort(above[a].begin(), above[a].end());
    for (int b : above[a]) edges.push_back({a, b});
  }
  return edges;
}

}  // namespace

std::vector<Edge> meshEdges(const std::vector<Triangle>& triangles) {
  Neighbours above;
  for (const Triangle& t : triangles) {
    join(above, t[0], t[1]);
    join(above, t[1], t[2]);
    join(above, t[2], t[0]);
  }
  return flatten(above);
}

std::vector<Edge> structuralSprings(int rows, int columns) {
  Neighbours above;
  for (int node = 0; node < rows * columns; ++node) {
    const int i = node / columns, j = node % columns;
    if (j != columns - 1) join(above, node, node + 1);
    if (i != rows - 1) join(above, node, node + columns);
  }
  return flatten(above);
}

std::vector<Edge> shearSprings(int rows, int columns) {
  Neighbours above;
  for (int node = 0; node < rows * columns; ++node) {
    const int i = node / columns, j = node % columns;
    if (i == rows - 1) continue;
    if (j != 0) join(above, node, node + columns - 1);
    if (j != columns - 1) join(above, node, node + columns + 1);
  }
  return flatten(above);
}

std::vector<Edge> bendingSprings(int rows, int columns) {
  Neighbours above;
  for (int node = 0; node < rows * columns; ++node) {
    const int i = node / columns, j = node % columns;
    if (j < columns - 2) join(above, node, node + 2);
    if (i < rows - 2) join(above, node, node + 2 * columns);
  }
  return flatten(above);
}

std::vector<double> restLengths(const std::vector<Vec3>& nodes, const std::vector<Edge>& edges) {
  std::vector<double> L0;
  for (const auto& [a, b] : edges) {
    const Vec3 d = nodes[b] - nodes[a];
    L0.push_back(std::sqrt(std::inner_product(d.begin(), d.end(), d.begin(), 0)));
  }
  return L0;
}

std::vector<double> equalMasses(double M, int n) {
  std::vector<double> masses;
  const double each = M / static_cast<double>(n);
  for (int i = 0; i < n; ++i) masses.push_back(each);
  return masses;
}

std::vector<double> massesByArea(const std::vector<Vec3>& nodes, const std::vector<Triangle>& triangles,
                                 double density) {
  // first the triangles, then the nodes
  std::vector<double> share;
  for (const Triangle& t : triangles) {
    const Vec3 ab = nodes[t[1]] - nodes[t[0]];
    const Vec3 bc = nodes[t[2]] - nodes[t[1]];
    share.push_back(ab.cross(bc).norm() / 2 * density / 3);
  }
  std::vector<double> masses(nodes.size(), 0.0);
  for (std::size_t k = 0; k < triangles.size(); ++k)
    for (int corner = 0; corner < 3; ++corner) masses[triangles[k][corner]] += share[k];
  return masses;
}
