#include "engine/statics/support.h"

#include "engine/forces/segment.h"
#include "engine/scene/joined_sets.h"

namespace muelle::engine {

namespace {

/// What hangs together by springs and elements that have a stiffness.
JoinedSets joined(const Model& model) {
  JoinedSets sets(static_cast<int>(model.nodes.size()));
  const auto join = [&](double k, const auto& nodes) {
    if (!(k > 0.0)) return;
    for (const int node : nodes) sets.join(nodes.front(), node);
  };
  for (const ModelSpring& s : model.springs) join(s.k, std::array{s.a, s.b});
  forEachElementKind(model, [&](const auto& elements) {
    for (const auto& element : elements) join(element.k, element.nodes);
  });
  return sets;
}

/// Gravity and external forces on each node [N].
std::vector<Vec3> loadsOf(const ModelSystem& system, double t) {
  const Model& model = system.model();
  std::vector<Vec3> all(model.nodes.size(), Vec3::Zero());
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (isFree(model.nodes[i])) all[i] = model.nodes[i].m * model.gravity;
  }
  for (const ModelExternalForce& external : model.externalForces) {
    const Vec3 F = external.force(t, segmentAt(external.times, t));
    for (const int node : external.nodes) {
      if (isFree(model.nodes[static_cast<std::size_t>(node)])) all[static_cast<std::size_t>(node)] += F;
    }
  }
  return all;
}

}  // namespace

std::optional<Unsupported> findUnsupported(const ModelSystem& system, double t) {
  const Model& model = system.model();
  if (!model.obstacles.empty()) return std::nullopt;
  JoinedSets sets = joined(model);
  const std::size_t count = model.nodes.size();
  std::vector<bool> held(count, false);
  for (std::size_t i = 0; i < count; ++i) {
    if (!isFree(model.nodes[i])) held[static_cast<std::size_t>(sets.of(static_cast<int>(i)))] = true;
  }
  for (const ModelProperty& property : model.properties) {
    for (const int node : property.nodes) held[static_cast<std::size_t>(sets.of(node))] = true;
  }
  const std::vector<Vec3> loads = loadsOf(system, t);
  std::vector<Vec3> sum(count, Vec3::Zero());
  std::vector<double> size(count, 0.0);
  for (std::size_t i = 0; i < count; ++i) {
    const auto set = static_cast<std::size_t>(sets.of(static_cast<int>(i)));
    sum[set] += loads[i];
    size[set] += loads[i].norm();
  }
  for (std::size_t i = 0; i < count; ++i) {
    const int set = sets.of(static_cast<int>(i));
    const auto at = static_cast<std::size_t>(set);
    // Sums of so many numbers are known to 1e-12 of their size.
    if (held[at] || !(sum[at].norm() > 1e-12 * size[at])) continue;
    Unsupported found;
    found.load = sum[at];
    for (std::size_t j = i; j < count; ++j) {
      if (sets.of(static_cast<int>(j)) == set) found.nodes.push_back(static_cast<int>(j));
    }
    return found;
  }
  return std::nullopt;
}

}  // namespace muelle::engine
