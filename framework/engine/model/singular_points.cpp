#include "engine/model/singular_points.h"

#include <fmt/format.h>
#include <algorithm>
#include <Eigen/Geometry>

namespace muelle::engine {

namespace {

using Kind = SingularPoint::Kind;
using Places = std::vector<Vec3>;

/// Below this part of the lengths around a point counts as met.
constexpr double closeness = 1e-9;

const Vec3& placeOf(const Places& places, int node) { return places[static_cast<std::size_t>(node)]; }

/// Collects points, with their free nodes; one at which all nodes are held is none.
class Finder {
 public:
  explicit Finder(const Model& model) : model_(model) {}

  void add(Kind kind, std::size_t item, std::initializer_list<int> nodes, bool isAngle = false) {
    SingularPoint point{kind, static_cast<int>(item), isAngle, {}};
    for (const int node : nodes) {
      if (isFree(model_.nodes[static_cast<std::size_t>(node)])) point.nodes.push_back(node);
    }
    if (point.nodes.empty()) return;
    std::ranges::sort(point.nodes);
    found.push_back(std::move(point));
  }

  std::vector<SingularPoint> found;

 private:
  const Model& model_;
};

void lookAtSpring(const ModelSpring& spring, std::size_t i, const Places& places, Finder& finder) {
  if (!(spring.L0 > 0.0) || spring.k == 0.0 || spring.isSigned) return;
  const double length = (placeOf(places, spring.a) - placeOf(places, spring.b)).norm();
  if (length <= closeness * spring.L0) finder.add(Kind::Coincident, i, {spring.a, spring.b});
}

void lookAtAngle(const ModelAngle& angle, std::size_t i, int dimension, const Places& places, Finder& finder) {
  if (angle.k == 0.0) return;
  const Vec3 in = placeOf(places, angle.b) - placeOf(places, angle.a);
  const Vec3 out = placeOf(places, angle.c) - placeOf(places, angle.b);
  const double longer = std::max(in.norm(), out.norm());
  if (std::min(in.norm(), out.norm()) <= closeness * longer) {
    finder.add(Kind::WithoutSize, i, {angle.a, angle.b, angle.c}, true);
  } else if (in.cross(out).norm() <= closeness * in.norm() * out.norm()) {
    const bool folded = in.dot(out) < 0.0;
    const bool hasSide = dimension == 2 || angle.theta0 == 0.0;
    if (folded || !hasSide) finder.add(folded ? Kind::Folded : Kind::Straight, i, {angle.a, angle.b, angle.c}, true);
  }
}

void lookAtDihedral(const ModelDihedral& hinge, std::size_t i, const Places& places, Finder& finder) {
  if (hinge.k == 0.0) return;
  const Vec3& a = placeOf(places, hinge.a);
  const Vec3 e = placeOf(places, hinge.b) - a, p = placeOf(places, hinge.c) - a, q = placeOf(places, hinge.d) - a;
  const Vec3 first = e.cross(p), second = q.cross(e);  // normals, equal when flat
  const double size = std::max({e.squaredNorm(), p.squaredNorm(), q.squaredNorm()});
  if (std::min(first.norm(), second.norm()) <= closeness * size) {
    finder.add(Kind::WithoutSize, i, {hinge.a, hinge.b, hinge.c, hinge.d});
  } else if (first.dot(second) < 0.0 && first.cross(second).norm() <= closeness * first.norm() * second.norm()) {
    finder.add(Kind::Folded, i, {hinge.a, hinge.b, hinge.c, hinge.d});
  }
}

/// Components that the scene does not have are 0.
Vec3 inScene(const Model& model, const Vec3& x) {
  if (model.dimension == 3) return x;
  Vec3 kept = Vec3::Zero();
  for (int i = 0; i < model.dimension; ++i) {
    const int axis = model.dimension == 1 ? 0 : model.plane[static_cast<std::size_t>(i)];
    kept[axis] = x[axis];
  }
  return kept;
}

/// (A box has no such place: a node in it is pushed out through the face that it is at, however it moves then.)
void lookAtObstacle(const Model& model, std::size_t i, const Places& places, double t, Finder& finder) {
  const Obstacle& obstacle = model.obstacles[i];
  if (obstacle.kind != Obstacle::Kind::Sphere || obstacle.material.k == 0.0) return;
  const Vec3 centre = inScene(model, obstacle.centre + std::min(t, obstacle.stopTime) * obstacle.velocity);
  for (int node = 0; node < static_cast<int>(places.size()); ++node) {
    if ((placeOf(places, node) - centre).norm() <= closeness * obstacle.radius) {
      finder.add(Kind::BallCentre, i, {node});
    }
  }
}

std::string ofAngle(const Model& model, const SingularPoint& point) {
  const ModelAngle& angle = model.angles[static_cast<std::size_t>(point.item)];
  switch (point.kind) {
    case Kind::Straight:
      return fmt::format("angle {} at node {} is straight and wants {:.3g} rad: it has no side to bend to", point.item,
                         angle.b, angle.theta0);
    case Kind::Folded:
      return fmt::format("angle {} at node {} is folded back onto itself: it has no side to open to", point.item,
                         angle.b);
    default:
      return fmt::format("angle {} at node {} has an edge without length: it is no angle", point.item, angle.b);
  }
}

std::string ofDihedral(const Model& model, const SingularPoint& point) {
  const ModelDihedral& hinge = model.dihedrals[static_cast<std::size_t>(point.item)];
  const std::string edge = fmt::format("dihedral {} at the edge of nodes {} and {}", point.item, hinge.a, hinge.b);
  if (point.kind == Kind::Folded) return edge + " is folded back onto itself: it has no side to open to";
  return edge + " has a triangle without area: it is no angle";
}

}  // namespace

std::vector<SingularPoint> singularPoints(const Model& model, const Places& places, double t) {
  Finder finder(model);
  for (std::size_t i = 0; i < model.springs.size(); ++i) lookAtSpring(model.springs[i], i, places, finder);
  for (std::size_t i = 0; i < model.angles.size(); ++i) {
    lookAtAngle(model.angles[i], i, model.dimension, places, finder);
  }
  for (std::size_t i = 0; i < model.dihedrals.size(); ++i) lookAtDihedral(model.dihedrals[i], i, places, finder);
  for (std::size_t i = 0; i < model.obstacles.size(); ++i) lookAtObstacle(model, i, places, t, finder);
  return std::move(finder.found);
}

std::vector<SingularPoint> singularPoints(const ModelSystem& system, const State& state) {
  Places places;
  for (int node = 0; node < system.nodeCount(); ++node) places.push_back(system.position(state, node));
  return singularPoints(system.model(), places, state.t);
}

std::string describe(const Model& model, const SingularPoint& point) {
  const auto item = static_cast<std::size_t>(point.item);
  switch (point.kind) {
    case Kind::Coincident: {
      const ModelSpring& spring = model.springs[item];
      return fmt::format(
          "nodes {} and {} lie in one place, and spring {} between them is {:.3g} m long: its force has no "
          "direction there",
          spring.a, spring.b, point.item, spring.L0);
    }
    case Kind::BallCentre:
      return fmt::format("node {} lies at the centre of '{}', which has no side to push it out of", point.nodes.front(),
                         model.obstacles[item].name);
    default:
      return point.isAngle || point.kind == Kind::Straight ? ofAngle(model, point) : ofDihedral(model, point);
  }
}

}  // namespace muelle::engine
