#include "engine/model/singular_points.h"

#include <fmt/format.h>
#include <algorithm>

namespace muelle::engine {

namespace {

using Places = std::vector<Vec3>;

const Vec3& placeOf(const Places& places, int node) { return places[static_cast<std::size_t>(node)]; }

/// Collects points, with their free nodes; one at which all nodes are held is none.
class Finder {
 public:
  Finder(const Model& model, const Places& places) : model_(model), places_(places) {}

  void lookAtSprings();
  template <class Element>
  void lookAtElements(const std::vector<Element>& elements);
  /// (A box has no such place: a node in it is pushed out through the face that it is at, however it moves then.)
  void lookAtObstacles(double t);

  std::vector<SingularPoint> found;

 private:
  template <class Nodes>
  void add(Singularity kind, std::string what, const Nodes& nodes) {
    SingularPoint point{kind, std::move(what), {}};
    for (const int node : nodes) {
      if (isFree(model_.nodes[static_cast<std::size_t>(node)])) point.nodes.push_back(node);
    }
    if (point.nodes.empty()) return;
    std::ranges::sort(point.nodes);
    found.push_back(std::move(point));
  }

  const Model& model_;
  const Places& places_;
};

void Finder::lookAtSprings() {
  for (std::size_t i = 0; i < model_.springs.size(); ++i) {
    const ModelSpring& spring = model_.springs[i];
    if (!(spring.L0 > 0.0) || spring.k == 0.0 || spring.isSigned) continue;
    const double length = (placeOf(places_, spring.a) - placeOf(places_, spring.b)).norm();
    if (length > singularCloseness * spring.L0) continue;
    add(Singularity::Coincident,
        fmt::format("nodes {} and {} lie in one place, and spring {} between them is {:.3g} m long: its force has no "
                    "direction there",
                    spring.a, spring.b, i, spring.L0),
        std::array{spring.a, spring.b});
  }
}

template <class Element>
void Finder::lookAtElements(const std::vector<Element>& elements) {
  for (std::size_t i = 0; i < elements.size(); ++i) {
    if (elements[i].k == 0.0) continue;
    const std::optional<ElementSingularity> singular = elements[i].singularity(model_.dimension, places_);
    if (singular) add(singular->kind, fmt::format("{} {} {}", Element::kind, i, singular->what), elements[i].nodes);
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

void Finder::lookAtObstacles(double t) {
  for (const Obstacle& obstacle : model_.obstacles) {
    if (obstacle.kind != Obstacle::Kind::Sphere || obstacle.material.k == 0.0) continue;
    const Vec3 centre = inScene(model_, obstacle.centre + std::min(t, obstacle.stopTime) * obstacle.velocity);
    for (int node = 0; node < static_cast<int>(places_.size()); ++node) {
      if ((placeOf(places_, node) - centre).norm() > singularCloseness * obstacle.radius) continue;
      add(Singularity::BallCentre,
          fmt::format("node {} lies at the centre of '{}', which has no side to push it out of", node, obstacle.name),
          std::array{node});
    }
  }
}

}  // namespace

std::vector<SingularPoint> singularPoints(const Model& model, const Places& places, double t) {
  Finder finder(model, places);
  finder.lookAtSprings();
  forEachElementKind(model, [&](const auto& elements) { finder.lookAtElements(elements); });
  finder.lookAtObstacles(t);
  return std::move(finder.found);
}

std::vector<SingularPoint> singularPoints(const ModelSystem& system, const State& state) {
  Places places;
  for (int node = 0; node < system.nodeCount(); ++node) places.push_back(system.position(state, node));
  return singularPoints(system.model(), places, state.t);
}

}  // namespace muelle::engine
