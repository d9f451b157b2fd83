#pragma once
/// \file
/// A submission in one of the scenes: what it gives, how exact that is, what it has asked for, and what can be seen of
/// how it went wrong.

#include "grader/testing/seen.h"
#include "judge.h"
#include "seeded_scenes.h"

#include <string>

namespace trials {

using muelle::Random;
using muelle::VecX;
using scenes::Asked;

struct RabbitTrial {
  using Scene = scenes::Rabbit;
  static constexpr const char* function = "squeezedRabbit";
  static scenes::RabbitNumbers numbersFrom(Random& random) { return scenes::rabbitFrom(random); }
  static Scene sceneOf(const scenes::RabbitNumbers& numbers) { return {numbers, scenes::rabbitMesh()}; }
  static VecX submitted(const Asked<Scene>& asked) {
    const Scene& scene = asked.scene();
    return submission::squeezedRabbit(asked.force(), scene.masses(), scene.positions(), scene.velocities());
  }
  static VecX right(const Scene& scene) {
    return oracle::squeezedRabbit(unlimited(scene), scene.masses(), scene.positions(), scene.velocities());
  }
  static Force unlimited(const Scene& scene) {
    return [&scene](double t, const VecX& x, const VecX& v) { return scene.force(t, x, v); };
  }
};

struct ClothTrial {
  using Scene = scenes::Cloth;
  static constexpr const char* function = "stiffCloth";
  static scenes::ClothNumbers numbersFrom(Random& random) { return scenes::clothFrom(random); }
  static Scene sceneOf(const scenes::ClothNumbers& numbers) { return Scene(numbers); }
  static VecX submitted(const Asked<Scene>& asked) {
    const Scene& scene = asked.scene();
    return submission::stiffCloth(asked.force(), asked.hessian(), scene.masses(), scene.positions(),
                                  scene.velocities());
  }
  static VecX right(const Scene& scene) {
    return oracle::stiffCloth(unlimited(scene), Asked(scene).hessian(), scene.masses(), scene.positions(),
                              scene.velocities());
  }
  static Force unlimited(const Scene& scene) {
    return [&scene](double t, const VecX& x, const VecX& v) { return scene.force(t, x, v); };
  }
};

struct BallTrial {
  using Scene = scenes::Ball;
  static constexpr const char* function = "bouncingBall";
  static scenes::BallNumbers numbersFrom(Random& random) { return scenes::ballFrom(random); }
  static Scene sceneOf(const scenes::BallNumbers& numbers) { return Scene(numbers); }
  static VecX submitted(const Asked<Scene>& asked) {
    const Scene& scene = asked.scene();
    return submission::bouncingBall(asked.force(), scene.masses(), scene.positions(), scene.velocities());
  }
  static VecX right(const Scene& scene) {
    return oracle::bouncingBall(unlimited(scene), scene.masses(), scene.positions(), scene.velocities());
  }
  static Force unlimited(const Scene& scene) {
    return [&scene](double t, const VecX& x, const VecX& v) { return scene.force(t, x, v); };
  }
};

}  // namespace trials
