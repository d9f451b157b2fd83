#include "engine/elements/area/model_area.h"

#include "engine/elements/area/area.h"
#include "engine/elements/cross_matrix.h"
#include "engine/model/builder.h"
#include "engine/model/require.h"

#include <Eigen/Geometry>

namespace muelle::engine {

namespace {

std::array<Vec3, 2> edgesIn(const Model& model, const std::array<int, 3>& nodes) {
  const auto at = [&](std::size_t i) { return model.nodes[static_cast<std::size_t>(nodes[i])].x; };
  return {at(1) - at(0), at(2) - at(0)};
}

}  // namespace

Vec3 ModelArea::normalIn(const Model& model) const {
  const auto [ab, ac] = edgesIn(model, nodes);
  const Vec3 cross = ab.cross(ac);
  return cross.norm() > 0.0 ? Vec3(cross.normalized()) : Vec3(Vec3::Zero());
}

double ModelArea::areaIn(const Model& model) const {
  const auto [ab, ac] = edgesIn(model, nodes);
  const auto [p, q] = model.plane;
  return model.dimension == 2 ? 0.5 * (ab[p] * ac[q] - ab[q] * ac[p]) : 0.5 * ab.cross(ac).dot(normal);
}

void ModelArea::check(const std::string& item) const { requireUnit(item, "normal", normal); }

void ModelArea::addTo(Builder& builder, const std::vector<ModelArea>& areas) {
  if (builder.dimension() == 2) {
    Area<2>::Turn quarter;
    quarter << 0.0, 1.0, -1.0, 0.0;
    addElements<2, Area<2>>(builder, areas, [&](const ModelArea& e, const std::array<int, 3>& nodes) {
      return Area<2>{nodes, e.k, e.A0, quarter};
    });
  } else {
    // u . S w = normal . (u x w) = u . (w x normal)
    addElements<3, Area<3>>(builder, areas, [](const ModelArea& e, const std::array<int, 3>& nodes) {
      return Area<3>{nodes, e.k, e.A0, -crossMatrix(e.normal.normalized())};
    });
  }
}

}  // namespace muelle::engine
