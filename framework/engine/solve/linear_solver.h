#pragma once
#include "engine/capabilities.h"

#include <Eigen/Core>
#include <memory>
#include <string>

namespace muelle::engine {

/// What a factorisation found. Eigen's LDL^T reports success on indefinite matrices and on NaN, so nothing here rests
/// on its word: pivots and finiteness are looked at.
struct Factorisation {
  bool usable = false;    ///< solve() may be called
  bool definite = false;  ///< symmetric and positive definite, low-rank part included
  int negative = 0;       ///< number of negative eigenvalues of a symmetric matrix (Sylvester's law of inertia)
  int vanishing = 0;      ///< pivots that are round-off of their row: the matrix is singular as far as doubles can tell
  std::string failure;    ///< one line when not usable
};

/// Direct solver for the matrices of implicit steps and of statics.
///
/// A symmetric sparse part is factorised as LDL^T (a diagonal one is divided by; a positive definite one that fills in
/// much by supernodes, where CHOLMOD is there), any other as LU with pivoting. The
/// analysis of the pattern is kept as long as the pattern stays. A low-rank part never becomes dense: Woodbury's
/// formula (A + U S U^T)^-1 = A^-1 - A^-1 U (S^-1 + U^T A^-1 U)^-1 U^T A^-1 costs r more solves and O(n r) memory.
class LinearSolver {
 public:
  LinearSolver();
  ~LinearSolver();
  LinearSolver(LinearSolver&&) noexcept;
  LinearSolver& operator=(LinearSolver&&) noexcept;

  /// Factorises J, which must live until the last solve() (its residual is looked at). With `onlyDefinite` a symmetric
  /// matrix that is not positive definite is reported as not usable and no more is tried; otherwise a symmetric matrix
  /// with vanishing pivots is tried again by LU.
  Factorisation factorise(const SystemMatrix& J, bool onlyDefinite = false);

  /// Solves J x = b, with one step of iterative refinement where round-off asks for it. Returns an empty string, or one
  /// line that says why x is no solution: not finite, or the backward error |b - J x| / (|J| |x| + |b|) is larger than
  /// 1e-8.
  std::string solve(const Eigen::VectorXd& b, Eigen::VectorXd& x);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// y = J x, low-rank part included.
void multiply(const SystemMatrix& J, const Eigen::VectorXd& x, Eigen::VectorXd& y);
/// y = |J| |x|, each entry by its size: what an error of one part in x can do to J x.
void multiplyAbsolute(const SystemMatrix& J, const Eigen::VectorXd& x, Eigen::VectorXd& y);

}  // namespace muelle::engine
