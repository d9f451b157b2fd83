#include "lab/advise/model_part.h"

#include "engine/model/axes.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <set>

namespace muelle::lab {

using namespace engine;

namespace {

constexpr const char* letters = "xyz";

bool isDamped(const ModelSpring& spring) {
  return spring.dRelative > 0.0 || spring.dProjected > 0.0 || spring.dampingRatio > 0.0;
}

bool isOf(const Part& part, int node) { return node >= part.firstNode && node < part.firstNode + part.nodeCount; }

/// How many nodes a row of a grid has, told from its springs: rows are joined inside by springs to the next node.
int rowOf(const Model& model, const Part& part) {
  const auto count = [&](int apart) {
    return std::ranges::count_if(model.springs, [&](const ModelSpring& spring) {
      return isOf(part, spring.a) && isOf(part, spring.b) && spring.b - spring.a == apart;
    });
  };
  const auto rows = part.nodeCount - static_cast<int>(count(1));
  if (rows < 2 || part.nodeCount % rows != 0) return 0;
  const int row = part.nodeCount / rows;
  return row > 1 && count(row) == static_cast<long>(row) * (rows - 1) ? row : 0;
}

/// The springs of an object that join nodes so far apart in number.
std::vector<int> springsApart(const Model& model, const Part& part, const std::set<int>& apart) {
  std::vector<int> found;
  for (std::size_t i = 0; i < model.springs.size(); ++i) {
    const ModelSpring& spring = model.springs[i];
    if (isOf(part, spring.a) && isOf(part, spring.b) && apart.contains(std::abs(spring.b - spring.a))) {
      found.push_back(static_cast<int>(i));
    }
  }
  return found;
}

void addLists(const Scene& scene, const Part& part, std::vector<ModelPart>& parts) {
  const Model& model = scene.model;
  const auto add = [&](ModelPart::Kind kind, const char* list, std::vector<int> items) {
    if (items.empty()) return;
    ModelPart found;
    found.kind = kind;
    found.name = part.name + "." + list;
    found.items = std::move(items);
    found.table = part.name;
    parts.push_back(std::move(found));
  };
  const int row = rowOf(model, part);
  // In a narrow grid two kinds of springs join nodes equally far apart in number.
  if (row > 4 && !part.triangles.empty()) {
    add(ModelPart::Kind::Springs, "shear", springsApart(model, part, {row - 1, row + 1}));
    add(ModelPart::Kind::Springs, "bend", springsApart(model, part, {2, 2 * row}));
  }
  std::vector<int> angles, dihedrals;
  for (std::size_t i = 0; i < model.angles.size(); ++i) {
    if (isOf(part, model.angles[i].b)) angles.push_back(static_cast<int>(i));
  }
  for (std::size_t i = 0; i < model.dihedrals.size(); ++i) {
    if (isOf(part, model.dihedrals[i].a)) dihedrals.push_back(static_cast<int>(i));
  }
  add(ModelPart::Kind::Angles, "angles", std::move(angles));
  add(ModelPart::Kind::Dihedrals, "dihedrals", std::move(dihedrals));
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
    if (!model_.dihedrals.empty() || !model_.volumes.empty()) return "it has dihedrals or volumes, which are of space";
    const bool bent = std::ranges::any_of(model_.angles, [](const ModelAngle& angle) { return angle.theta0 != 0.0; });
    if (bent) return "angles at rest out of line have a sign in a plane and none in space";
    if (!model_.areas.empty()) return "areas are seen along a direction";
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

template <class T>
void drop(std::vector<T>& from, const std::vector<int>& items) {
  std::vector<T> kept;
  const std::set<int> out(items.begin(), items.end());
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (!out.contains(static_cast<int>(i))) kept.push_back(from[i]);
  }
  from = std::move(kept);
}

void leaveOutDamping(Model& model) {
  for (ModelSpring& spring : model.springs) spring.dRelative = spring.dProjected = spring.dampingRatio = 0.0;
}

void leaveOutAxis(Scene& scene, const ModelPart& part) {
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

std::vector<ModelPart> partsOf(const Scene& scene) {
  const Model& model = scene.model;
  std::vector<ModelPart> parts;
  const bool hasRods = std::ranges::any_of(model.springs, &ModelSpring::rod);
  if (model.dimension > 1 && !hasRods && leavesPlane(scene, 1, 1).empty()) {
    ModelPart line{.kind = ModelPart::Kind::Axis, .name = "all but the x axis"};
    line.axis = model.dimension == 2 ? model.plane[1] : 2;
    line.dimension = 1;
    parts.push_back(line);
  } else if (model.dimension == 3) {
    for (const int axis : {0, 1, 2}) {
      if (!leavesPlane(scene, axis, 2).empty()) continue;
      parts.push_back({.kind = ModelPart::Kind::Axis, .name = fmt::format("the {} axis", letters[axis]), .axis = axis});
      break;
    }
  }
  for (std::size_t i = 0; i < model.obstacles.size(); ++i) {
    ModelPart contact{.kind = ModelPart::Kind::Contact,
                      .name = fmt::format("contact with '{}'", model.obstacles[i].name)};
    contact.obstacle = i;
    parts.push_back(contact);
  }
  if (std::ranges::any_of(model.springs, isDamped)) {
    parts.push_back({.kind = ModelPart::Kind::Damping, .name = "damping of springs"});
  }
  if (std::ranges::any_of(model.nodes, [](const ModelNode& node) { return node.drag > 0.0; })) {
    parts.push_back({.kind = ModelPart::Kind::Drag, .name = "drag"});
  }
  for (const Part& part : scene.parts) addLists(scene, part, parts);
  return parts;
}

Scene without(const Scene& scene, const std::vector<ModelPart>& parts) {
  Scene reduced = scene;
  Model& model = reduced.model;
  std::vector<int> springs, angles, dihedrals, obstacles;
  const auto join = [](std::vector<int>& all, const std::vector<int>& more) {
    all.insert(all.end(), more.begin(), more.end());
  };
  for (const ModelPart& part : parts) {
    switch (part.kind) {
      case ModelPart::Kind::Axis:
        leaveOutAxis(reduced, part);
        break;
      case ModelPart::Kind::Contact:
        obstacles.push_back(static_cast<int>(part.obstacle));
        break;
      case ModelPart::Kind::Damping:
        leaveOutDamping(model);
        break;
      case ModelPart::Kind::Drag:
        for (ModelNode& node : model.nodes) node.drag = 0.0;
        break;
      case ModelPart::Kind::Springs:
        join(springs, part.items);
        break;
      case ModelPart::Kind::Angles:
        join(angles, part.items);
        break;
      case ModelPart::Kind::Dihedrals:
        join(dihedrals, part.items);
        break;
      case ModelPart::Kind::Motion:
        pinNodes(model, part.items);
        break;
    }
  }
  drop(model.springs, springs);
  drop(model.angles, angles);
  drop(model.dihedrals, dihedrals);
  drop(model.obstacles, obstacles);
  return reduced;
}

}  // namespace muelle::lab
