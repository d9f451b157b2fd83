#include "harness/mesh.h"

#include <fmt/format.h>
#include <cmath>
#include <stdexcept>

namespace muelle {

namespace {

void requirePositive(const char* generator, const char* what, double value) {
  if (value > 0.0 && std::isfinite(value)) return;
  throw std::invalid_argument(fmt::format("{}: {} is {}; it must be positive and finite", generator, what, value));
}

void requireMaterial(const char* generator, const Material& material) {
  requirePositive(generator, "the total mass M", material.M);
  requirePositive(generator, "the stiffness k", material.k);
}

void requireAtLeast(const char* generator, const char* what, int value, int least) {
  if (value >= least) return;
  throw std::invalid_argument(fmt::format("{}: {} is {}; it must be at least {}", generator, what, value, least));
}

/// Two nodes of a spring at one point have no direction between them; not finite positions have no distance.
void requireApart(const char* generator, const char* pair, const Vec3& a, const Vec3& b) {
  const double distance = (a - b).norm();
  if (distance > 0.0 && std::isfinite(distance)) return;
  throw std::invalid_argument(
      fmt::format("{}: {} are {} m apart; the distance must be positive and finite", generator, pair, distance));
}

void lumpMass(Mesh& mesh, double M) {
  for (Node& node : mesh.nodes) node.m = M / static_cast<double>(mesh.nodes.size());
}

/// A spring between nodes a and b, at rest where they are.
void connect(Mesh& mesh, int a, int b, double k) {
  const Vec3& xa = mesh.nodes[static_cast<std::size_t>(a)].x;
  const Vec3& xb = mesh.nodes[static_cast<std::size_t>(b)].x;
  mesh.springs.push_back({a, b, k, (xa - xb).norm()});
}

Mesh nodesAt(std::initializer_list<Vec3> positions) {
  Mesh mesh;
  for (const Vec3& x : positions) {
    Node node;
    node.x = x;
    mesh.nodes.push_back(node);
  }
  return mesh;
}

}  // namespace

Mesh chain(int n, const Vec3& start, const Vec3& end, const Material& material) {
  requireAtLeast("chain", "n", n, 2);
  requireMaterial("chain", material);
  requireApart("chain", "start and end", start, end);
  Mesh mesh;
  mesh.nodes.resize(static_cast<std::size_t>(n));
  for (int i = 0; i < n; ++i) {
    const double s = static_cast<double>(i) / (n - 1);
    mesh.nodes[static_cast<std::size_t>(i)].x = (1.0 - s) * start + s * end;
  }
  lumpMass(mesh, material.M);
  for (int i = 0; i + 1 < n; ++i) connect(mesh, i, i + 1, material.k);
  return mesh;
}

Mesh grid(int nx, int ny, double spacing, bool shear, const Material& material) {
  requireAtLeast("grid", "nx", nx, 2);
  requireAtLeast("grid", "ny", ny, 2);
  requirePositive("grid", "the spacing", spacing);
  requireMaterial("grid", material);
  Mesh mesh;
  mesh.nodes.resize(static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny));
  const auto index = [nx](int i, int j) { return j * nx + i; };
  for (int j = 0; j < ny; ++j) {
    for (int i = 0; i < nx; ++i) mesh.nodes[static_cast<std::size_t>(index(i, j))].x = Vec3(i, j, 0) * spacing;
  }
  lumpMass(mesh, material.M);
  for (int j = 0; j < ny; ++j) {
    for (int i = 0; i < nx; ++i) {
      if (i + 1 < nx) connect(mesh, index(i, j), index(i + 1, j), material.k);
      if (j + 1 < ny) connect(mesh, index(i, j), index(i, j + 1), material.k);
      if (!shear || i + 1 == nx || j + 1 == ny) continue;
      connect(mesh, index(i, j), index(i + 1, j + 1), material.k);
      connect(mesh, index(i + 1, j), index(i, j + 1), material.k);
    }
  }
  return mesh;
}

Mesh triangle(const Vec3& x0, const Vec3& x1, const Vec3& x2, const Material& material) {
  requireMaterial("triangle", material);
  requireApart("triangle", "corners 0 and 1", x0, x1);
  requireApart("triangle", "corners 1 and 2", x1, x2);
  requireApart("triangle", "corners 2 and 0", x2, x0);
  Mesh mesh = nodesAt({x0, x1, x2});
  lumpMass(mesh, material.M);
  connect(mesh, 0, 1, material.k);
  connect(mesh, 1, 2, material.k);
  connect(mesh, 2, 0, material.k);
  return mesh;
}

}  // namespace muelle
