#pragma once
#include "harness/types.h"

#include <Eigen/SparseCore>
#include <memory>

namespace muelle::engine {

/// P A P^T = L L^T of a symmetric positive definite sparse matrix by supernodes, that is, by dense blocks: CHOLMOD
/// (Chen, Davis, Hager and Rajamanickam 2008) behind plain functions, in the better of the orders of minimum degree and
/// of nested dissection. What fills in much, as a volume does, takes a fraction of the time that it takes entry by
/// entry; what fills in little, as a cloth does, takes longer. Where CHOLMOD is not there it is never worth while.
class SupernodalCholesky {
 public:
  SupernodalCholesky();
  ~SupernodalCholesky();
  SupernodalCholesky(const SupernodalCholesky&) = delete;
  SupernodalCholesky& operator=(const SupernodalCholesky&) = delete;

  /// Whether CHOLMOD is there: when this was built, and on this machine.
  static bool isThere();

  /// Looks at the pattern; factorise() then takes any matrix that has it. Only the lower triangle of A is read, here
  /// and there.
  /// \return whether factorise() will be faster than SparseLdlt's
  bool analyse(const Eigen::SparseMatrix<double>& A);
  /// False where A is not positive definite, or memory does not last.
  bool factorise(const Eigen::SparseMatrix<double>& A);
  /// The squares of the diagonal of L, in the order of elimination: what SparseLdlt calls pivots.
  Eigen::VectorXd pivots() const;
  /// P v: a value for each row of A, in the order of the pivots.
  Eigen::VectorXd inPivotOrder(const Eigen::VectorXd& v) const;
  /// x = A^-1 b with the last factor, not refined.
  void solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace muelle::engine
