#pragma once
/// \file
/// Decompositions of dense matrices as plain functions: Eigen's templates for them take tens of seconds to compile, and
/// only dense.cpp instantiates them. Matrices are square unless said otherwise, and finite.

#include "harness/types.h"

namespace muelle::engine {

/// Eigenvalues and -vectors of a symmetric matrix, ascending; vectors as columns, of length 1.
struct SymmetricEigenpairs {
  VecX values;
  MatX vectors;
};

/// Only the lower triangle of A is read.
SymmetricEigenpairs symmetricEigenpairs(const MatX& A);

/// The eigenvalues alone, ascending, by the same algorithm. Only the lower triangle of A is read.
VecX symmetricEigenvalues(const MatX& A);

/// Eigenvalues and -vectors of any real matrix, in no order, conjugate pairs next to each other.
struct Eigenpairs {
  Eigen::VectorXcd values;
  Eigen::MatrixXcd vectors;
};

Eigenpairs eigenpairs(const MatX& A);

/// The largest magnitude of an eigenvalue of any real matrix.
double spectralRadius(const MatX& A);

/// A^-1 b by elimination with full pivoting, the most accurate.
VecX solveFullPivoting(const MatX& A, const VecX& b);

/// The same with pivots of the column, a few times faster, for a matrix that is far from singular.
VecX solvePartialPivoting(const MatX& A, const VecX& b);

/// By partial pivoting, too.
MatX inverse(const MatX& A);

/// Whether a Cholesky factorisation of a symmetric matrix is possible. Only the lower triangle of A is read.
bool isPositiveDefinite(const MatX& A);

/// The x that minimises |A x - b|, A with at least as many rows as columns.
VecX leastSquares(const MatX& A, const VecX& b);

}  // namespace muelle::engine
