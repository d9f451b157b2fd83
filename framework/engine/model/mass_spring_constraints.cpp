#include "engine/model/mass_spring_system.h"

#include <algorithm>

namespace muelle::engine {

bool MassSpringSystem::onlyDistances() const {
  return std::ranges::all_of(
      batches_, [](const auto& batch) { return batch->constraintCount() == 0 || batch->constraintsAreDistances(); });
}

bool MassSpringSystem::evaluate(int j, double t, In x, In z, Constraint& out) const {
  const auto next = std::upper_bound(constraintStart_.begin(), constraintStart_.end(), j);
  const auto batch = static_cast<std::size_t>(next - constraintStart_.begin()) - 1;
  const Configuration at = configuration(t, x, zeroVelocity_, z);
  return batches_[batch]->evaluateConstraint(j - constraintStart_[batch], at, out);
}

std::string MassSpringSystem::leftOut() const {
  std::string all;
  for (const auto& batch : batches_) {
    const std::string own = batch->leftOut();
    if (!own.empty()) all += (all.empty() ? "" : ", ") + own;
  }
  return all;
}

}  // namespace muelle::engine
