/// \file
/// SupernodalCholesky without CHOLMOD: where that is not installed, and in programs that must open no library.

#include "engine/solve/supernodal_cholesky.h"

namespace muelle::engine {

struct SupernodalCholesky::Parts {};

SupernodalCholesky::SupernodalCholesky() = default;
SupernodalCholesky::~SupernodalCholesky() = default;
bool SupernodalCholesky::isThere() { return false; }
bool SupernodalCholesky::analyse(const Eigen::SparseMatrix<double>& /*A*/) { return false; }
bool SupernodalCholesky::factorise(const Eigen::SparseMatrix<double>& /*A*/) { return false; }
Eigen::VectorXd SupernodalCholesky::pivots() const { return {}; }
Eigen::VectorXd SupernodalCholesky::inPivotOrder(const Eigen::VectorXd& v) const { return v; }
void SupernodalCholesky::solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) const { x = b; }

}  // namespace muelle::engine
