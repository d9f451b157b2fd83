#include "engine/solve/supernodal_cholesky.h"

#include <cholmod.h>
#include <dlfcn.h>
#include <fmt/format.h>
#include <new>

namespace muelle::engine {

namespace {

using Sparse = Eigen::SparseMatrix<double>;
using Vector = Eigen::VectorXd;

/// Operations for each entry of L from which blocks win: measured on cloths and boxes of 3,000 to 50,000 unknowns with
/// the reference BLAS, where those of 250 to 350 take as long either way. A faster BLAS moves it down.
constexpr double worthWhile = 300.0;

/// CHOLMOD's functions. The library brings eleven others along, which every program with the engine in it would load at
/// its start; it is opened where the first large matrix comes.
struct Cholmod {
  decltype(&cholmod_start) start = nullptr;
  decltype(&cholmod_finish) finish = nullptr;
  decltype(&cholmod_analyze) analyze = nullptr;
  decltype(&cholmod_factorize) factorize = nullptr;
  decltype(&cholmod_solve2) solve2 = nullptr;
  decltype(&cholmod_free_factor) freeFactor = nullptr;
  decltype(&cholmod_free_dense) freeDense = nullptr;
  bool isThere = false;

  /// The one of this process.
  static const Cholmod& loaded() {
    static const Cholmod cholmod;
    return cholmod;
  }

 private:
  Cholmod() {
    // That of the header: the structures of another version are others.
    void* library = dlopen(fmt::format("libcholmod.so.{}", CHOLMOD_MAIN_VERSION).c_str(), RTLD_NOW | RTLD_LOCAL);
    isThere = library != nullptr && find(library, "cholmod_start", start) && find(library, "cholmod_finish", finish) &&
              find(library, "cholmod_analyze", analyze) && find(library, "cholmod_factorize", factorize) &&
              find(library, "cholmod_solve2", solve2) && find(library, "cholmod_free_factor", freeFactor) &&
              find(library, "cholmod_free_dense", freeDense);
  }

  template <class Function>
  static bool find(void* library, const char* name, Function& function) {
    function = reinterpret_cast<Function>(dlsym(library, name));
    return function != nullptr;
  }
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

struct SupernodalCholesky::Parts {
  const Cholmod& cholmod = Cholmod::loaded();
  cholmod_common common{};
  cholmod_factor* factor = nullptr;
  cholmod_dense *solution = nullptr, *work = nullptr, *moreWork = nullptr;  // kept, so that a solve allocates nothing

  Parts() {
    cholmod.start(&common);
    common.supernodal = CHOLMOD_SUPERNODAL;
    common.print = 0;
  }
  Parts(const Parts&) = delete;
  Parts& operator=(const Parts&) = delete;
  ~Parts() {
    cholmod.freeFactor(&factor, &common);
    for (cholmod_dense** vector : {&solution, &work, &moreWork}) cholmod.freeDense(vector, &common);
    cholmod.finish(&common);
  }
};

SupernodalCholesky::SupernodalCholesky() = default;
SupernodalCholesky::~SupernodalCholesky() = default;

bool SupernodalCholesky::isThere() { return Cholmod::loaded().isThere; }

bool SupernodalCholesky::analyse(const Sparse& A) {
  if (!isThere()) return false;
  if (parts_ == nullptr) parts_ = std::make_unique<Parts>();
  Parts& p = *parts_;
  cholmod_sparse view = lowerTriangle(A);
  p.cholmod.freeFactor(&p.factor, &p.common);
  p.factor = p.cholmod.analyze(&view, &p.common);
  return p.factor != nullptr && p.common.fl > worthWhile * p.common.lnz;
}

bool SupernodalCholesky::factorise(const Sparse& A) {
  Parts& p = *parts_;
  cholmod_sparse view = lowerTriangle(A);
  p.cholmod.factorize(&view, p.factor, &p.common);
  return p.common.status == CHOLMOD_OK && p.factor->minor == p.factor->n;
}

Vector SupernodalCholesky::pivots() const {
  const cholmod_factor& factor = *parts_->factor;
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
  const auto* order = static_cast<const int*>(parts_->factor->Perm);
  Vector ordered(v.size());
  for (Eigen::Index i = 0; i < v.size(); ++i) ordered[i] = v[order[i]];
  return ordered;
}

void SupernodalCholesky::solve(const Vector& b, Vector& x) const {
  Parts& p = *parts_;
  cholmod_dense right = column(b);
  const bool isSolved = p.cholmod.solve2(CHOLMOD_A, p.factor, &right, nullptr, &p.solution, nullptr, &p.work,
                                         &p.moreWork, &p.common) != 0;
  if (!isSolved) throw std::bad_alloc();
  x = Eigen::Map<const Vector>(static_cast<const double*>(p.solution->x), b.size());
}

}  // namespace muelle::engine
