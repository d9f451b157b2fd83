#include "engine/scene/generators.h"
#include "engine/scene/joined_sets.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <stdexcept>

namespace muelle::engine {

namespace {

using Cell = std::array<int, 3>;  // indices of a lattice point

constexpr double mostPoints = 1e6;      // of the lattice in the surface's box
constexpr double leastDistance = 0.35;  // of the spacing, from an inner node to a vertex: shorter springs are stiffer
                                        // than all others and would set the step

struct InnerNode {
  Cell cell;
  Vec3 x;
};

std::pair<Vec3, Vec3> boundingBox(const std::vector<Vec3>& points) {
  Vec3 least = points.front();
  Vec3 most = points.front();
  for (const Vec3& x : points) {
    least = least.cwiseMin(x);
    most = most.cwiseMax(x);
  }
  return {least, most};
}

bool isNearVertex(const SurfaceMesh& mesh, const Vec3& x, double distance) {
  return std::ranges::any_of(mesh.vertices, [&](const Vec3& v) { return (v - x).squaredNorm() < distance * distance; });
}

/// The lattice's points inside the surface; its middle is the middle of the surface's box.
std::vector<InnerNode> pointsInside(const LatticeShape& shape) {
  const auto [least, most] = boundingBox(shape.mesh.vertices);
  const Vec3 counts = ((most - least) / shape.spacing).array().floor();
  if (!(counts.prod() <= mostPoints)) {
    throw std::invalid_argument(fmt::format("a spacing of {} m makes more than {:.0f} lattice points; make it larger",
                                            shape.spacing, mostPoints));
  }
  const Vec3 first = 0.5 * (least + most) - 0.5 * shape.spacing * counts;
  std::vector<InnerNode> inside;
  for (int k = 0; k <= static_cast<int>(counts[2]); ++k) {
    for (int j = 0; j <= static_cast<int>(counts[1]); ++j) {
      for (int i = 0; i <= static_cast<int>(counts[0]); ++i) {
        const Vec3 x = first + shape.spacing * Vec3(i, j, k);
        if (windingNumber(shape.mesh, x) <= 0.5 || isNearVertex(shape.mesh, x, leastDistance * shape.spacing)) continue;
        inside.push_back({{i, j, k}, x});
      }
    }
  }
  return inside;
}

void addSpring(Model& model, int a, int b, const SpringMaterial& material, int part) {
  const double L0 = (model.nodes[static_cast<std::size_t>(a)].x - model.nodes[static_cast<std::size_t>(b)].x).norm();
  model.springs.push_back({.a = a,
                           .b = b,
                           .k = material.k,
                           .L0 = L0,
                           .dRelative = material.dRelative,
                           .dProjected = material.dProjected,
                           .part = part});
}

/// Springs to the 13 neighbours that come later in the order of the cells: each pair once.
void joinLattice(Model& model, const std::vector<InnerNode>& inner, int firstInner, const SpringMaterial& material,
                 int part) {
  std::map<Cell, int> indexOf;
  for (std::size_t i = 0; i < inner.size(); ++i) indexOf[inner[i].cell] = firstInner + static_cast<int>(i);
  for (const InnerNode& node : inner) {
    for (int step = 14; step < 27; ++step) {
      const Cell next = {node.cell[0] + step % 3 - 1, node.cell[1] + step / 3 % 3 - 1, node.cell[2] + step / 9 - 1};
      const auto found = indexOf.find(next);
      if (found != indexOf.end()) addSpring(model, indexOf[node.cell], found->second, material, part);
    }
  }
}

/// The `count` inner nodes nearest to a point, nearest first.
std::vector<int> nearestInner(const std::vector<InnerNode>& inner, const Vec3& x, int count) {
  std::vector<int> order(inner.size());
  std::iota(order.begin(), order.end(), 0);
  const auto distance = [&](int i) { return (inner[static_cast<std::size_t>(i)].x - x).squaredNorm(); };
  const auto end = order.begin() + std::min<std::ptrdiff_t>(count, static_cast<std::ptrdiff_t>(order.size()));
  std::ranges::partial_sort(order, end, {}, distance);
  order.erase(end, order.end());
  return order;
}

/// Throws when some node cannot be reached from the first along springs.
void requireConnected(const Model& model, const Part& part) {
  JoinedSets sets(part.nodeCount);
  for (const ModelSpring& spring : model.springs) {
    if (spring.a >= part.firstNode) sets.join(spring.a - part.firstNode, spring.b - part.firstNode);
  }
  for (int i = 1; i < part.nodeCount; ++i) {
    if (sets.of(i) == sets.of(0)) continue;
    throw std::invalid_argument(
        fmt::format("the solid is in pieces: no springs lead from its node 0 to node {}; make the spacing smaller", i));
  }
}

}  // namespace

Part addLattice(Model& model, const LatticeShape& shape, const std::string& name) {
  Part part = addShell(model, {shape.mesh, shape.spring}, name);
  const std::vector<InnerNode> inner = pointsInside(shape);
  if (inner.empty()) {
    throw std::invalid_argument(
        fmt::format("no lattice point lies inside the surface at a spacing of {} m; make it smaller (or the triangles "
                    "face inwards)",
                    shape.spacing));
  }
  const int firstInner = part.firstNode + part.nodeCount;
  for (const InnerNode& node : inner) {
    ModelNode added;
    added.x = node.x;
    model.nodes.push_back(added);
  }
  joinLattice(model, inner, firstInner, shape.spring, partNamed(model, name + ".lattice"));
  const int ties = partNamed(model, name + ".ties");
  for (int i = 0; i < part.nodeCount; ++i) {
    const Vec3 x = shape.mesh.vertices[static_cast<std::size_t>(i)];
    for (const int j : nearestInner(inner, x, shape.ties)) {
      addSpring(model, part.firstNode + i, firstInner + j, shape.spring, ties);
    }
  }
  part.nodeCount += static_cast<int>(inner.size());
  part.measure = signedVolume(shape.mesh);
  requireConnected(model, part);
  return part;
}

}  // namespace muelle::engine
