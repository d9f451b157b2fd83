#pragma once
#include "engine/model/model_system.h"

#include <optional>
#include <vector>

namespace muelle::engine {

/// Nodes that hang together and on nothing else, under loads that do not sum to zero: no shape of theirs is at rest.
struct Unsupported {
  std::vector<int> nodes;    ///< in the model's numbering, ascending
  Vec3 load = Vec3::Zero();  ///< sum of gravity and external forces on them [N]
};

/// The first such set of a model at time t; none where each is tied to a node that is pinned or moved, has
/// a property to hold it, or loads that cancel. Where there are obstacles nothing is said: they may carry a load.
std::optional<Unsupported> findUnsupported(const ModelSystem& system, double t);

}  // namespace muelle::engine
