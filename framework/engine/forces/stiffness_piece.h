#pragma once
#include "engine/capabilities.h"
#include "engine/forces/configuration.h"
#include "engine/forces/matrix_pattern.h"

namespace muelle::engine {

/// A force batch's share of the Linearisation: derivatives of its force, as blocks of a sparse matrix.
class StiffnessPiece {
 public:
  virtual ~StiffnessPiece() = default;

  /// Says which nodes share an element; each node shares one with itself in any case.
  virtual void couple(MatrixPattern&) const {}
  /// Looks up where the elements' blocks go. After MatrixPattern::finish().
  virtual void bind(const MatrixPattern& pattern) = 0;
  /// Adds cD D + cK K, K = -dF/dx, D = -dF/dv, to the values of a matrix of the bound pattern.
  virtual void addDerivatives(const Configuration& at, double cD, double cK, Form form, double* values) const = 0;
  /// Whether the derivatives of Form::Exact are not symmetric.
  virtual bool isNotSymmetric() const { return false; }
};

}  // namespace muelle::engine
