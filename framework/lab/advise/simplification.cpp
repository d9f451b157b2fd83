#include "lab/advise/simplification.h"

#include "engine/model/axes.h"
#include "engine/model/parts.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

namespace muelle::lab {

using namespace engine;

namespace {

constexpr const char* letters = "xyz";

bool isDamped(const ModelSpring& spring) {
  return spring.dRelative > 0.0 || spring.dProjected > 0.0 || spring.dampingRatio > 0.0;
}

/// The elements that objects make of these keys stiffen what holds without them.
void addElements(const Scene& scene, std::vector<Simplification>& found) {
  static const std::map<std::string, std::string> keys = {{"shear", "shear_stiffness"},
                                                          {"bend", "bend_stiffness"},
                                                          {"angle", "angle_stiffness"},
                                                          {"dihedral", "dihedral_stiffness"}};
  for (const ModelPart& part : partsOf(scene.model)) {
    const std::size_t dot = std::min(part.name.rfind('.'), part.name.size());
    const std::string object = part.name.substr(0, dot);
    const auto key = keys.find(part.name.substr(std::min(dot + 1, part.name.size())));
    if (key == keys.end() || std::ranges::find(scene.parts, object, &Part::name) == scene.parts.end()) continue;
    Simplification elements{.kind = Simplification::Kind::Elements, .name = part.name};
    elements.object = object;
    elements.key = key->second;
    found.push_back(std::move(elements));
  }
}

// --- what keeps a scene out of a plane ---

/// Moments of time at which a function of time is looked at: in each stretch between declared times.
std::vector<std::pair<double, int>> moments(const std::vector<double>& declared, double duration) {
  std::vector<double> ends = {0.0};
  for (const double t : declared) {
    if (t > 0.0 && t < duration) ends.push_back(t);
  }
  ends.push_back(duration);
  std::vector<std::pair<double, int>> all;
  constexpr int looks = 16;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const double middle = 0.5 * (ends[i] + ends[i + 1]);
    const auto segment = static_cast<int>(std::ranges::count_if(declared, [&](double t) { return t < middle; }));
    for (int j = 0; j <= looks; ++j) all.emplace_back(ends[i] + (ends[i + 1] - ends[i]) * j / looks, segment);
  }
  return all;
}

class PlaneCheck {
 public:
  PlaneCheck(const Scene& scene, std::vector<int> lost) : scene_(scene), model_(scene.model), lost_(std::move(lost)) {}

  std::string firstThatLeaves() const {
    if (lies(model_.gravity)) return "gravity does not lie in it";
    for (std::size_t i = 0; i < model_.nodes.size(); ++i) {
      const ModelNode& node = model_.nodes[i];
      const Vec3 apart = node.x - model_.nodes[0].x;
      if (lies(apart)) return fmt::format("node {} does not lie in it", i);
      if (lies(node.v)) return fmt::format("node {} flies out of it", i);
    }
    for (const auto& check : {&PlaneCheck::elements, &PlaneCheck::obstacles, &PlaneCheck::driven}) {
      if (const std::string found = (this->*check)(); !found.empty()) return found;
    }
    return {};
  }

 private:
  /// Whether a vector has a component in a direction that would be lost.
  bool lies(const Vec3& v) const {
    return std::ranges::any_of(lost_, [&](int c) { return std::abs(v[c]) > 1e-14 * (1.0 + v.norm()); });
  }

  std::string elements() const {
    const bool bent = std::ranges::any_of(model_.angles, [](const ModelAngle& angle) { return angle.theta0 != 0.0; });
    if (bent) return "angles at rest out of line have a sign in a plane and none in space";
    if (elementCount(model_) > model_.angles.size()) return "it has dihedrals, areas or volumes, which are of space";
    for (const ModelProperty& property : model_.properties) {
      if (std::ranges::any_of(property.weights, [&](const Vec3& w) { return lies(w); }))
        return "a property looks across it";
    }
    return {};
  }

  std::string obstacles() const {
    for (const Obstacle& obstacle : model_.obstacles) {
      bool leaves = lies(obstacle.velocity);
      if (obstacle.kind == Obstacle::Kind::Plane) leaves = leaves || lies(obstacle.normal);
      if (obstacle.kind == Obstacle::Kind::Sphere) leaves = leaves || lies(obstacle.centre - model_.nodes[0].x);
      if (obstacle.kind == Obstacle::Kind::Box) {
        leaves = leaves || std::ranges::any_of(lost_, [&](int c) { return std::isfinite(obstacle.halfSize[c]); });
      }
      if (leaves) return fmt::format("'{}' pushes out of it", obstacle.name);
    }
    return {};
  }

