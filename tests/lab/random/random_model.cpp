#include "random_model.h"

#include "engine/scene/time_functions.h"

#include <array>
#include <limits>
#include <numbers>

namespace muelle::lab {

using namespace engine;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double apart = 0.8;  ///< neighbours in the chain, about [m]

int heightOf(const Model& model) { return model.dimension == 1 ? 0 : 2; }
int countOf(const Model& model) { return static_cast<int>(model.nodes.size()); }
const Vec3& at(const Model& model, int node) { return model.nodes[static_cast<std::size_t>(node)].x; }

void addNodes(Dice& dice, Model& model) {
  const int count = 1 + dice.below(6);
  for (int i = 0; i <= count; ++i) {
    ModelNode node;
    node.x = dice.vector(model.dimension, 0.3);
    node.x[heightOf(model)] += 3.0 - apart * i;
    node.v = dice.vector(model.dimension, 1.0);
    node.m = dice.logarithmic(0.1, 3.0);
    model.nodes.push_back(node);
  }
}

void addSprings(Dice& dice, Model& model, double stiffness) {
  const bool relative = dice.chance(0.2), projected = !relative && dice.chance(0.3);
  const bool isSigned = model.dimension == 1 && dice.chance(0.4);
  const auto join = [&](int a, int b) {
    ModelSpring spring;
    spring.a = a;
    spring.b = b;
    spring.k = stiffness * dice.uniform(0.5, 2.0);
    spring.L0 = (at(model, a) - at(model, b)).norm() * dice.uniform(0.7, 1.2);
    if (relative) spring.dRelative = dice.uniform(0.0, 0.5);
    if (projected) spring.dProjected = dice.uniform(0.0, 0.5);
    spring.isSigned = isSigned;
    spring.unilateral = !isSigned && dice.chance(0.1);
    model.springs.push_back(spring);
  };
  for (int i = 1; i < countOf(model); ++i) join(i - 1, i);
  if (countOf(model) > 2 && dice.chance(0.5)) join(0, 2);
}

/// A chain of rods, at their lengths and without a rate of stretch: it hangs at rest, or all nodes fly alike.
void addRods(Dice& dice, Model& model) {
  model.nodes[0].pinned = dice.chance(0.5);
  if (model.nodes[0].pinned) model.nodes[0].v = Vec3::Zero();
  for (int i = 1; i < countOf(model); ++i) {
    ModelSpring rod;
    rod.a = i - 1;
    rod.b = i;
    rod.rod = true;
    rod.L0 = (at(model, i) - at(model, i - 1)).norm();
    model.springs.push_back(rod);
    model.nodes[static_cast<std::size_t>(i)].v = model.nodes[0].v;
  }
}

/// Elements over neighbours, as stiff for a displacement as the springs to within a factor of ten.
void addElements(Dice& dice, Model& model, double stiffness) {
  const int count = countOf(model);
  const auto k = [&](double power) { return stiffness * std::pow(apart, power) * dice.logarithmic(0.05, 1.0); };
  const bool angles = count > 2 && model.dimension > 1 && dice.chance(0.25);
  for (int i = 2; angles && i < count; ++i) model.angles.push_back({i - 2, i - 1, i, k(2.0), dice.uniform(0.0, 0.4)});
  if (count > 3 && model.dimension == 3 && dice.chance(0.25)) {
    model.dihedrals.push_back({1, 2, 0, 3, k(2.0), dice.uniform(-1.0, 1.0)});
  }
  if (count > 2 && model.dimension > 1 && dice.chance(0.25)) {
    ModelArea area{0, 1, 2, k(-2.0), dice.uniform(-0.3, 0.3)};
    area.normal = dice.vector(3, 1.0).normalized();
    model.areas.push_back(area);
  }
  if (count > 3 && model.dimension == 3 && dice.chance(0.25)) {
    model.volumes.push_back({0, 1, 2, 3, k(-4.0), dice.uniform(-0.05, 0.05)});
  }
}

/// The mean of a component is pulled to where it starts or beside it.
void addProperty(Dice& dice, Model& model, double stiffness) {
  if (!dice.chance(0.1)) return;
  ModelProperty property;
  property.k = stiffness * dice.logarithmic(0.1, 2.0);
  Vec3 weight = Vec3::Zero();
  weight[heightOf(model)] = 1.0 / countOf(model);
  for (int i = 0; i < countOf(model); ++i) {
    property.nodes.push_back(i);
    property.weights.push_back(weight);
    property.p0 += weight.dot(at(model, i));
  }
  property.p0 += dice.uniform(-0.2, 0.2);
  model.properties.push_back(property);
}

/// One of the motions of scene files; those that end do so within the run, or near its end.
Motion randomMotion(Dice& dice, int dimension) {
  const double from = dice.chance(0.5) ? 0.0 : dice.logarithmic(0.02, 0.3), to = from + dice.logarithmic(0.05, 1.0);
  const Vec3 way = dice.vector(dimension, 0.2);
  switch (dice.below(4)) {
    case 0:
      return smoothStroke(way, from, to);
    case 1:
      return steadyMotion(5.0 * way, from, to);
    case 2:
      return oscillation(way, dice.uniform(0.3, 2.0), from, to);
    default:
      return oscillation(way, dice.uniform(0.3, 2.0), 0.0, infinite);
  }
}

Obstacle randomObstacle(Dice& dice, const Model& model) {
  const int height = heightOf(model);
  Obstacle obstacle;
  obstacle.kind = std::array{Obstacle::Kind::Plane, Obstacle::Kind::Sphere,
                             Obstacle::Kind::Box}[static_cast<std::size_t>(dice.chance(0.5) ? 0 : 1 + dice.below(2))];
  obstacle.centre = model.nodes.back().x;
  obstacle.centre[height] -= dice.uniform(0.05, 0.4);
  obstacle.normal = Vec3::Zero();
  obstacle.normal[height] = 1.0;
  if (model.dimension > 1) obstacle.normal = (obstacle.normal + dice.vector(model.dimension, 0.3)).normalized();
  obstacle.radius = 0.6;
  obstacle.halfSize = Vec3(0.6, 0.6, 0.6);
  if (obstacle.kind != Obstacle::Kind::Plane) obstacle.centre[height] -= 0.6;
  obstacle.material.k = dice.logarithmic(200.0, 5000.0);
  obstacle.material.d = dice.chance(0.4) ? dice.uniform(0.0, 1.0) : 0.0;
  obstacle.material.mu = dice.chance(0.4) ? dice.uniform(0.05, 0.8) : 0.0;
  if (dice.chance(0.2)) {
    obstacle.velocity = dice.vector(model.dimension, 0.5);
    obstacle.stopTime = dice.chance(0.5) ? dice.logarithmic(0.05, 0.5) : infinite;
  }
  return obstacle;
}

void hold(Dice& dice, Model& model) {
  const double kind = dice.uniform(0.0, 1.0);
  if (kind < 0.45) {
    model.nodes[0].pinned = true;
    model.nodes[0].v = Vec3::Zero();
  } else if (kind < 0.65) {
    model.nodes[0].motion = 0;
    model.nodes[0].v = Vec3::Zero();
    model.motions.push_back(startingAt(at(model, 0), randomMotion(dice, model.dimension)));
  }
}

void addForce(Dice& dice, Model& model) {
  const bool pulse = dice.chance(0.5), periodic = !pulse || dice.chance(0.3);
  const double from = pulse ? dice.logarithmic(0.01, 0.3) : 0.0;
  const double to = pulse ? from + dice.logarithmic(0.02, 0.5) : infinite;
  model.externalForces.push_back(externalForce({countOf(model) - 1}, dice.vector(model.dimension, 5.0), from, to,
                                               periodic ? dice.logarithmic(0.3, 20.0) : 0.0));
}

}  // namespace

