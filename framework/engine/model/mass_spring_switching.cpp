#include "engine/model/mass_spring_system.h"

#include "engine/model/state_modes.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace muelle::engine {

void MassSpringSystem::guards(double t, In x, In v, In z, Out g) const {
  const Configuration at = configuration(t, x, v, z);
  std::size_t next = 0;
  for (const auto& batch : batches_) {
    batch->guards(at, g.data() + next);
    next += static_cast<std::size_t>(batch->guardCount());
  }
}

std::string MassSpringSystem::guardName(int i) const {
  for (const auto& batch : batches_) {
    if (i < batch->guardCount()) return batch->guardName(i);
    i -= batch->guardCount();
  }
  throw std::out_of_range("no such guard");
}

std::string MassSpringSystem::eventName(int i, const State& after) const {
  for (const auto& batch : batches_) {
    if (i < batch->guardCount()) return batch->eventName(i, after.z.data());
    i -= batch->guardCount();
  }
  throw std::out_of_range("no such guard");
}

void MassSpringSystem::declaredTimes(double from, double to, std::vector<double>& times) const {
  std::vector<double> own;
  for (const auto& batch : batches_) batch->declaredTimes(from, to, own);
  motionSegments_.declaredTimes(from, to, own);
  std::sort(own.begin(), own.end());
  own.erase(std::unique(own.begin(), own.end()), own.end());
  times.insert(times.end(), own.begin(), own.end());
}

bool MassSpringSystem::commit(State& state, bool frozen) const {
  bool changed = false;
  if (static_cast<int>(state.z.size()) != internalSize_) {
    state.z.assign(static_cast<std::size_t>(internalSize_), 0.0);
    changed = true;
  }
  changed = motionSegments_.commit(state.t, frozen, state.z.data()) || changed;
  place(state.t, state.z, state.x, state.v);
  const Configuration at = configuration(state.t, state.x, state.v, state.z);
  bool balance = false;
  for (const auto& batch : batches_) {
    changed = batch->commit(at, frozen, state.z.data()) || changed;
    balance = balance || batch->wantsBalance();
  }
  if (balance) changed = balanceFriction(at, state) || changed;
  return changed;
}

/// Second part of a commit: gives friction at rest what the other forces ask of it.
bool MassSpringSystem::balanceFriction(const Configuration& at, State& state) const {
  bool changed = false;
  double* sum = scratch_.data();
  std::fill(scratch_.begin(), scratch_.end(), 0.0);
  for (const auto& batch : batches_) batch->addForceWithoutFriction(at, sum);
  if (drag_) drag_->addForce(at, sum);
  for (const auto& batch : batches_) changed = batch->balance(at, sum, state.z.data()) || changed;
  return changed;
}

void MassSpringSystem::cross(int guard, State& state) const {
  const Configuration at = configuration(state.t, state.x, state.v, state.z);
  for (const auto& batch : batches_) {
    if (guard < batch->guardCount()) {
      batch->cross(guard, at, state.z.data());
      if (batch->wantsBalance()) balanceFriction(at, state);
      return;
    }
    guard -= batch->guardCount();
  }
  throw std::out_of_range("no such guard");
}

void MassSpringSystem::close(State& state) const {
  state.z.resize(static_cast<std::size_t>(internalSize_), 0.0);
  const std::vector<double> before = state.z;
  const Configuration at = configuration(state.t, state.x, state.v, before);
  for (const auto& batch : batches_) batch->close(at, state.z.data());
}

double MassSpringSystem::shortestBounce(const State& state) const {
  const StateModes modes(state, internalSize_);
  const Configuration at = configuration(state.t, state.x, state.v, modes.z);
  double shortest = std::numeric_limits<double>::infinity();
  for (const auto& batch : batches_) shortest = std::min(shortest, batch->shortestBounce(at));
  return shortest;
}

double MassSpringSystem::sweptBound(double t, In x, In v, In z, double h) const {
  if (std::none_of(batches_.begin(), batches_.end(), [](const auto& batch) { return batch->isThin(); })) return h;
  acceleration(t, x, v, z, scratch_);
  const Configuration at = configuration(t, x, v, z);
  for (const auto& batch : batches_) h = batch->sweptBound(at, scratch_.data(), h);
  return h;
}

}  // namespace muelle::engine
