#pragma once
#include "engine/scene/scene.h"

namespace muelle::lab {

/// x'' = -100 (x - 1), from 0.2 m beyond rest: x = 1 + 0.2 cos 10 t of node 1.
inline engine::Scene springScene(double duration) {
  engine::Scene scene;
  scene.name = "spring";
  scene.model.dimension = 1;
  scene.model.nodes.resize(2);
  scene.model.nodes[0].pinned = true;
  scene.model.nodes[1].x = {1.2, 0.0, 0.0};
  scene.model.springs = {{0, 1, 100.0, 1.0}};
  scene.method = "velocity_verlet";
  scene.step = 0.01;
  scene.duration = duration;
  return scene;
}

}  // namespace muelle::lab
