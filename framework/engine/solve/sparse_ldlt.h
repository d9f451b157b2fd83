#pragma once
#include "harness/types.h"

#include <Eigen/SparseCore>
#include <memory>

namespace muelle::engine {

/// P A P^T = L D L^T of a symmetric sparse matrix: Eigen's SimplicialLDLT behind plain functions, instantiated in one
/// source. Nothing is promised of the result: pivots that are round-off are the caller's to find.
class SparseLdlt {
 public:
  enum class Order {
    AsGiven,    ///< rows are eliminated as they stand
    LeastFill,  ///< approximate minimum degree
  };

  explicit SparseLdlt(Order order);
  ~SparseLdlt();

  /// Looks at the pattern; factorise() then takes any matrix that has it. Only the lower triangle of A is read, here
  /// and there.
  void analyse(const Eigen::SparseMatrix<double>& A);
  /// False where an exact zero stopped it or a pivot is not finite: then nothing behind that pivot is known.
  bool factorise(const Eigen::SparseMatrix<double>& A);
  /// The diagonal of D, in the order of elimination.
  Eigen::VectorXd pivots() const;
  /// P v: a value for each row of A, in the order of the pivots.
  Eigen::VectorXd inPivotOrder(const Eigen::VectorXd& v) const;
  /// x = A^-1 b with the last factors, not refined.
  void solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace muelle::engine
