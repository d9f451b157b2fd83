#include "engine/solve/dense.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>

namespace muelle::engine {

SymmetricEigenpairs symmetricEigenpairs(const MatX& A) {
  const Eigen::SelfAdjointEigenSolver<MatX> eigen(A);
  return {eigen.eigenvalues(), eigen.eigenvectors()};
}

VecX symmetricEigenvalues(const MatX& A) {
  return Eigen::SelfAdjointEigenSolver<MatX>(A, Eigen::EigenvaluesOnly).eigenvalues();
}

Eigenpairs eigenpairs(const MatX& A) {
  const Eigen::EigenSolver<MatX> eigen(A);
  return {eigen.eigenvalues(), eigen.eigenvectors()};
}

double spectralRadius(const MatX& A) { return Eigen::EigenSolver<MatX>(A, false).eigenvalues().cwiseAbs().maxCoeff(); }

VecX solveFullPivoting(const MatX& A, const VecX& b) { return Eigen::FullPivLU<MatX>(A).solve(b); }

VecX solvePartialPivoting(const MatX& A, const VecX& b) { return Eigen::PartialPivLU<MatX>(A).solve(b); }

MatX inverse(const MatX& A) { return Eigen::PartialPivLU<MatX>(A).inverse(); }

bool isPositiveDefinite(const MatX& A) { return Eigen::LLT<MatX>(A).info() == Eigen::Success; }

VecX leastSquares(const MatX& A, const VecX& b) { return Eigen::ColPivHouseholderQR<MatX>(A).solve(b); }

}  // namespace muelle::engine
