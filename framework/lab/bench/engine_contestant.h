#pragma once
#include "engine/model/model_system.h"
#include "lab/bench/contestant.h"
#include "lab/bench/scene.h"

namespace muelle::bench {

/// The state of all nodes in the scene's numbering, by the system's accessors.
PathPoint pointOf(const engine::ModelSystem& system, const State& state);

/// Every method of the engine that can run the scene: adaptive ones by their tolerance, the Nystroem methods by a fixed
/// step besides ("nystrom8_fixed"). `left` receives a line for each that cannot, with its reason.
/// `scene` and `system` must outlive them.
Contestants engineContestants(const BenchScene& scene, const engine::ModelSystem& system,
                              std::vector<std::string>& left);

}  // namespace muelle::bench
