#include "engine/model/mass_spring_system.h"

#include <fmt/format.h>
#include <algorithm>
#include <stdexcept>

namespace muelle::engine {

void MassSpringSystem::setFixed(double t, In z, Arrays& arrays) const {
  for (const int i : moved_) {
    const ModelNode& node = model_.nodes[static_cast<std::size_t>(numbering_.user[static_cast<std::size_t>(i)])];
    const auto index = static_cast<std::size_t>(node.motion);
    const Motion& motion = model_.motions[index];
    const int segment = motionSegments_.at(index, t, z);
    const Vec3 x = motion.position(t, segment), v = motion.velocity(t, segment);
    for (int c = 0; c < dimension_; ++c) {
      const int axis = numbering_.axes[static_cast<std::size_t>(c)];
      arrays.x[place(i, c)] = x[axis];
      arrays.v[place(i, c)] = v[axis];
    }
  }
}

Configuration MassSpringSystem::gather(double t, In x, In v, In z, Arrays& arrays) const {
  if (!hasFixed_) return {t, x.data(), v.data(), z.data()};
  std::copy(x.begin(), x.end(), arrays.x.begin());
  std::copy(v.begin(), v.end(), arrays.v.begin());
  setFixed(t, z, arrays);
  return {t, arrays.x.data(), arrays.v.data(), z.data()};
}

void MassSpringSystem::everyNode(const State& state, std::vector<double>& x, std::vector<double>& v) const {
  x = state.x;
  v = state.v;
  if (!hasFixed_) return;
  gather(state.t, state.x, state.v, state.z, first_);
  x = first_.x;
  v = first_.v;
}

State MassSpringSystem::initialState() const {
  State state;
  state.x.resize(static_cast<std::size_t>(size_));
  state.v.resize(static_cast<std::size_t>(size_));
  for (int i = 0; i < size_; ++i) {
    const ModelNode& node =
        model_.nodes[static_cast<std::size_t>(numbering_.user[static_cast<std::size_t>(i / dimension_)])];
    const int axis = numbering_.axes[static_cast<std::size_t>(i % dimension_)];
    state.x[static_cast<std::size_t>(i)] = node.x[axis];
    state.v[static_cast<std::size_t>(i)] = node.v[axis];
  }
  commit(state, false);
  return state;
}

Vec3 MassSpringSystem::component(const State& state, int node, bool velocity) const {
  const int built = numbering_.built.at(static_cast<std::size_t>(node));
  Vec3 result = Vec3::Zero();
  if (built >= numbering_.freeNodes) {
    const ModelNode& fixed = model_.nodes[static_cast<std::size_t>(node)];
    Vec3 full = velocity ? Vec3(Vec3::Zero()) : fixed.x;
    if (fixed.motion >= 0) {
      const auto index = static_cast<std::size_t>(fixed.motion);
      const Motion& motion = model_.motions[index];
      const int segment = motionSegments_.at(index, state.t, state.z);
      full = velocity ? motion.velocity(state.t, segment) : motion.position(state.t, segment);
    }
    for (const int axis : numbering_.axes) result[axis] = full[axis];
    return result;
  }
  const std::vector<double>& values = velocity ? state.v : state.x;
  for (int c = 0; c < dimension_; ++c) {
    result[numbering_.axes[static_cast<std::size_t>(c)]] = values[place(built, c)];
  }
  return result;
}

Vec3 MassSpringSystem::position(const State& state, int node) const { return component(state, node, false); }

Vec3 MassSpringSystem::velocity(const State& state, int node) const { return component(state, node, true); }

int MassSpringSystem::unknown(int node, int axis) const {
  if (node < 0 || node >= nodeCount()) {
    throw std::out_of_range(fmt::format("there is no node {}; nodes are 0 to {}", node, nodeCount() - 1));
  }
  const auto found = std::find(numbering_.axes.begin(), numbering_.axes.end(), axis);
  if (found == numbering_.axes.end()) {
    throw std::out_of_range(fmt::format("axis {} is none of this {}D scene", axis, dimension_));
  }
  const int built = numbering_.built[static_cast<std::size_t>(node)];
  if (built >= numbering_.freeNodes) return -1;
  return dimension_ * built + static_cast<int>(found - numbering_.axes.begin());
}

std::string MassSpringSystem::unknownName(int i) const {
  const int axis = numbering_.axes[static_cast<std::size_t>(i % dimension_)];
  return fmt::format("node {}, {}", numbering_.user[static_cast<std::size_t>(i / dimension_)], "xyz"[axis]);
}

}  // namespace muelle::engine
