#include "engine/model/grid_force.h"

namespace muelle::engine {

void GridForce::accelerate(In x, In v, const double* added, std::span<const double> inverseMass, bool withDrag,
                           Out a) const {
  const double* drag = withDrag && !nodes_.drag.empty() ? nodes_.drag.data() : nullptr;
  const Vec3& g = nodes_.gravity;
  // Of 1/m the first plane: a node has one mass.
  springs_.evaluate({x.data(), v.data(), nodes_.plane},
                    {a.data(), nodes_.plane, added, v.data(), drag, inverseMass.data(), nullptr, {g[0], g[1], g[2]}});
}

}  // namespace muelle::engine
