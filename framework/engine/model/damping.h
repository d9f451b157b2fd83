#pragma once
#include "engine/model/model.h"

namespace muelle::engine {

/// The projected damping of a spring [kg/s]: its own, or that of its damping ratio z, d = 2 z sqrt(k m) with
/// 1/m = 1/ma + 1/mb, which is the ratio of its two masses on this spring alone. A node that is pinned or moved counts
/// as infinitely heavy, so the whole model decides; between two such nodes nothing swings, and d is 0.
double projectedDamping(const Model& model, const ModelSpring& spring);

}  // namespace muelle::engine
