#include "engine/compact_system.h"

#include <numeric>

namespace muelle::engine {

CompactSystem::CompactSystem(const DynamicalSystem& system)
    : system_(system), lanes_(system.lanes().begin(), system.lanes().end()) {
  const auto storage = static_cast<std::size_t>(system.storage());
  if (lanes_.empty()) {
    lanes_.resize(static_cast<std::size_t>(system.size()));
    std::iota(lanes_.begin(), lanes_.end(), 0);
  }
  mass_.resize(lanes_.size());
  gather(system.mass(), mass_);
  if (system.drag() != nullptr) {
    drag_.resize(lanes_.size());
    gather(system.drag()->coefficients(), drag_);
  }
  for (std::vector<double>* all : {&first_.x, &first_.v, &second_.x, &second_.v, &result_}) all->assign(storage, 0.0);
}

void CompactSystem::gather(In lanes, Out unknowns) const {
  for (std::size_t i = 0; i < lanes_.size(); ++i) unknowns[i] = lanes[static_cast<std::size_t>(lanes_[i])];
}

void CompactSystem::scatter(In unknowns, Out lanes) const {
  for (std::size_t i = 0; i < lanes_.size(); ++i) lanes[static_cast<std::size_t>(lanes_[i])] = unknowns[i];
}

void CompactSystem::follow(const State& state) {
  first_.x = second_.x = state.x;
  first_.v = second_.v = state.v;
}

void CompactSystem::compact(const State& state, State& compact) const {
  compact.t = state.t;
  compact.z = state.z;
  compact.x.resize(lanes_.size());
  compact.v.resize(lanes_.size());
  gather(state.x, compact.x);
  gather(state.v, compact.v);
}

State CompactSystem::compact(const State& state) const {
  State result;
  compact(state, result);
  return result;
}

void CompactSystem::expand(const State& compact, State& state) const {
  state.t = compact.t;
  state.z = compact.z;
  scatter(compact.x, state.x);
  scatter(compact.v, state.v);
  system_.place(state.t, state.z, state.x, state.v);
}

/// Where all of the system is, in `whole`. Without velocities those of the last call stay.
void CompactSystem::fill(double t, In x, In v, In z, Whole& whole) const {
  scatter(x, whole.x);
  if (!v.empty()) scatter(v, whole.v);
  system_.place(t, z, whole.x, whole.v);
}

void CompactSystem::force(double t, In x, In v, In z, Out f) const {
  fill(t, x, v, z, first_);
  system_.force(t, first_.x, first_.v, z, result_);
  gather(result_, f);
}

double CompactSystem::energy(double t, In x, In z) const {
  fill(t, x, {}, z, first_);
  return system_.potential()->energy(t, first_.x, z);
}

void CompactSystem::conservativeForce(double t, In x, In z, Out f) const {
  fill(t, x, {}, z, first_);
  system_.potential()->conservativeForce(t, first_.x, z, result_);
  gather(result_, f);
}

void CompactSystem::discreteGradientForce(double t, In xa, In xb, In z, Out f) const {
  fill(t, xa, {}, z, first_);
  fill(t, xb, {}, z, second_);
  system_.potential()->discreteGradientForce(t, first_.x, second_.x, z, result_);
  gather(result_, f);
}

void CompactSystem::accelerationWithoutDrag(double t, In x, In v, In z, Out a) const {
  fill(t, x, v, z, first_);
  system_.drag()->accelerationWithoutDrag(t, first_.x, first_.v, z, result_);
  gather(result_, a);
}

void CompactSystem::assemble(double cM, double cD, double cK, double t, In x, In v, In z, Form form,
                             SystemMatrix& J) const {
  fill(t, x, v, z, first_);
  system_.linearisation()->assemble(cM, cD, cK, t, first_.x, first_.v, z, form, J);
}

}  // namespace muelle::engine
