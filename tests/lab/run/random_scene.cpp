#include "random_scene.h"

#include "engine/analysis/stability.h"
#include "engine/integrators/catalogue.h"
#include "engine/model/model_system.h"
#include "engine/scene/time_functions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

namespace muelle::lab {

using namespace engine;

namespace {

class Dice {
 public:
  explicit Dice(std::uint64_t seed) : generator_(seed) {}
  double uniform(double from, double to) { return std::uniform_real_distribution<double>(from, to)(generator_); }
  double logarithmic(double from, double to) { return std::exp(uniform(std::log(from), std::log(to))); }
  int below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(generator_); }
  bool chance(double share) { return uniform(0.0, 1.0) < share; }
  /// A vector with components in (-size, size) along the scene's axes.
  Vec3 vector(int dimension, double size) {
    Vec3 v = Vec3::Zero();
    for (int axis = 0; axis < 3; ++axis) {
      const bool has = dimension == 3 || (dimension == 1 ? axis == 0 : axis != 1);
      if (has) v[axis] = uniform(-size, size);
    }
    return v;
  }

 private:
  std::mt19937_64 generator_;
};

void addNodes(Dice& dice, Model& model) {
  const int count = 1 + dice.below(6);
  const int along = model.dimension == 1 ? 0 : 2;
  for (int i = 0; i <= count; ++i) {
    ModelNode node;
    node.x = dice.vector(model.dimension, 0.3);
    node.x[along] += 3.0 - 0.8 * i;
    node.v = dice.vector(model.dimension, 1.0);
    node.m = dice.logarithmic(0.1, 3.0);
    model.nodes.push_back(node);
  }
}

void addSprings(Dice& dice, Model& model) {
  const double stiffness = dice.logarithmic(20.0, 2000.0);
  const bool relative = dice.chance(0.2), projected = !relative && dice.chance(0.3);
  const auto join = [&](int a, int b) {
    ModelSpring spring;
    spring.a = a;
    spring.b = b;
    spring.k = stiffness * dice.uniform(0.5, 2.0);
    const auto at = [&](int i) { return model.nodes[static_cast<std::size_t>(i)].x; };
    spring.L0 = (at(a) - at(b)).norm() * dice.uniform(0.7, 1.2);
    if (relative) spring.dRelative = dice.uniform(0.0, 0.5);
    if (projected) spring.dProjected = dice.uniform(0.0, 0.5);
    model.springs.push_back(spring);
  };
  const int nodes = static_cast<int>(model.nodes.size());
  for (int i = 1; i < nodes; ++i) join(i - 1, i);
  if (nodes > 2 && dice.chance(0.5)) join(0, 2);
}

/// What holds, drives, drags or carries it.
void addSurroundings(Dice& dice, Model& model) {
  const int along = model.dimension == 1 ? 0 : 2;
  if (dice.chance(0.6)) model.gravity[along] = -9.81;
  const double kind = dice.uniform(0.0, 1.0);
  if (kind < 0.5) {
    model.nodes[0].pinned = true;
    model.nodes[0].v = Vec3::Zero();
  } else if (kind < 0.6) {
    model.nodes[0].motion = 0;
    model.nodes[0].v = Vec3::Zero();
    const double infinite = std::numeric_limits<double>::infinity();
    model.motions.push_back(startingAt(
        model.nodes[0].x, oscillation(dice.vector(model.dimension, 0.2), dice.uniform(0.3, 2.0), 0.0, infinite)));
  } else if (kind < 0.7) {
    Obstacle ground;
    ground.normal = Vec3::Zero();
    ground.normal[along] = 1.0;
    ground.centre[along] = model.nodes.back().x[along] - dice.uniform(0.1, 0.6);
    ground.material.k = dice.logarithmic(200.0, 5000.0);
    ground.material.d = dice.chance(0.5) ? dice.uniform(0.0, 1.0) : 0.0;
    model.obstacles.push_back(ground);
    model.gravity[along] = -9.81;
  }
  if (dice.chance(0.2)) {
    for (ModelNode& node : model.nodes) node.drag = dice.uniform(0.0, 0.3);
  }
  if (dice.chance(0.2)) {
    const double infinite = std::numeric_limits<double>::infinity();
    model.externalForces.push_back(externalForce({static_cast<int>(model.nodes.size()) - 1},
                                                 dice.vector(model.dimension, 5.0), 0.0, infinite,
                                                 dice.uniform(0.3, 3.0)));
  }
}

}  // namespace

Scene randomScene(std::uint64_t seed) {
  constexpr std::array<const char*, 13> methods = {"velocity_verlet",
                                                   "symplectic_euler",
                                                   "runge_kutta_4",
                                                   "explicit_midpoint",
                                                   "implicit_midpoint",
                                                   "bdf2",
                                                   "newmark",
                                                   "kahan_li_8",
                                                   "yoshida4",
                                                   "backward_euler",
                                                   "dop853",
                                                   "dormand_prince_5",
                                                   "discrete_gradient"};
  Dice dice(seed);
  Scene scene;
  scene.name = "random";
  scene.title = "drawn";
  scene.model.dimension = 1 + dice.below(3);
  scene.model.springsCross = scene.model.dimension == 1;
  addNodes(dice, scene.model);
  addSprings(dice, scene.model);
  addSurroundings(dice, scene.model);

  const std::unique_ptr<ModelSystem> system = build(scene.model);
  scene.method = methods[static_cast<std::size_t>(dice.below(static_cast<int>(methods.size())))];
  const bool complete = system->potential() != nullptr && system->potential()->isComplete();
  if (methodInfo(scene.method).needs.potential && !complete) scene.method = "velocity_verlet";
  double fastest = 1e-3;
  State state = system->initialState();
  if (system->switching() != nullptr) system->switching()->close(state);
  for (const Mode& mode : extremeModes(LinearisedSystem(*system, state))) fastest = std::max(fastest, mode.rate());
  double limit = 2.0 / fastest;
  const double own = stability(*system, *makeMethod(scene.method), state).largestStep;
  if (own > 0.0) limit = std::min(limit, own);
  if (methodInfo(scene.method).adaptive) scene.tolerance = dice.logarithmic(1e-9, 1e-2);
  scene.step = limit * dice.logarithmic(0.01, 1.0);
  scene.duration = 2.0 * std::numbers::pi / fastest * dice.logarithmic(2.0, 20.0);
  return scene;
}

}  // namespace muelle::lab
