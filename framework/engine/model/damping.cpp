#include "engine/model/damping.h"

#include <cmath>

namespace muelle::engine {

double projectedDamping(const Model& model, const ModelSpring& spring) {
  if (!(spring.dampingRatio > 0.0)) return spring.dProjected;
  const auto inverseMass = [&](int i) {
    const ModelNode& node = model.nodes[static_cast<std::size_t>(i)];
    return isFree(node) ? 1.0 / node.m : 0.0;
  };
  const double sum = inverseMass(spring.a) + inverseMass(spring.b);
  return sum > 0.0 ? 2.0 * spring.dampingRatio * std::sqrt(spring.k / sum) : 0.0;
}

}  // namespace muelle::engine
