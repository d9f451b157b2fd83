#include "engine/model/validate.h"

#include "base/text/count.h"
#include "engine/model/require.h"
#include "engine/model/rods.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <stdexcept>

namespace muelle::engine {

namespace {

void checkScene(const Model& model) {
  if (model.dimension < 1 || model.dimension > 3) {
    reject("model", fmt::format("dimension is {}; it is 1, 2 or 3", model.dimension));
  }
  const auto& [first, second] = model.plane;
  if (model.dimension == 2 && (first < 0 || first > 2 || second < 0 || second > 2 || first == second)) {
    reject("model", fmt::format("plane is ({}, {}); it names two different axes of 0, 1, 2", first, second));
  }
  if (model.nodes.empty()) reject("model", "has no nodes");
  if (std::none_of(model.nodes.begin(), model.nodes.end(), isFree)) {
    reject("model", "all nodes are pinned or moved, so that nothing is left to simulate");
  }
}

bool inScene(const Model& model, int axis) {
  if (model.dimension == 3) return true;
  if (model.dimension == 1) return axis == 0;
  return axis == model.plane[0] || axis == model.plane[1];
}

void requireInScene(const Model& model, const std::string& item, const char* what, const Vec3& direction) {
  for (int axis = 0; axis < 3; ++axis) {
    if (direction[axis] != 0.0 && !inScene(model, axis)) {
      reject(item, fmt::format("{} ({}, {}, {}) leaves the {}; {}", what, direction[0], direction[1], direction[2],
                               model.dimension == 1 ? "line of a 1D scene" : "plane of a 2D scene",
                               model.dimension == 1 ? "in 1D only the first component counts"
                                                    : "only the components of Model::plane count"));
    }
  }
}

void checkNodes(const Model& model) {
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    const ModelNode& node = model.nodes[i];
    const std::string item = fmt::format("node {}", i);
    requireFinite(item, "position", node.x);
    requireFinite(item, "velocity", node.v);
    requireNotNegative(item, "drag", node.drag);
    if (node.motion >= static_cast<int>(model.motions.size())) {
      reject(item, fmt::format("there is no motion {}; the model has {}", node.motion, model.motions.size()));
    }
    if (node.pinned && node.motion >= 0) reject(item, "is both pinned and moved");
    if (!isFree(node)) continue;
    if (!(node.m > 0.0) || !std::isfinite(node.m) || isDenormal(node.m)) {
      reject(item, fmt::format("mass is {}; a mass is positive and finite", node.m));
    }
  }
  for (std::size_t i = 0; i < model.motions.size(); ++i) {
    if (!model.motions[i].position || !model.motions[i].velocity) {
      reject(fmt::format("motion {}", i), "needs both a position and a velocity");
    }
  }
}

void checkSigned(const Model& model, const std::string& item, const ModelSpring& spring) {
  if (model.dimension != 1) reject(item, "is signed; only a 1D scene has sides");
  if (spring.unilateral || spring.rod) reject(item, "is signed; a one-sided spring or a rod has no other side");
  const auto at = [&model](int node) { return model.nodes[static_cast<std::size_t>(node)].x[0]; };
  if (at(spring.a) == at(spring.b) && spring.L0 > 0.0) {
    reject(item, "is signed and its nodes start in one place, so that it has no side yet; move one of them");
  }
}

void checkSprings(const Model& model) {
  std::vector<std::array<int, 3>> ends;
  for (std::size_t i = 0; i < model.springs.size(); ++i) {
    const ModelSpring& spring = model.springs[i];
    const std::string item = fmt::format("spring {}", i);
    requireNodes(model, item, std::array{spring.a, spring.b});
    if (spring.a == spring.b) reject(item, fmt::format("joins node {} with itself", spring.a));
    requireStiffness(item, "stiffness k", spring.k);
    requireNotNegative(item, "rest length L0", spring.L0);
    requireNotNegative(item, "relative damping", spring.dRelative);
    requireNotNegative(item, "projected damping", spring.dProjected);
    requireNotNegative(item, "damping ratio", spring.dampingRatio);
    if (spring.dampingRatio > 0.0 && spring.dProjected > 0.0) {
      reject(item, "has a damping ratio and a projected damping; give one of them");
    }
    requirePart(model, item, spring.part);
    if (spring.isSigned) checkSigned(model, item, spring);
    ends.push_back({std::min(spring.a, spring.b), std::max(spring.a, spring.b), static_cast<int>(i)});
  }
  std::sort(ends.begin(), ends.end());
  for (std::size_t i = 1; i < ends.size(); ++i) {
    const auto& [a, b, spring] = ends[i];
    if (ends[i - 1][0] == a && ends[i - 1][1] == b) {
      reject(fmt::format("spring {}", spring), fmt::format("joins nodes {} and {}, as spring {} does already; add up "
                                                           "their stiffnesses in one",
                                                           a, b, ends[i - 1][2]));
    }
  }
}

void checkElements(const Model& model) {
  forEachElementKind(model, [&]<class List>(const List& elements) {
    using Element = ElementOf<List>;
    for (std::size_t i = 0; i < elements.size(); ++i) {
      const Element& element = elements[i];
      const std::string item = fmt::format("{} {}", Element::kind, i);
      if (model.dimension < Element::leastDimension) {
        reject(item, Element::leastDimension == 3 ? fmt::format("{}s need a 3D scene", Element::kind)
                                                  : fmt::format("a 1D scene has no {}s", Element::kind));
      }
      requireNodes(model, item, element.nodes);
      requireDifferent(item, element.nodes);
      requireStiffness(item, "stiffness k", element.k);
      requireFinite(item, Element::rest, element.restValue());
      requirePart(model, item, element.part);
      element.check(item);
    }
  });
}

void checkProperties(const Model& model) {
  for (std::size_t i = 0; i < model.properties.size(); ++i) {
    const ModelProperty& property = model.properties[i];
    const std::string item = fmt::format("property {}", i);
    if (property.nodes.size() != property.weights.size()) {
      reject(item, fmt::format("has {} and {}", counted(std::ssize(property.nodes), "node"),
                               counted(std::ssize(property.weights), "weight")));
    }
    requireNodes(model, item, property.nodes);
    requireStiffness(item, "stiffness k", property.k);
    requireFinite(item, "wanted value", property.p0);
    requirePart(model, item, property.part);
    for (const Vec3& weight : property.weights) requireFinite(item, "a weight", weight);
  }
}

void checkExternalForces(const Model& model) {
  for (std::size_t i = 0; i < model.externalForces.size(); ++i) {
    const ModelExternalForce& force = model.externalForces[i];
    const std::string item = fmt::format("external force {}", i);
    requireNodes(model, item, force.nodes);
    if (!force.force) reject(item, "has no function");
    requirePart(model, item, force.part);
    for (const double time : force.times) requireFinite(item, "a declared time", time);
    if (!std::is_sorted(force.times.begin(), force.times.end())) reject(item, "declared times must ascend");
  }
}

void requireSomeFiniteSize(const Model& model, const std::string& item, const Vec3& halfSize) {
  for (int axis = 0; axis < 3; ++axis) {
    if (inScene(model, axis) && std::isfinite(halfSize[axis])) return;
  }
  reject(item, "is infinite along every axis of the scene");
}

void checkObstacles(const Model& model) {
  for (const Obstacle& obstacle : model.obstacles) {
    const std::string item = fmt::format("obstacle '{}'", obstacle.name);
    requireFinite(item, "centre", obstacle.centre);
    requireFinite(item, "velocity", obstacle.velocity);
    if (std::isnan(obstacle.stopTime)) reject(item, "stop time is nan");
    requireStiffness(item, "stiffness k", obstacle.material.k);
    requireNotNegative(item, "damping d", obstacle.material.d);
    requireNotNegative(item, "friction mu", obstacle.material.mu);
    requireStiffness(item, "tangential stiffness", obstacle.material.kTangential);
    requireNotNegative(item, "tangential damping", obstacle.material.dTangential);
    if (!(obstacle.material.k > 0.0)) reject(item, "stiffness k is 0, so that it would stop nothing");
    switch (obstacle.kind) {
      case Obstacle::Kind::Plane:
        requireUnit(item, "normal", obstacle.normal);
        requireInScene(model, item, "normal", obstacle.normal);
        break;
      case Obstacle::Kind::Sphere:
        if (!(obstacle.radius > 0.0) || !std::isfinite(obstacle.radius)) {
          reject(item, fmt::format("radius is {}; it must be positive and finite", obstacle.radius));
        }
        break;
      case Obstacle::Kind::Box:
        for (const double half : obstacle.halfSize) {
          if (!(half > 0.0)) reject(item, fmt::format("half size is {}; it must be positive", half));
        }
        requireSomeFiniteSize(model, item, obstacle.halfSize);
        break;
    }
  }
}

}  // namespace

void validate(const Model& model) {
  checkScene(model);
  requireFinite("gravity", "acceleration", model.gravity);
  requireInScene(model, "gravity", "acceleration", model.gravity);
  checkNodes(model);
  checkSprings(model);
  checkRods(model);
  checkElements(model);
  checkProperties(model);
  checkExternalForces(model);
  checkObstacles(model);
}

}  // namespace muelle::engine
