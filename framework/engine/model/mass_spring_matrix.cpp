#include "engine/model/mass_spring_system.h"

namespace muelle::engine {

void MassSpringSystem::bind() const {
  pattern_.emplace(dimension_, numbering_.rank);
  for (const StiffnessPiece* piece : stiffness_) piece->couple(*pattern_);
  pattern_->finish();
  for (StiffnessPiece* piece : stiffness_) piece->bind(*pattern_);
}

void MassSpringSystem::assemble(double cM, double cD, double cK, double t, In x, In v, In z, Form form,
                                SystemMatrix& J) const {
  if (!pattern_) bind();
  pattern_->clear(J.sparse);
  const Configuration at = configuration(t, x, v, z);
  double* values = J.sparse.valuePtr();
  J.symmetric = true;
  for (const StiffnessPiece* piece : stiffness_) {
    piece->addDerivatives(at, cD, cK, form, values);
    if (form == Form::Exact && piece->isNotSymmetric()) J.symmetric = false;
  }
  if (cM != 0.0) {
    for (const int node : numbering_.freeNodes) {
      const BlockSlot slot = pattern_->slot(node, node);
      for (int axis = 0; axis < dimension_; ++axis) {
        values[slot.base + axis * slot.stride + axis] += cM * mass_[laneOf(node, axis)];
      }
    }
  }
  assembleLowRank(cK, J.lowRank);
}

/// After the batches' derivatives, which the columns are of.
void MassSpringSystem::assembleLowRank(double cK, LowRank& lowRank) const {
  int columns = 0;
  for (const LowRankPiece* piece : lowRank_) columns += piece->columns();
  lowRank.U.resize(columns == 0 ? 0 : size_, columns);
  lowRank.s.resize(columns);
  int column = 0;
  for (const LowRankPiece* piece : lowRank_) {
    const int own = piece->columns();
    piece->writeLowRank(cK, lowRank.U.middleCols(column, own), lowRank.s.segment(column, own));
    column += own;
  }
}

}  // namespace muelle::engine