Model randomModel(Dice& dice) {
  Model model;
  model.dimension = 1 + dice.below(3);
  model.springsCross = model.dimension == 1;
  addNodes(dice, model);
  const double stiffness = dice.logarithmic(20.0, 2000.0);
  const bool rods = model.dimension > 1 && dice.chance(0.07);
  if (rods) {
    addRods(dice, model);
  } else {
    addSprings(dice, model, stiffness);
  }
  addElements(dice, model, stiffness);
  addProperty(dice, model, stiffness);
  if (dice.chance(0.6)) model.gravity[heightOf(model)] = -9.81;
  if (!rods) hold(dice, model);
  if (!rods && dice.chance(0.25)) {
    model.obstacles.push_back(randomObstacle(dice, model));
    model.gravity[heightOf(model)] = -9.81;
  }
  // Contacts of rods are smooth and keep energy: RATTLE takes no force that depends on the velocity (it would have to
  // solve for the velocity and the rods' forces at once), so neither dampers nor friction nor drag are possible with
  // it.
  if (rods && dice.chance(0.3)) {
    Obstacle obstacle = randomObstacle(dice, model);
    obstacle.material.d = obstacle.material.mu = obstacle.material.dTangential = 0.0;
    model.obstacles.push_back(obstacle);
    model.gravity[heightOf(model)] = -9.81;
  }
  if (!rods && dice.chance(0.2)) {
    for (ModelNode& node : model.nodes) node.drag = dice.uniform(0.0, 0.3);
  }
  if (dice.chance(0.2)) addForce(dice, model);
  return model;
}

}  // namespace muelle::lab
