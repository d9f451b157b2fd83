#pragma once
#include "lab/rest/rest_scene.h"

#include <filesystem>

namespace muelle::lab {

/// Writes two tables: NAME_nodes.csv (node, whether it is free, x, y, z at rest and its way from the start, in
/// metres; components that the scene does not have are 0) and NAME_springs.csv (spring, its two nodes, L0 and length in
/// metres, k in N/m, tension in N, positive where it pulls). Returns their paths. All digits are written.
std::vector<std::filesystem::path> writeTables(const engine::Scene& scene, const SceneAtRest& rest,
                                               const std::filesystem::path& folder);

}  // namespace muelle::lab
