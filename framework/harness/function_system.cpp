#include "harness/function_system.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace muelle {

namespace {

void requireFree(const Node& node, std::size_t index) {
  if (node.pinned) {
    throw std::invalid_argument(
        fmt::format("node {} is pinned: keep fixed points out of the state, as constants of the force", index));
  }
}

}  // namespace

FunctionSystem::FunctionSystem(std::vector<double> mass, ForceFunction force)
    : mass_(std::move(mass)), force_(std::move(force)) {
  if (!force_) throw std::invalid_argument("FunctionSystem: the force function is empty");
  for (std::size_t i = 0; i < mass_.size(); ++i) {
    if (!(mass_[i] > 0.0) || !std::isfinite(mass_[i])) {
      throw std::invalid_argument(
          fmt::format("FunctionSystem: mass {} is {} kg; a mass is positive and finite", i, mass_[i]));
    }
  }
}

void FunctionSystem::force(double t, In x, In v, In, Out f) const { force_(t, x, v, f); }

State stateOf(const std::vector<Node>& nodes) {
  State state;
  state.x.reserve(3 * nodes.size());
  state.v.reserve(3 * nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    requireFree(nodes[i], i);
    state.x.insert(state.x.end(), nodes[i].x.begin(), nodes[i].x.end());
    state.v.insert(state.v.end(), nodes[i].v.begin(), nodes[i].v.end());
  }
  return state;
}

std::vector<double> massesOf(const std::vector<Node>& nodes) {
  std::vector<double> masses;
  masses.reserve(3 * nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    requireFree(nodes[i], i);
    masses.insert(masses.end(), 3, nodes[i].m);
  }
  return masses;
}

}  // namespace muelle
