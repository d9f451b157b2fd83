#pragma once
#include "engine/scene/scene.h"

#include <cstdint>

namespace muelle::lab {

/// A scene drawn from a seed: a random model (see randomModel()), any method of the catalogue that can run it, with a
/// step between the stability limit and a hundredth of it or a tolerance, over 2 to 20 periods of its fastest mode; one
/// in ten does not locate its events.
engine::Scene randomScene(std::uint64_t seed);

}  // namespace muelle::lab
