#include "engine/model/mass_spring_system.h"

#include <fmt/format.h>
#include <algorithm>
#include <stdexcept>

namespace muelle::engine {

void MassSpringSystem::place(double t, In z, Out x, Out v) const {
  for (const int node : moved_) {
    const auto index = static_cast<std::size_t>(nodeOf(node).motion);
    const Motion& motion = model_.motions[index];
    const int segment = motionSegments_.at(index, t, z);
    const Vec3 position = motion.position(t, segment), velocity = motion.velocity(t, segment);
    for (int c = 0; c < dimension_; ++c) {
      const int axis = numbering_.axes[static_cast<std::size_t>(c)];
      x[laneOf(node, c)] = position[axis];
      v[laneOf(node, c)] = velocity[axis];
    }
  }
}

void MassSpringSystem::everyNode(const State& state, std::vector<double>& x, std::vector<double>& v) const {
  x.clear();
  v.clear();
  for (const int node : numbering_.built) {
    for (int c = 0; c < dimension_; ++c) {
      x.push_back(state.x[laneOf(node, c)]);
      v.push_back(state.v[laneOf(node, c)]);
    }
  }
}

State MassSpringSystem::initialState() const {
  State state;
  state.x.assign(mass_.size(), 0.0);
  state.v.assign(mass_.size(), 0.0);
  // Places of a grid that no node has lie with the first node and not at the origin: a scene is as large as its nodes
  // say.
  for (std::size_t place = 0; numbering_.layout.isPlanar() && place < numbering_.user.size(); ++place) {
    for (int c = 0; c < dimension_; ++c) {
      const int axis = numbering_.axes[static_cast<std::size_t>(c)];
      state.x[laneOf(static_cast<int>(place), c)] = model_.nodes.front().x[axis];
    }
  }
  for (const int node : numbering_.built) {
    for (int c = 0; c < dimension_; ++c) {
      const int axis = numbering_.axes[static_cast<std::size_t>(c)];
      state.x[laneOf(node, c)] = nodeOf(node).x[axis];
      if (isFree(nodeOf(node))) state.v[laneOf(node, c)] = nodeOf(node).v[axis];
    }
  }
  place(state.t, state.z, state.x, state.v);
  commit(state, false);
  return state;
}

Vec3 MassSpringSystem::vectorOf(const std::vector<double>& values, int node) const {
  const int built = numbering_.built.at(static_cast<std::size_t>(node));
  Vec3 result = Vec3::Zero();
  for (int c = 0; c < dimension_; ++c) {
    result[numbering_.axes[static_cast<std::size_t>(c)]] = values[laneOf(built, c)];
  }
  return result;
}

Vec3 MassSpringSystem::position(const State& state, int node) const { return vectorOf(state.x, node); }

Vec3 MassSpringSystem::velocity(const State& state, int node) const { return vectorOf(state.v, node); }

/// The component of an axis of the user's; throws std::out_of_range where the scene has none such.
int MassSpringSystem::componentOf(int axis) const {
  const auto found = std::find(numbering_.axes.begin(), numbering_.axes.end(), axis);
  if (found != numbering_.axes.end()) return static_cast<int>(found - numbering_.axes.begin());
  throw std::out_of_range(fmt::format("axis {} is none of this {}D scene", axis, dimension_));
}

int MassSpringSystem::lane(int node, int axis) const {
  if (node < 0 || node >= nodeCount()) {
    throw std::out_of_range(fmt::format("there is no node {}; nodes are 0 to {}", node, nodeCount() - 1));
  }
  return numbering_.layout.lane(numbering_.built[static_cast<std::size_t>(node)], componentOf(axis));
}

int MassSpringSystem::unknown(int node, int axis) const {
  const int place = lane(node, axis);
  if (!(mass_[static_cast<std::size_t>(place)] > 0.0)) return -1;
  const int built = numbering_.built[static_cast<std::size_t>(node)];
  return dimension_ * numbering_.rank[static_cast<std::size_t>(built)] + componentOf(axis);
}

std::string MassSpringSystem::unknownName(int i) const {
  const int axis = numbering_.axes[static_cast<std::size_t>(i % dimension_)];
  const int built = numbering_.freeNodes[static_cast<std::size_t>(i / dimension_)];
  return fmt::format("node {}, {}", numbering_.user[static_cast<std::size_t>(built)], "xyz"[axis]);
}

}  // namespace muelle::engine
