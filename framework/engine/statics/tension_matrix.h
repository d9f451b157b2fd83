#pragma once
#include "engine/solve/sparse_ldlt.h"
#include "engine/statics/tension_shape.h"

#include <vector>

namespace muelle::engine {

/// The matrix of TensionForm's method at a shape, [A N^T; N -1/(k - rho)] with the unknown tensions in parts of rho so
/// that all entries are of one size, and its factors.
///
/// Rows are the unknown positions, the unknown tensions and one for each column of the low-rank part of the stiffness,
/// node by node in an order of little fill, each node followed by the tensions that first meet it there.
class TensionMatrix {
 public:
  using Vector = Eigen::VectorXd;

  struct Factors {
    bool usable = false;  ///< no pivot is round-off of its row
    int negative = 0;     ///< negative eigenvalues of the stiffness matrix, the shift included
  };

  /// The shape must outlive this.
  explicit TensionMatrix(TensionShape& shape) : shape_(shape) {}

  /// After the choice of unknown tensions has changed: rows are laid out anew when next needed.
  void forgetRows() { laidOut_ = false; }
  /// Takes the stiffness of everything but the springs from where the shape is now.
  void linearise();
  /// The matrix with `shift` [N/m] on the diagonal of the positions. linearise() comes before, here and below.
  Factors factorise(double shift);
  /// The same with rho I in the place of the stiffness: its solutions are least squares of the forces. False where
  /// there are no factors.
  bool factoriseLeastSquares(double rho);
  /// Solves with the last factors, refined; false where that is no solution.
  bool solve(const Vector& b, Vector& x) const;

  Eigen::Index rows() const { return rows_; }
  /// The row of an unknown position.
  int rowOf(Eigen::Index unknown) const { return rowOf_[static_cast<std::size_t>(unknown)]; }
  /// The row of a tension by the spring's place in the shape; -1 where it is no unknown.
  int tensionRow(std::size_t spring) const { return tensionRow_[spring]; }
  /// Right-hand side or solution, the part of the positions.
  void setPositions(In values, Vector& b) const;
  Vector positions(const Vector& x) const;
  /// The size of the largest entry of the stiffness matrix [N/m], tensions' rows aside.
  double largestEntry() const;
  /// |A| |x| of the matrix as last factorised, the part of the positions.
  Vector absoluteProduct(const Vector& x) const;

 private:
  using Sparse = Eigen::SparseMatrix<double>;
  using Triplets = std::vector<Eigen::Triplet<double>>;

  void layOut();
  void addOthers(double shift, Triplets& entries) const;
  void addSpring(const TensionSpring& spring, Triplets& entries) const;
  void addTension(std::size_t spring, Triplets& entries) const;
  void addLowRank(Triplets& entries) const;
  void assemble(const Triplets& entries);

  TensionShape& shape_;
  SystemMatrix others_;  // the stiffness of everything but the springs
  Sparse matrix_;
  SparseLdlt ldlt_{SparseLdlt::Order::AsGiven};
  std::vector<int> rowOf_, tensionRow_, lowRankRow_;
  Eigen::Index rows_ = 0;
  bool laidOut_ = false;
  bool analysed_ = false;
};

}  // namespace muelle::engine
