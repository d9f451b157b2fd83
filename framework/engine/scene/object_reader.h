#pragma once
#include "engine/scene/scene.h"
#include "engine/scene/table_reader.h"

namespace muelle::engine {

/// Reads one [[object]] and adds it to the scene: generator, material, place, velocity. `folder` is where mesh files
/// are looked for.
void readObject(const TableReader& table, Scene& scene, const std::filesystem::path& folder);

}  // namespace muelle::engine
