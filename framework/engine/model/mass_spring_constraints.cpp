#include "engine/model/mass_spring_system.h"

#include <algorithm>

namespace muelle::engine {

bool MassSpringSystem::onlyDistances() const {
  return std::ranges::all_of(
      batches_, [](const auto& batch) { return batch->constraintCount() == 0 || batch->constraintsAreDistances(); });
}

void MassSpringSystem::extend(double t, In x, std::vector<double>& all) const {
  const Configuration at = gather(t, x, zeroVelocity_, {}, first_);
  all.assign(at.x, at.x + (hasFixed_ ? first_.x.size() : x.size()));
}

bool MassSpringSystem::evaluate(int j, double t, In x, In z, Constraint& out) const {
  const bool extended = x.size() > static_cast<std::size_t>(size_);
  const Configuration at =
      extended ? Configuration{t, x.data(), first_.v.data(), z.data()} : gather(t, x, zeroVelocity_, z, first_);
  const auto next = std::upper_bound(constraintStart_.begin(), constraintStart_.end(), j);
  const auto batch = static_cast<std::size_t>(next - constraintStart_.begin()) - 1;
  return batches_[batch]->evaluateConstraint(j - constraintStart_[batch], at, size_, out);
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
