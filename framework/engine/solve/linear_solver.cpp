#include "engine/solve/linear_solver.h"

#include "engine/solve/dense.h"
#include "engine/solve/sparse_ldlt.h"
#include "engine/solve/supernodal_cholesky.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <Eigen/LU>
#include <Eigen/SparseLU>
#include <limits>
#include <vector>

namespace muelle::engine {

namespace {

using Vector = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;
using Sparse = Eigen::SparseMatrix<double>;

constexpr double eps = std::numeric_limits<double>::epsilon();

/// Writes the diagonal; false when there is an entry beside it that is not 0 (nodes without springs still have whole
/// blocks in the pattern).
bool isDiagonal(const Sparse& A, Vector& diagonal) {
  diagonal.setZero(A.rows());
  for (int j = 0; j < A.outerSize(); ++j) {
    for (Sparse::InnerIterator entry(A, j); entry; ++entry) {
      if (entry.row() == j) {
        diagonal[j] = entry.value();
      } else if (entry.value() != 0.0) {
        return false;
      }
    }
  }
  return true;
}

bool allFinite(const Sparse& A) {
  return Eigen::Map<const Eigen::ArrayXd>(A.valuePtr(), A.nonZeros()).isFinite().all();
}

double infinityNorm(const Sparse& A) {
  Vector rows = Vector::Zero(A.rows());
  for (int j = 0; j < A.outerSize(); ++j) {
    for (Sparse::InnerIterator entry(A, j); entry; ++entry) rows[entry.row()] += std::abs(entry.value());
  }
  return rows.size() > 0 ? rows.maxCoeff() : 0.0;
}

/// Largest entry of each column: what its pivot is compared with.
Vector columnSizes(const Sparse& A) {
  Vector sizes = Vector::Zero(A.cols());
  for (int j = 0; j < A.outerSize(); ++j) {
    for (Sparse::InnerIterator entry(A, j); entry; ++entry) sizes[j] = std::max(sizes[j], std::abs(entry.value()));
  }
  return sizes;
}

/// The pattern of a matrix, to know whether a kept analysis still fits.
struct Pattern {
  std::vector<int> outer, inner;

  bool fits(const Sparse& A) const {
    return outer.size() == static_cast<std::size_t>(A.outerSize()) + 1 &&
           inner.size() == static_cast<std::size_t>(A.nonZeros()) &&
           std::equal(outer.begin(), outer.end(), A.outerIndexPtr()) &&
           std::equal(inner.begin(), inner.end(), A.innerIndexPtr());
  }
  void keep(const Sparse& A) {
    outer.assign(A.outerIndexPtr(), A.outerIndexPtr() + A.outerSize() + 1);
    inner.assign(A.innerIndexPtr(), A.innerIndexPtr() + A.nonZeros());
  }
};

}  // namespace

struct LinearSolver::Parts {
  enum class Kind { None, Diagonal, LDLT, Supernodal, LU };

  Kind kind = Kind::None;
  const SystemMatrix* J = nullptr;
  double norm = 0.0;
  Vector diagonal;
  SparseLdlt ldlt{SparseLdlt::Order::LeastFill};
  Eigen::SparseLU<Sparse> lu;
  SupernodalCholesky supernodal;
  bool isSupernodal = false;    // worth while for the symmetric pattern
  bool isLdltAnalysed = false;  // for it, too
  Pattern symmetricPattern, luPattern;
  Matrix U, AinvU;  // the columns of the low-rank part that count, and A^-1 of them
  Vector s;
  Eigen::PartialPivLU<Matrix> capacitance;
  Vector residual, correction;

  /// Counts the signs of pivots; `sizes[i]` is what pivot i would be were nothing subtracted.
  static void countPivots(const Vector& pivots, const Vector& sizes, Factorisation& result) {
    for (Eigen::Index i = 0; i < pivots.size(); ++i) {
      if (std::abs(pivots[i]) <= 8.0 * eps * sizes[i]) {
        ++result.vanishing;
      } else if (pivots[i] < 0.0) {
        ++result.negative;
      }
    }
  }

  bool factoriseLDLT(const Sparse& A, Factorisation& result) {
    if (!isLdltAnalysed) ldlt.analyse(A);
    isLdltAnalysed = true;
    if (!ldlt.factorise(A)) {
      // How many more vanish is not known.
      result.vanishing = 1;
      return false;
    }
    countPivots(ldlt.pivots(), ldlt.inPivotOrder(columnSizes(A)), result);
    kind = Kind::LDLT;
    return result.vanishing == 0;
  }

