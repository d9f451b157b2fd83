#pragma once
#include "harness/types.h"

namespace muelle::engine {

/// A force batch's share of the Linearisation's low-rank part: a stiffness U diag(s) U^T that is never assembled.
class LowRankPiece {
 public:
  virtual ~LowRankPiece() = default;

  virtual int columns() const = 0;
  /// Writes cK K: the columns, for the unknowns alone, and their stiffness.
  // By value: a Ref to write to, as Eigen has it.
  // NOLINTNEXTLINE(performance-unnecessary-value-param)
  virtual void writeLowRank(double cK, Eigen::Ref<Eigen::MatrixXd> U, Eigen::Ref<Eigen::VectorXd> s) const = 0;
};

}  // namespace muelle::engine
