#include "engine/model/mass_spring_system.h"

#include <algorithm>

namespace muelle::engine {

int MassSpringSystem::count() const {
  int all = 0;
  for (const ConstraintPiece* piece : constraints_) all += piece->constraintCount();
  return all;
}

bool MassSpringSystem::onlyDistances() const {
  return std::ranges::all_of(constraints_, [](const ConstraintPiece* piece) {
    return piece->constraintCount() == 0 || piece->constraintsAreDistances();
  });
}

void MassSpringSystem::evaluate(double t, In x, In z, const ConstraintBlocks::Take& take) const {
  const Configuration at = configuration(t, x, zeroVelocity_, z);
  ConstraintBlocks blocks(take);
  int first = 0;
  for (const ConstraintPiece* piece : constraints_) {
    piece->evaluateConstraints(at, first, blocks);
    first += piece->constraintCount();
  }
  blocks.flush();
}

void MassSpringSystem::project(double t, In z, const ConstraintProjection& projection) const {
  const Configuration at = {t, projection.x, zeroVelocity_.data(), z.data()};
  for (const ConstraintPiece* piece : constraints_) piece->project(at, projection);
}

void MassSpringSystem::externalForce(double t, In x, In v, In z, Out f) const {
  const Configuration at = configuration(t, x, v, z);
  clear(f);
  for (const auto& batch : batches_) {
    if (const ConstraintPiece* piece = batch->constraintPiece()) {
      piece->addExternalForce(at, f.data());
    } else {
      batch->addForce(at, f.data());
    }
  }
  if (drag_) drag_->addForce(at, f.data());
}

std::string MassSpringSystem::leftOut() const {
  std::string all;
  for (const ConstraintPiece* piece : constraints_) {
    const std::string own = piece->leftOut();
    if (!own.empty()) all += (all.empty() ? "" : ", ") + own;
  }
  return all;
}

}  // namespace muelle::engine