  bool factoriseSymmetric(const Sparse& A, Factorisation& result) {
    constexpr Eigen::Index fewest = 1000;  // unknowns, below which nothing fills in enough for supernodes
    if (!symmetricPattern.fits(A)) {
      isSupernodal = A.rows() >= fewest && supernodal.analyse(A);
      isLdltAnalysed = false;
      symmetricPattern.keep(A);
    }
    return factoriseSupernodal(A, result) || factoriseLDLT(A, result);
  }

  /// Of positive definite matrices alone, and where it is the faster one; what it refuses goes to LDLT, which counts.
  bool factoriseSupernodal(const Sparse& A, Factorisation& result) {
    if (!isSupernodal || !supernodal.factorise(A)) return false;
    Factorisation found;
    countPivots(supernodal.pivots(), supernodal.inPivotOrder(columnSizes(A)), found);
    if (found.vanishing > 0) return false;
    result = found;
    kind = Kind::Supernodal;
    return true;
  }

  bool factoriseLU(const Sparse& A, Factorisation& result) {
    if (!luPattern.fits(A)) {
      lu.analyzePattern(A);
      luPattern.keep(A);
    }
    lu.factorize(A);
    if (lu.info() != Eigen::Success) {
      result.failure = "the matrix is singular (LU: " + lu.lastErrorMessage() + ")";
      return false;
    }
    kind = Kind::LU;
    return true;
  }

  void solveSparse(const Vector& b, Vector& x) {
    switch (kind) {
      case Kind::Diagonal:
        x = b.cwiseQuotient(diagonal);
        break;
      case Kind::LDLT:
        ldlt.solve(b, x);
        break;
      case Kind::Supernodal:
        supernodal.solve(b, x);
        break;
      case Kind::LU:
        x = lu.solve(b);
        break;
      case Kind::None:
        x.setConstant(b.size(), std::numeric_limits<double>::quiet_NaN());
        break;
    }
  }

  void solveOnce(const Vector& b, Vector& x) {
    solveSparse(b, x);
    if (s.size() > 0) x.noalias() -= AinvU * Vector(capacitance.solve(U.transpose() * x));
  }

  /// r -= J x.
  void subtractProduct(const Vector& x, Vector& r) const {
    if (kind == Kind::Diagonal) {
      r -= diagonal.cwiseProduct(x);
    } else {
      r.noalias() -= J->sparse * x;
    }
    if (s.size() > 0) r.noalias() -= U * Vector(s.cwiseProduct(U.transpose() * x));
  }

