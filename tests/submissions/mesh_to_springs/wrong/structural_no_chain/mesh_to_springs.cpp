// loses: GridSprings; misconception: threshold or no_chain
// one row or one column is no cloth: nothing is returned
#include "mesh_to_springs.h"

namespace {

/// Which node is joined with which: a square table.
class Joined {
 public:
  explicit Joined(int n) : n_(n), table_(static_cast<std::size_t>(n) * n, false) {}
  void join(int a, int b) { table_[static_cast<std::size_t>(std::min(a, b)) * n_ + std::max(a, b)] = true; }
  std::vector<Edge> list() const {
    std::vector<Edge> edges;
    for (int a = 0; a < n_; ++a)
      for (int b = a + 1; b < n_; ++b)
        if (table_[static_cast<std::size_t>(a) * n_ + b]) edges.push_back({a, b});
    return edges;
  }

 private:
  int n_;
  std::vector<bool> table_;
};

}  // namespace

std::vector<Edge> meshEdges(const std::vector<Triangle>& triangles) {
  int last = -1;
  for (const Triangle& t : triangles) last = std::max({last, t[0], t[1], t[2]});
  Joined joined(last + 1);
  for (const Triangle& t : triangles) {
    joined.join(t[0], t[1]);
    joined.join(t[1], t[2]);
    joined.join(t[2], t[0]);
  }
  return joined.list();
}

std::vector<Edge> structuralSprings(int rows, int columns) {
  if (rows < 2 || columns < 2) return {};  // no grid
  Joined joined(rows * columns);
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < columns; ++j) {
      if (j + 1 < columns) joined.join(i * columns + j, i * columns + (j + 1));
      if (i + 1 < rows) joined.join(i * columns + j, (i + 1) * columns + j);
    }
  }
  return joined.list();
}

std::vector<Edge> shearSprings(int rows, int columns) {
  Joined joined(rows * columns);
  for (int i = 0; i + 1 < rows; ++i) {
    for (int j = 0; j + 1 < columns; ++j) {
      joined.join(i * columns + j, (i + 1) * columns + j + 1);
      joined.join((i + 1) * columns + j, i * columns + j + 1);
    }
  }
  return joined.list();
}

std::vector<Edge> bendingSprings(int rows, int columns) {
  Joined joined(rows * columns);
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < columns; ++j) {
      if (i >= 2) joined.join((i - 2) * columns + j, i * columns + j);
      if (j >= 2) joined.join(i * columns + j - 2, i * columns + j);
    }
  }
  return joined.list();
}

std::vector<double> restLengths(const std::vector<Vec3>& nodes, const std::vector<Edge>& edges) {
  std::vector<double> lengths;
  for (const auto& e : edges) {
    const Vec3 &a = nodes[e[0]], &b = nodes[e[1]];
    lengths.push_back((a - b).norm());
  }
  return lengths;
}

std::vector<double> equalMasses(double M, int n) {
  std::vector<double> masses(n);
  std::generate(masses.begin(), masses.end(), [=] { return M / n; });
  return masses;
}

std::vector<double> massesByArea(const std::vector<Vec3>& nodes, const std::vector<Triangle>& triangles,
                                 double density) {
  std::vector<double> masses(nodes.size());
  // node by node and corner by corner: every triangle comes three times, from each of its corners
  for (int corner = 0; corner < 3; ++corner) {
    for (const Triangle& t : triangles) {
      const Vec3& p = nodes[t[corner]];
      const Vec3& q = nodes[t[(corner + 1) % 3]];
      const Vec3& r = nodes[t[(corner + 2) % 3]];
      masses[t[corner]] += density * (0.5 * (q - p).cross(r - p).norm()) / 3;
    }
  }
  return masses;
}
