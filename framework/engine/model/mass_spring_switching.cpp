#include "engine/model/mass_spring_system.h"

#include "engine/model/state_modes.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace muelle::engine {

void MassSpringSystem::guards(double t, In x, In v, In z, Out g) const {
  const Configuration at = configuration(t, x, v, z);
  std::size_t next = 0;
  for (const SwitchingPiece* piece : guarded_) {
    piece->guards(at, g.data() + next);
    next += static_cast<std::size_t>(piece->guardCount());
  }
}

std::string MassSpringSystem::guardName(int i) const {
  for (const SwitchingPiece* piece : guarded_) {
    if (i < piece->guardCount()) return piece->guardName(i);
    i -= piece->guardCount();
  }
  throw std::out_of_range("no such guard");
}

std::string MassSpringSystem::eventName(int i, const State& after) const {
  for (const SwitchingPiece* piece : guarded_) {
    if (i < piece->guardCount()) return piece->eventName(i, after.z.data());
    i -= piece->guardCount();
  }
  throw std::out_of_range("no such guard");
}

void MassSpringSystem::declaredTimes(double from, double to, std::vector<double>& times) const {
  std::vector<double> own;
  for (const SwitchingPiece* piece : switching_) piece->declaredTimes(from, to, own);
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
  for (const SwitchingPiece* piece : switching_) changed = piece->commit(at, frozen, state.z.data()) || changed;
  if (wantsBalance()) changed = balanceFriction(at, state) || changed;
  return changed;
}

bool MassSpringSystem::wantsBalance() const { return std::ranges::any_of(friction_, &FrictionPiece::wantsBalance); }

/// Second part of a commit: gives friction at rest what the other forces ask of it.
bool MassSpringSystem::balanceFriction(const Configuration& at, State& state) const {
  bool changed = false;
  double* sum = scratch_.data();
  std::fill(scratch_.begin(), scratch_.end(), 0.0);
  for (const auto& batch : batches_) {
    if (const FrictionPiece* piece = batch->frictionPiece()) {
      piece->addForceWithoutFriction(at, sum);
    } else {
      batch->addForce(at, sum);
    }
  }
  if (drag_) drag_->addForce(at, sum);
  for (const FrictionPiece* piece : friction_) changed = piece->balance(at, sum, state.z.data()) || changed;
  return changed;
}

void MassSpringSystem::cross(int guard, State& state) const {
  const Configuration at = configuration(state.t, state.x, state.v, state.z);
  for (const SwitchingPiece* piece : guarded_) {
    if (guard < piece->guardCount()) {
      piece->cross(guard, at, state.z.data());
      if (wantsBalance()) balanceFriction(at, state);
      return;
    }
    guard -= piece->guardCount();
  }
  throw std::out_of_range("no such guard");
}

void MassSpringSystem::close(State& state) const {
  state.z.resize(static_cast<std::size_t>(internalSize_), 0.0);
  const std::vector<double> before = state.z;
  const Configuration at = configuration(state.t, state.x, state.v, before);
  for (const SwitchingPiece* piece : switching_) piece->close(at, state.z.data());
}

double MassSpringSystem::shortestBounce(const State& state) const {
  const StateModes modes(state, internalSize_);
  const Configuration at = configuration(state.t, state.x, state.v, modes.z);
  double shortest = std::numeric_limits<double>::infinity();
  for (const SwitchingPiece* piece : switching_) shortest = std::min(shortest, piece->shortestBounce(at));
  return shortest;
}

double MassSpringSystem::sweptBound(double t, In x, In v, In z, double h) const {
  if (thin_.empty()) return h;
  acceleration(t, x, v, z, scratch_);
  const Configuration at = configuration(t, x, v, z);
  for (const SwitchingPiece* piece : thin_) h = piece->sweptBound(at, scratch_.data(), h);
  return h;
}

}  // namespace muelle::engine
