#include "engine/model/mass_spring_system.h"

#include "engine/model/state_modes.h"

#include <Eigen/Geometry>

namespace muelle::engine {

double MassSpringSystem::kineticEnergy(const State& state) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < mass_.size(); ++i) sum += 0.5 * mass_[i] * state.v[i] * state.v[i];
  return sum;
}

double MassSpringSystem::totalEnergy(const State& state) const {
  const StateModes modes(state, internalSize_);
  double sum = kineticEnergy(state) + energy(state.t, state.x, modes.z);
  const Configuration at = configuration(state.t, state.x, zeroVelocity_, modes.z);
  for (const FrictionPiece* piece : friction_) sum += state.z.empty() ? 0.0 : piece->anchorEnergy(at);
  return sum;
}

double MassSpringSystem::elasticEnergy(const State& state) const {
  const StateModes modes(state, internalSize_);
  const Configuration at = configuration(state.t, state.x, zeroVelocity_, modes.z);
  double sum = 0.0;
  for (const auto& batch : batches_) sum += batch->isUniformField() ? 0.0 : batch->energy(at);
  return sum;
}

Vec3 MassSpringSystem::momentum(const State& state) const {
  Vec3 sum = Vec3::Zero();
  for (int i = 0; i < nodeCount(); ++i) {
    const ModelNode& node = model_.nodes[static_cast<std::size_t>(i)];
    if (isFree(node)) sum += node.m * velocity(state, i);
  }
  return sum;
}

Vec3 MassSpringSystem::angularMomentum(const State& state) const {
  Vec3 sum = Vec3::Zero();
  for (int i = 0; i < nodeCount(); ++i) {
    const ModelNode& node = model_.nodes[static_cast<std::size_t>(i)];
    if (isFree(node)) sum += node.m * position(state, i).cross(velocity(state, i));
  }
  return sum;
}

}  // namespace muelle::engine
