#pragma once
#include "engine/model/model.h"

#include <vector>

namespace muelle::engine {

/// The components of a Vec3 that a scene of this model has, in the order of its unknowns.
inline std::vector<int> axesOf(const Model& model) {
  if (model.dimension == 1) return {0};
  if (model.dimension == 2) return {model.plane[0], model.plane[1]};
  return {0, 1, 2};
}

/// The component that points up: the last that the scene has.
inline int upAxisOf(const Model& model) { return axesOf(model).back(); }

}  // namespace muelle::engine
