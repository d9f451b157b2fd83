#include "engine/solve/sparse_ldlt.h"

#include <Eigen/SparseCholesky>

namespace muelle::engine {

namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;

}  // namespace

struct SparseLdlt::Parts {
  Order order;
  Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower, Eigen::NaturalOrdering<int>> asGiven;
  Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower, Eigen::AMDOrdering<int>> leastFill;

  /// Calls `use` with the one of the two that is meant.
  template <class Use>
  decltype(auto) with(const Use& use) {
    return order == Order::AsGiven ? use(asGiven) : use(leastFill);
  }
};

SparseLdlt::SparseLdlt(Order order) : parts_(std::make_unique<Parts>()) { parts_->order = order; }
SparseLdlt::~SparseLdlt() = default;

void SparseLdlt::analyse(const SparseMatrix& A) {
  parts_->with([&](auto& ldlt) { ldlt.analyzePattern(A); });
}

bool SparseLdlt::factorise(const SparseMatrix& A) {
  return parts_->with([&](auto& ldlt) {
    ldlt.factorize(A);
    return ldlt.info() == Eigen::Success && ldlt.vectorD().allFinite();
  });
}

Eigen::VectorXd SparseLdlt::pivots() const {
  return parts_->with([](auto& ldlt) -> Eigen::VectorXd { return ldlt.vectorD(); });
}

Eigen::VectorXd SparseLdlt::inPivotOrder(const Eigen::VectorXd& v) const {
  return parts_->order == Order::AsGiven ? v : Eigen::VectorXd(parts_->leastFill.permutationP() * v);
}

void SparseLdlt::solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) const {
  parts_->with([&](auto& ldlt) { x = ldlt.solve(b); });
}

}  // namespace muelle::engine