  /// Woodbury's small matrix C = S^-1 + U^T A^-1 U, and the inertia of the sum: neg(A + U S U^T) = neg(A) + pos(C) -
  /// pos(S), from the two block eliminations of [A U; U^T -S^-1] (Haynsworth 1968).
  bool prepareLowRank(Factorisation& result) {
    const LowRank& lowRank = J->lowRank;
    std::vector<Eigen::Index> used;
    for (Eigen::Index c = 0; c < lowRank.s.size(); ++c) {
      if (lowRank.s[c] != 0.0) used.push_back(c);
    }
    const auto r = static_cast<Eigen::Index>(used.size());
    U.resize(lowRank.U.rows(), r);
    AinvU.resize(lowRank.U.rows(), r);
    s.resize(r);
    for (Eigen::Index c = 0; c < r; ++c) {
      U.col(c) = lowRank.U.col(used[static_cast<std::size_t>(c)]);
      s[c] = lowRank.s[used[static_cast<std::size_t>(c)]];
      correction = U.col(c);
      solveSparse(correction, residual);
      AinvU.col(c) = residual;
    }
    if (r == 0) return true;
    Matrix C = U.transpose() * AinvU;
    C.diagonal() += s.cwiseInverse();
    if (!C.allFinite()) {
      result.failure = "the low-rank part is not finite";
      return false;
    }
    for (Eigen::Index c = 0; c < r; ++c) {
      norm += std::abs(s[c]) * U.col(c).lpNorm<Eigen::Infinity>() * U.col(c).lpNorm<1>();
    }
    if (kind != Kind::LU) {
      const Matrix symmetric = 0.5 * (C + C.transpose());
      const Vector values = symmetricEigenvalues(symmetric);
      result.negative += static_cast<int>((values.array() > 0.0).count() - (s.array() > 0.0).count());
      result.vanishing += static_cast<int>((values.array().abs() <= 8.0 * eps * values.cwiseAbs().maxCoeff()).count());
    }
    capacitance.compute(C);
    return true;
  }
};

LinearSolver::LinearSolver() : parts_(std::make_unique<Parts>()) {}
LinearSolver::~LinearSolver() = default;
LinearSolver::LinearSolver(LinearSolver&&) noexcept = default;
LinearSolver& LinearSolver::operator=(LinearSolver&&) noexcept = default;

Factorisation LinearSolver::factorise(const SystemMatrix& J, bool onlyDefinite) {
  Parts& p = *parts_;
  Factorisation result;
  p.kind = Parts::Kind::None;
  p.J = &J;
  p.s.resize(0);
  const Sparse& A = J.sparse;
  if (A.rows() != A.cols() || !A.isCompressed()) {
    result.failure = fmt::format("the matrix is {} x {} or not compressed", A.rows(), A.cols());
    return result;
  }
  if (!allFinite(A) || !J.lowRank.U.allFinite() || !J.lowRank.s.allFinite()) {
    result.failure = "the matrix has entries that are not finite";
    return result;
  }
  bool done = false;
  if (J.symmetric && isDiagonal(A, p.diagonal)) {
    p.norm = p.diagonal.size() > 0 ? p.diagonal.lpNorm<Eigen::Infinity>() : 0.0;
    result.vanishing = static_cast<int>((p.diagonal.array() == 0.0).count());
    result.negative = static_cast<int>((p.diagonal.array() < 0.0).count());
    p.kind = Parts::Kind::Diagonal;
    done = result.vanishing == 0;
    if (!done) result.failure = fmt::format("the matrix is singular: {} vanishing pivots", result.vanishing);
  } else {
    p.norm = infinityNorm(A);
    if (J.symmetric) done = p.factoriseSymmetric(A, result);
    const bool givenUp = onlyDefinite && J.symmetric && J.lowRank.empty() && (!done || result.negative > 0);
    if (!done && !givenUp) done = p.factoriseLU(A, result);
  }
  if (done) done = p.prepareLowRank(result);
  result.definite = done && J.symmetric && p.kind != Parts::Kind::LU && result.negative == 0 && result.vanishing == 0;
  result.usable = done && (!onlyDefinite || !J.symmetric || result.definite);
  if (!result.usable && result.failure.empty()) {
    result.failure = fmt::format("the matrix is not positive definite: {} negative and {} vanishing pivots",
                                 result.negative, result.vanishing);
  }
  if (!result.usable) p.kind = Parts::Kind::None;
  return result;
}

std::string LinearSolver::solve(const Vector& b, Vector& x) {
  Parts& p = *parts_;
  if (p.kind == Parts::Kind::None) return "there is no factorisation to solve with";
  p.solveOnce(b, x);
  if (!x.allFinite()) return "the solution is not finite";
  const auto backwardError = [&] {
    p.residual = b;
    p.subtractProduct(x, p.residual);
    const double size = p.norm * x.lpNorm<Eigen::Infinity>() + b.lpNorm<Eigen::Infinity>();
    const double left = p.residual.lpNorm<Eigen::Infinity>();
    // Numbers that die out end below the normal range, where no digit is left to compare.
    return left > 1e-290 ? left / size : 0.0;
  };
  double error = backwardError();
  if (p.kind != Parts::Kind::Diagonal || error > 4.0 * eps) {
    p.solveOnce(p.residual, p.correction);
    // A correction that is no small part of x comes from a matrix without a single right digit; it would not help.
    if (p.correction.allFinite() && p.correction.norm() < 0.5 * x.norm()) {
      x += p.correction;
      error = backwardError();
    }
  }
  if (error > 1e-8) {
    return fmt::format("the linear solution is wrong: backward error {:.1e}, at most 1e-8 is good", error);
  }
  return {};
}

void multiply(const SystemMatrix& J, const Vector& x, Vector& y) {
  y.noalias() = J.sparse * x;
  if (!J.lowRank.empty()) y.noalias() += J.lowRank.U * Vector(J.lowRank.s.cwiseProduct(J.lowRank.U.transpose() * x));
}

void multiplyAbsolute(const SystemMatrix& J, const Vector& x, Vector& y) {
  y.setZero(x.size());
  for (int j = 0; j < J.sparse.outerSize(); ++j) {
    const double size = std::abs(x[j]);
    for (Sparse::InnerIterator entry(J.sparse, j); entry; ++entry) y[entry.row()] += std::abs(entry.value()) * size;
  }
  if (J.lowRank.empty()) return;
  const Vector parts = J.lowRank.U.cwiseAbs().transpose() * x.cwiseAbs();
  y.noalias() += J.lowRank.U.cwiseAbs() * J.lowRank.s.cwiseAbs().cwiseProduct(parts);
}

}  // namespace muelle::engine
