#include "engine/solve/supernodal_cholesky.h"

#include <cholmod.h>
#include <new>

namespace muelle::engine {

namespace {

using Sparse = Eigen::SparseMatrix<double>;
using Vector = Eigen::VectorXd;

/// Operations for each entry of L from which blocks win: measured on cloths and boxes of 3,000 to 50,000 unknowns with
/// the reference BLAS, where those of 250 to 350 take as long either way. A faster BLAS moves it down.
constexpr double worthWhile = 300.0;

/// Memory that is CHOLMOD's: freed by its own functions.
template <class Memory, int (*release)(Memory**, cholmod_common*)>
class Owned {
 public:
  explicit Owned(cholmod_common& common) : common_(common) {}
  Owned(const Owned&) = delete;
  Owned& operator=(const Owned&) = delete;
  ~Owned() { release(&memory_, &common_); }

  Memory* get() const { return memory_; }
  Memory** place() { return &memory_; }
  void take(Memory* memory) {
    release(&memory_, &common_);
    memory_ = memory;
  }

 private:
  cholmod_common& common_;
  Memory* memory_ = nullptr;
};

/// Starts and finishes CHOLMOD.
struct Common {
  cholmod_common common{};

  Common() {
    cholmod_start(&common);
    common.supernodal = CHOLMOD_SUPERNODAL;
    common.print = 0;
  }
  Common(const Common&) = delete;
  Common& operator=(const Common&) = delete;
  ~Common() { cholmod_finish(&common); }
};

/// The lower triangle of A, which is not copied. CHOLMOD's functions write to none of it.
cholmod_sparse lowerTriangle(const Sparse& A) {
  cholmod_sparse view{};
  view.nrow = static_cast<std::size_t>(A.rows());
  view.ncol = static_cast<std::size_t>(A.cols());
  view.nzmax = static_cast<std::size_t>(A.nonZeros());
  view.p = const_cast<int*>(A.outerIndexPtr());
  view.i = const_cast<int*>(A.innerIndexPtr());
  view.x = const_cast<double*>(A.valuePtr());
  view.stype = -1;
  view.itype = CHOLMOD_INT;
  view.xtype = CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  view.sorted = 1;
  view.packed = 1;
  return view;
}

cholmod_dense column(const Vector& b) {
  cholmod_dense view{};
  view.nrow = static_cast<std::size_t>(b.size());
  view.ncol = 1;
  view.nzmax = view.nrow;
  view.d = view.nrow;
  view.x = const_cast<double*>(b.data());
  view.xtype = CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  return view;
}

}  // namespace

struct SupernodalCholesky::Parts : Common {
  using Dense = Owned<cholmod_dense, cholmod_free_dense>;

  Owned<cholmod_factor, cholmod_free_factor> factor{common};
  mutable Dense solution{common}, work{common}, moreWork{common};  // kept, so that a solve allocates nothing
};

SupernodalCholesky::SupernodalCholesky() : parts_(std::make_unique<Parts>()) {}
SupernodalCholesky::~SupernodalCholesky() = default;

bool SupernodalCholesky::isThere() { return true; }

bool SupernodalCholesky::analyse(const Sparse& A) {
  cholmod_sparse view = lowerTriangle(A);
  cholmod_common& common = parts_->common;
  parts_->factor.take(cholmod_analyze(&view, &common));
  return parts_->factor.get() != nullptr && common.fl > worthWhile * common.lnz;
}

bool SupernodalCholesky::factorise(const Sparse& A) {
  cholmod_sparse view = lowerTriangle(A);
  cholmod_factor* factor = parts_->factor.get();
  cholmod_factorize(&view, factor, &parts_->common);
  return parts_->common.status == CHOLMOD_OK && factor->minor == factor->n;
}

Vector SupernodalCholesky::pivots() const {
  const cholmod_factor& factor = *parts_->factor.get();
  const auto* firstColumn = static_cast<const int*>(factor.super);
  const auto* firstRow = static_cast<const int*>(factor.pi);
  const auto* firstEntry = static_cast<const int*>(factor.px);
  const auto* entries = static_cast<const double*>(factor.x);
  Vector pivots(static_cast<Eigen::Index>(factor.n));
  for (std::size_t s = 0; s < factor.nsuper; ++s) {
    const int rows = firstRow[s + 1] - firstRow[s];
    for (int column = firstColumn[s]; column < firstColumn[s + 1]; ++column) {
      const double root = entries[firstEntry[s] + (column - firstColumn[s]) * (rows + 1)];
      pivots[column] = root * root;
    }
  }
  return pivots;
}

Vector SupernodalCholesky::inPivotOrder(const Vector& v) const {
  const auto* order = static_cast<const int*>(parts_->factor.get()->Perm);
  Vector ordered(v.size());
  for (Eigen::Index i = 0; i < v.size(); ++i) ordered[i] = v[order[i]];
  return ordered;
}

void SupernodalCholesky::solve(const Vector& b, Vector& x) const {
  Parts& p = *parts_;
  cholmod_dense right = column(b);
  const bool solved = cholmod_solve2(CHOLMOD_A, p.factor.get(), &right, nullptr, p.solution.place(), nullptr,
                                     p.work.place(), p.moreWork.place(), &p.common) != 0;
  if (!solved) throw std::bad_alloc();
  x = Eigen::Map<const Vector>(static_cast<const double*>(p.solution.get()->x), b.size());
}

}  // namespace muelle::engine
