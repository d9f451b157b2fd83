#include "engine/elements/volume/model_volume.h"

#include "engine/elements/volume/volume.h"
#include "engine/model/builder.h"

#include <Eigen/Geometry>

namespace muelle::engine {

double ModelVolume::volumeIn(const Model& model) const {
  const auto at = [&](std::size_t i) { return model.nodes[static_cast<std::size_t>(nodes[i])].x; };
  const Vec3 a = at(0);
  return (at(1) - a).dot((at(2) - a).cross(at(3) - a)) / 6.0;
}

void ModelVolume::addTo(Builder& builder, const std::vector<ModelVolume>& volumes) {
  addElements<3, Volume>(builder, volumes, [](const ModelVolume& e, const std::array<int, 4>& nodes) {
    return Volume{nodes, e.k, e.V0};
  });
}

}  // namespace muelle::engine
