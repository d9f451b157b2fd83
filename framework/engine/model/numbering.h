#pragma once
#include <span>
#include <utility>
#include <vector>

namespace muelle::engine {

/// Reverse Cuthill-McKee order of a graph (George and Liu 1981): neighbours get close numbers, so that forces gather
/// from close memory and factors fill in little. Each part starts at a node as far out as a few sweeps find.
///
/// \param nodes number of nodes   \param edges pairs of different nodes, in any order, repeated ones allowed
/// \return the old number of each new one
std::vector<int> reverseCuthillMcKee(int nodes, std::span<const std::pair<int, int>> edges);

}  // namespace muelle::engine
