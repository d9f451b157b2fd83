#include "engine/model/validate.h"

#include "base/text/count.h"
#include "engine/model/rods.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <stdexcept>

namespace muelle::engine {

namespace {

[[noreturn]] void reject(const std::string& item, const std::string& fault) {
  throw std::invalid_argument(item + ": " + fault);
}

bool isDenormal(double value) { return value != 0.0 && std::abs(value) < std::numeric_limits<double>::min(); }

void requireFinite(const std::string& item, const char* what, double value) {
  if (!std::isfinite(value)) reject(item, fmt::format("{} is {}; it must be finite", what, value));
}

void requireFinite(const std::string& item, const char* what, const Vec3& value) {
  for (const double component : value) {
    if (!std::isfinite(component)) {
      reject(item, fmt::format("{} is ({}, {}, {}); it must be finite", what, value[0], value[1], value[2]));
    }
  }
}

void requireNotNegative(const std::string& item, const char* what, double value) {
  if (!(value >= 0.0) || !std::isfinite(value)) {
    reject(item, fmt::format("{} is {}; it must be finite and not negative", what, value));
  }
}

void requireStiffness(const std::string& item, const char* what, double value) {
  requireNotNegative(item, what, value);
  if (isDenormal(value)) {
    reject(item, fmt::format("{} is {}, below the smallest normal number; write 0 for none", what, value));
  }
}

void requireUnit(const std::string& item, const char* what, const Vec3& value) {
  requireFinite(item, what, value);
  if (!(std::abs(value.norm() - 1.0) < 1e-9)) {
    reject(item, fmt::format("{} is ({}, {}, {}), of length {}; it must have length 1", what, value[0], value[1],
                             value[2], value.norm()));
  }
}

/// Indices that exist, each once.
void requireNodes(const Model& model, const std::string& item, std::span<const int> nodes) {
  const int count = static_cast<int>(model.nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i] < 0 || nodes[i] >= count) {
      reject(item, fmt::format("there is no node {}; nodes are 0 to {}", nodes[i], count - 1));
    }
  }
}

void requirePart(const Model& model, const std::string& item, int part) {
  if (part == partOfItsKind || (part >= 0 && part < std::ssize(model.parts))) return;
  reject(item, fmt::format("there is no part {}; the model has {}", part, counted(std::ssize(model.parts), "part")));
}

void requireDifferent(const std::string& item, std::span<const int> nodes) {
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (nodes[i] == nodes[j]) reject(item, fmt::format("uses node {} twice", nodes[i]));
    }
  }
}

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
  for (std::size_t i = 0; i < model.angles.size(); ++i) {
    const auto& [a, b, c, k, theta0, part] = model.angles[i];
    const std::string item = fmt::format("angle {}", i);
    if (model.dimension == 1) reject(item, "a 1D scene has no angles");
    requireNodes(model, item, std::array{a, b, c});
    requireDifferent(item, std::array{a, b, c});
    requireStiffness(item, "stiffness k", k);
    requireFinite(item, "rest angle", theta0);
    requirePart(model, item, part);
  }
  for (std::size_t i = 0; i < model.dihedrals.size(); ++i) {
    const auto& [a, b, c, d, k, theta0, part] = model.dihedrals[i];
    const std::string item = fmt::format("dihedral {}", i);
    if (model.dimension != 3) reject(item, "dihedral angles need a 3D scene");
    requireNodes(model, item, std::array{a, b, c, d});
    requireDifferent(item, std::array{a, b, c, d});
    requireStiffness(item, "stiffness k", k);
    requireFinite(item, "rest angle", theta0);
    requirePart(model, item, part);
  }
  for (std::size_t i = 0; i < model.areas.size(); ++i) {
    const ModelArea& area = model.areas[i];
    const std::string item = fmt::format("area {}", i);
    if (model.dimension == 1) reject(item, "a 1D scene has no areas");
    requireNodes(model, item, std::array{area.a, area.b, area.c});
    requireDifferent(item, std::array{area.a, area.b, area.c});
    requireStiffness(item, "stiffness k", area.k);
    requireFinite(item, "rest area", area.A0);
    requirePart(model, item, area.part);
    if (model.dimension == 3) requireUnit(item, "normal", area.normal);
  }
  for (std::size_t i = 0; i < model.volumes.size(); ++i) {
    const auto& [a, b, c, d, k, V0, part] = model.volumes[i];
    const std::string item = fmt::format("volume {}", i);
    if (model.dimension != 3) reject(item, "volumes need a 3D scene");
    requireNodes(model, item, std::array{a, b, c, d});
    requireDifferent(item, std::array{a, b, c, d});
    requireStiffness(item, "stiffness k", k);
    requireFinite(item, "rest volume", V0);
    requirePart(model, item, part);
  }
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
