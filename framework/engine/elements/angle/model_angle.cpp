#include "engine/elements/angle/model_angle.h"

#include "engine/elements/angle/angle.h"
#include "engine/model/builder.h"

#include <fmt/format.h>
#include <algorithm>
#include <Eigen/Geometry>

namespace muelle::engine {

namespace {

template <int D>
void addIn(Builder& builder, const std::vector<ModelAngle>& angles) {
  addElements<D, Angle<D>>(builder, angles, [](const ModelAngle& e, const std::array<int, 3>& nodes) {
    return Angle<D>{nodes, e.k, e.theta0};
  });
}

}  // namespace

void ModelAngle::addTo(Builder& builder, const std::vector<ModelAngle>& angles) {
  builder.dimension() == 2 ? addIn<2>(builder, angles) : addIn<3>(builder, angles);
}

std::optional<ElementSingularity> ModelAngle::singularity(int dimension, const std::vector<Vec3>& places) const {
  const auto at = [&](std::size_t i) { return places[static_cast<std::size_t>(nodes[i])]; };
  const Vec3 in = at(1) - at(0), out = at(2) - at(1);
  const double longer = std::max(in.norm(), out.norm());
  const std::string corner = fmt::format("at node {}", nodes[1]);
  if (std::min(in.norm(), out.norm()) <= singularCloseness * longer) {
    return ElementSingularity{Singularity::WithoutSize, corner + " has an edge without length: it is no angle"};
  }
  if (in.cross(out).norm() > singularCloseness * in.norm() * out.norm()) return std::nullopt;
  if (in.dot(out) < 0.0) {
    return ElementSingularity{Singularity::Folded, corner + " is folded back onto itself: it has no side to open to"};
  }
  if (dimension == 2 || theta0 == 0.0) return std::nullopt;
  return ElementSingularity{
      Singularity::Straight,
      fmt::format("{} is straight and wants {:.3g} rad: it has no side to bend to", corner, theta0)};
}

}  // namespace muelle::engine
