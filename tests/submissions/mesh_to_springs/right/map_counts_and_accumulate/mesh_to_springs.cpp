#include "mesh_to_springs.h"

#include <map>
#include <numeric>

std::vector<Edge> meshEdges(const std::vector<Triangle>& triangles) {
  std::map<std::pair<int, int>, int> times;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) ++times[std::minmax({triangles[t][k], triangles[t][k == 2 ? 0 : k + 1]})];
  }
  std::vector<Edge> list;
  list.reserve(times.size());
  for (const auto& entry : times) list.push_back({entry.first.first, entry.first.second});
  return list;
}

std::vector<Edge> structuralSprings(int rows, int columns) {
  std::vector<Edge> springs;
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < columns; ++j) {
      const int node = i * columns + j;
      if (j + 1 < columns) springs.push_back({node, node + 1});
      if (i + 1 < rows) springs.push_back({node, node + columns});
    }
  }
  return springs;
}

std::vector<Edge> shearSprings(int rows, int columns) {
  std::vector<Edge> springs;
  for (int i = 0; i + 1 < rows; ++i) {
    for (int j = 0; j + 1 < columns; ++j) {
      const int node = i * columns + j;
      springs.push_back({node, node + columns + 1});
      springs.push_back({node + 1, node + columns});
    }
  }
  std::sort(springs.begin(), springs.end());
  return springs;
}

std::vector<Edge> bendingSprings(int rows, int columns) {
  std::vector<Edge> springs;
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < columns; ++j) {
      const int node = i * columns + j;
      if (j + 2 < columns) springs.push_back({node, node + 2});
      if (i + 2 < rows) springs.push_back({node, node + 2 * columns});
    }
  }
  return springs;
}

std::vector<double> restLengths(const std::vector<Vec3>& nodes, const std::vector<Edge>& edges) {
  std::vector<double> lengths;
  for (const Edge& edge : edges) lengths.push_back((nodes[edge[0]] - nodes[edge[1]]).norm());
  return lengths;
}

std::vector<double> equalMasses(double M, int n) {
  return std::vector<double>(n, M / n);
}

std::vector<double> massesByArea(const std::vector<Vec3>& nodes, const std::vector<Triangle>& triangles,
                                 double density) {
  std::vector<double> result;
  std::vector<std::vector<double>> shares(nodes.size());
  for (const Triangle& t : triangles) {
    const Vec3 ab = nodes[t[1]] - nodes[t[0]], bc = nodes[t[2]] - nodes[t[1]];
    for (int corner : t) shares[corner].push_back(ab.cross(bc).norm() / 6);
  }
  for (const auto& own : shares) result.push_back(density * std::accumulate(own.begin(), own.end(), 0.0));
  return result;
}
