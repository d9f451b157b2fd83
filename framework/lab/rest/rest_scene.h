#pragma once
#include "engine/scene/scene.h"
#include "engine/statics/rest.h"

#include <memory>
#include <string>

namespace muelle::lab {

/// A scene and the equilibrium that it comes to.
struct SceneAtRest {
  std::unique_ptr<engine::ModelSystem> system;
  engine::RestOptions options;
  engine::RestResult result;
};

/// Builds the scene and seeks its equilibrium. Throws std::invalid_argument when the time is not finite or negative.
SceneAtRest restScene(const engine::Scene& scene, const engine::RestOptions& options);

/// One word or two: "stable", "none found".
std::string nameOf(engine::Verdict verdict);

/// The summary that `muelle rest` prints: verdict, smallest eigenvalue, balance, tensions, energy, work, what was left
/// out and what to do next.
std::string summaryOf(const engine::Scene& scene, const SceneAtRest& rest);

}  // namespace muelle::lab