  std::string driven() const {
    for (const ModelExternalForce& force : model_.externalForces) {
      if (force.mayJump) return "a force may jump at times that nobody knows";
      for (const auto& [t, segment] : moments(force.times, scene_.duration)) {
        if (lies(force.force(t, segment))) return fmt::format("a force pushes out of it at {:.3g} s", t);
      }
    }
    for (const Motion& motion : model_.motions) {
      for (const auto& [t, segment] : moments(motion.times, scene_.duration)) {
        if (lies(motion.velocity(t, segment))) return fmt::format("a moved node leaves it at {:.3g} s", t);
      }
    }
    return {};
  }

  const Scene& scene_;
  const Model& model_;
  std::vector<int> lost_;
};

void leaveOutDamping(Model& model) {
  for (ModelSpring& spring : model.springs) spring.dRelative = spring.dProjected = spring.dampingRatio = 0.0;
}

void leaveOutAxis(Scene& scene, const Simplification& part) {
  scene.model.dimension = part.dimension;
  if (part.dimension == 2) {
    std::array<int, 2> left{};
    std::size_t n = 0;
    for (const int c : {0, 1, 2}) {
      if (c != part.axis) left[n++] = c;
    }
    scene.model.plane = scene.view = left;
  } else {
    scene.view = {0, 0};
  }
}

void pinNodes(Model& model, const std::vector<int>& nodes) {
  for (const int i : nodes) {
    model.nodes[static_cast<std::size_t>(i)].pinned = true;
    model.nodes[static_cast<std::size_t>(i)].v = Vec3::Zero();
  }
}

}  // namespace

std::string leavesPlane(const Scene& scene, int axis, int dimension) {
  return PlaneCheck(scene, dimension == 1 ? std::vector<int>{1, 2} : std::vector<int>{axis}).firstThatLeaves();
}

std::vector<Simplification> simplificationsOf(const Scene& scene) {
  const Model& model = scene.model;
  std::vector<Simplification> parts;
  const bool hasRods = std::ranges::any_of(model.springs, &ModelSpring::rod);
  if (model.dimension > 1 && !hasRods && leavesPlane(scene, 1, 1).empty()) {
    Simplification line{.kind = Simplification::Kind::Axis, .name = "all but the x axis"};
    line.axis = model.dimension == 2 ? model.plane[1] : 2;
    line.dimension = 1;
    parts.push_back(line);
  } else if (model.dimension == 3) {
    for (const int axis : {0, 1, 2}) {
      if (!leavesPlane(scene, axis, 2).empty()) continue;
      parts.push_back(
          {.kind = Simplification::Kind::Axis, .name = fmt::format("the {} axis", letters[axis]), .axis = axis});
      break;
    }
  }
  for (std::size_t i = 0; i < model.obstacles.size(); ++i) {
    Simplification contact{.kind = Simplification::Kind::Contact,
                           .name = fmt::format("contact with '{}'", model.obstacles[i].name)};
    contact.obstacle = i;
    parts.push_back(contact);
  }
  if (std::ranges::any_of(model.springs, isDamped)) {
    parts.push_back({.kind = Simplification::Kind::Damping, .name = "damping of springs"});
  }
  if (std::ranges::any_of(partsOf(model), [](const ModelPart& part) { return part.name == "drag"; })) {
    parts.push_back({.kind = Simplification::Kind::Drag, .name = "drag"});
  }
  addElements(scene, parts);
  return parts;
}

Scene without(const Scene& scene, const std::vector<Simplification>& parts) {
  Scene reduced = scene;
  std::vector<std::string> named;
  std::vector<std::size_t> obstacles;
  for (const Simplification& part : parts) {
    switch (part.kind) {
      case Simplification::Kind::Axis:
        leaveOutAxis(reduced, part);
        break;
      case Simplification::Kind::Contact:
        obstacles.push_back(part.obstacle);
        break;
      case Simplification::Kind::Damping:
        leaveOutDamping(reduced.model);
        break;
      case Simplification::Kind::Drag:
        named.emplace_back("drag");
        break;
      case Simplification::Kind::Elements:
        named.push_back(part.name);
        break;
      case Simplification::Kind::Motion:
        pinNodes(reduced.model, part.nodes);
        break;
      case Simplification::Kind::Digits:
        reduced.model.precision = kernels::Precision::Single;
        break;
    }
  }
  reduced.model = withoutParts(reduced.model, named);
  std::ranges::sort(obstacles, std::greater<>());
  for (const std::size_t i : obstacles) {
    reduced.model.obstacles.erase(reduced.model.obstacles.begin() + static_cast<std::ptrdiff_t>(i));
  }
  return reduced;
}

}  // namespace muelle::lab
