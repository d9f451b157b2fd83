#pragma once
#include "engine/scene/scene.h"

#include <cstdint>

namespace muelle::lab {

/// A scene drawn from a seed: one to six nodes in one, two or three dimensions, a chain and springs across it, hung, on
/// a ground, driven or free, damped in one of the ways or not, with a method and a step between the stability limit and
/// a hundredth of it, over 2 to 20 periods of its fastest mode.
engine::Scene randomScene(std::uint64_t seed);

}  // namespace muelle::lab
