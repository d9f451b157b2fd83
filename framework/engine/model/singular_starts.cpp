#include "engine/model/singular_starts.h"

#include <fmt/format.h>
#include <Eigen/Geometry>

namespace muelle::engine {

namespace {

/// Rounding of positions: below this part of the lengths around a point counts as met.
constexpr double rounding = 1e-12;

/// The position with the components that the scene has.
Vec3 placeOf(const Model& model, int node) {
  const Vec3& x = model.nodes[static_cast<std::size_t>(node)].x;
  if (model.dimension == 1) return {x[0], 0.0, 0.0};
  if (model.dimension == 3) return x;
  Vec3 place = Vec3::Zero();
  for (const int axis : model.plane) place[axis] = x[axis];
  return place;
}

bool anyIsFree(const Model& model, std::initializer_list<int> nodes) {
  for (const int node : nodes) {
    if (isFree(model.nodes[static_cast<std::size_t>(node)])) return true;
  }
  return false;
}

std::string ofSpring(const Model& model, std::size_t i) {
  const ModelSpring& spring = model.springs[i];
  if (!(spring.L0 > 0.0) || spring.k == 0.0 || !anyIsFree(model, {spring.a, spring.b})) return {};
  if ((placeOf(model, spring.a) - placeOf(model, spring.b)).norm() > rounding * spring.L0) return {};
  return fmt::format(
      "nodes {} and {} start in one place, and spring {} between them is {:.3g} m long: its force has no "
      "direction there",
      spring.a, spring.b, i, spring.L0);
}

std::string ofAngle(const Model& model, std::size_t i) {
  const ModelAngle& angle = model.angles[i];
  if (angle.k == 0.0 || !anyIsFree(model, {angle.a, angle.b, angle.c})) return {};
  const Vec3 in = placeOf(model, angle.b) - placeOf(model, angle.a);
  const Vec3 out = placeOf(model, angle.c) - placeOf(model, angle.b);
  const double size = in.norm() * out.norm();
  const bool inLine = size > 0.0 && in.cross(out).norm() <= rounding * size;
  if (!inLine) return {};
  const bool folded = in.dot(out) < 0.0;
  if (folded) {
    return fmt::format("angle {} at node {} starts folded back onto itself: it has no side to open to", i, angle.b);
  }
  if (model.dimension != 3 || angle.theta0 == 0.0) return {};
  return fmt::format("angle {} at node {} starts straight and wants {:.3g} rad: it has no side to bend to", i, angle.b,
                     angle.theta0);
}

std::string ofBall(const Model& model, const Obstacle& obstacle, int node) {
  if (obstacle.kind != Obstacle::Kind::Sphere || !isFree(model.nodes[static_cast<std::size_t>(node)])) return {};
  if ((placeOf(model, node) - obstacle.centre).norm() > rounding * obstacle.radius) return {};
  return fmt::format("node {} starts at the centre of '{}', which has no side to push it out of", node, obstacle.name);
}

}  // namespace

std::vector<std::string> singularStarts(const Model& model) {
  std::vector<std::string> found;
  const auto add = [&found](std::string sentence) {
    if (!sentence.empty()) found.push_back(std::move(sentence));
  };
  for (std::size_t i = 0; i < model.springs.size(); ++i) add(ofSpring(model, i));
  for (std::size_t i = 0; i < model.angles.size(); ++i) add(ofAngle(model, i));
  for (const Obstacle& obstacle : model.obstacles) {
    for (int node = 0; node < static_cast<int>(model.nodes.size()); ++node) add(ofBall(model, obstacle, node));
  }
  return found;
}

}  // namespace muelle::engine
