#pragma once
#include "engine/scene/scene.h"
#include "engine/scene/table_reader.h"

namespace muelle::engine {

/// The keys with which a table chooses nodes: "object", then one of "nodes", "within", "corner", "all".
extern const TableReader::Keys selectionKeys;

/// The nodes that a table chooses, ascending, in the model's numbering, never empty. `most` bounds their number
/// (0: any).
std::vector<int> selectNodes(const TableReader& table, const Scene& scene, int most = 0);

/// The numbers under the key "nodes", each below `available`: `count` of them, or any number where that is 0. `whose`
/// nodes they are stands in the message: "the scene".
std::vector<int> readNumbers(const TableReader& table, int count, int available, const std::string& whose);

/// The component named by a key: 0, 1, 2 for x, y, z; only those that the scene has.
int readAxis(const TableReader& table, const std::string& key);

/// The axes of a scene by name, in their order: {"x", "z"} in a plane.
std::vector<std::string> axisNames(const Space& space);

}  // namespace muelle::engine
