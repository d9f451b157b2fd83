#pragma once
#include "engine/scene/scene.h"

#include <string>

namespace muelle::lab {

/// Why a scene cannot be written node by node: motions, forces of time and properties are functions. Empty when it can.
std::string unlisted(const engine::Scene& scene);

/// A scene as a file that names each node, spring, element and obstacle with all digits.
std::string listedScene(const engine::Scene& scene);

}  // namespace muelle::lab
