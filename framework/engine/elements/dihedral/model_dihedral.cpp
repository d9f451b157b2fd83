#include "engine/elements/dihedral/model_dihedral.h"

#include "engine/elements/dihedral/dihedral.h"
#include "engine/model/builder.h"

#include <fmt/format.h>
#include <algorithm>
#include <Eigen/Geometry>

namespace muelle::engine {

void ModelDihedral::addTo(Builder& builder, const std::vector<ModelDihedral>& dihedrals) {
  addElements<3, Dihedral>(builder, dihedrals, [](const ModelDihedral& e, const std::array<int, 4>& nodes) {
    return Dihedral{nodes, e.k, e.theta0};
  });
}

std::optional<ElementSingularity> ModelDihedral::singularity(int /*dimension*/, const std::vector<Vec3>& places) const {
  const auto fromA = [&](std::size_t i) {
    return Vec3(places[static_cast<std::size_t>(nodes[i])] - places[static_cast<std::size_t>(nodes[0])]);
  };
  const Vec3 e = fromA(1), p = fromA(2), q = fromA(3);
  const Vec3 first = e.cross(p), second = q.cross(e);  // normals, equal when flat
  const double size = std::max({e.squaredNorm(), p.squaredNorm(), q.squaredNorm()});
  const std::string edge = fmt::format("at the edge of nodes {} and {}", nodes[0], nodes[1]);
  if (std::min(first.norm(), second.norm()) <= singularCloseness * size) {
    return ElementSingularity{Singularity::WithoutSize, edge + " has a triangle without area: it is no angle"};
  }
  const bool isFlat = first.cross(second).norm() <= singularCloseness * first.norm() * second.norm();
  if (!isFlat || first.dot(second) >= 0.0) return std::nullopt;
  return ElementSingularity{Singularity::Folded, edge + " is folded back onto itself: it has no side to open to"};
}

}  // namespace muelle::engine
