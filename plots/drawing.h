#pragma once
#include "engine/model/model_system.h"
#include "harness/figure.h"

#include <limits>
#include <vector>

namespace muelle::plots {

/// Lines that do not hang together, as one curve with gaps: x across, z up.
struct Segments {
  std::vector<double> x, y;

  void add(const Vec3& a, const Vec3& b) {
    const double gap = std::numeric_limits<double>::quiet_NaN();
    x.insert(x.end(), {a.x(), b.x(), gap});
    y.insert(y.end(), {a.z(), b.z(), gap});
  }
};

/// Arrows at points: x across, z up.
struct Arrows {
  std::vector<double> x, y, dx, dy;

  void add(const Vec3& at, const Vec3& by) {
    x.push_back(at.x());
    y.push_back(at.z());
    dx.push_back(by.x());
    dy.push_back(by.z());
  }
  void addTo(Figure::PanelBuilder& panel, const std::string& name, int colour) const {
    panel.arrows(name, x, y, dx, dy).colour(colour);
  }
};

/// The springs of a system, drawn straight from node to node.
inline Segments springsOf(const engine::ModelSystem& system, const State& state) {
  Segments lines;
  for (const engine::ModelSpring& spring : system.model().springs) {
    lines.add(system.position(state, spring.a), system.position(state, spring.b));
  }
  return lines;
}

/// Puts a free node somewhere else.
inline void moveTo(const engine::ModelSystem& system, State& state, int node, const Vec3& position) {
  for (int axis = 0; axis < 3; ++axis) {
    if (system.model().dimension == 2 && axis == 1) continue;
    state.x[static_cast<std::size_t>(system.lane(node, axis))] = position[axis];
  }
}

/// The force on a free node [N] (scenes in space or in the plane of x and z).
inline Vec3 forceOn(const engine::ModelSystem& system, const State& state, int node) {
  std::vector<double> all(state.x.size());
  system.force(state.t, state.x, state.v, state.z, all);
  Vec3 force = Vec3::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    if (system.model().dimension == 2 && axis == 1) continue;
    force[axis] = all[static_cast<std::size_t>(system.lane(node, axis))];
  }
  return force;
}

}  // namespace muelle::plots
