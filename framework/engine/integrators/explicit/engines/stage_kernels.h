#pragma once
/// \file
/// The sums over stages of explicit methods for x'' = a(t, x, v), positions and velocities in one pass over the
/// accelerations:
///
///     X = x + h (c v + h sum wx_j a_j),   V = v + h sum wv_j a_j
///
/// The same arithmetic in the same order on every instruction set: no contraction, no reordered sum.

#include <cstddef>

namespace muelle::engine {

inline constexpr std::size_t mostStageTerms = 17;

/// The stages that enter a sum and what they are read from.
struct StageTerms {
  std::size_t count = 0;
  const double* a[mostStageTerms];  ///< accelerations [m/s^2], n lanes each
  const double* wx = nullptr;       ///< weights of positions, one a term
  const double* wv = nullptr;       ///< weights of velocities
};

/// Where a step begins.
struct StageBase {
  std::size_t n;  ///< lanes
  const double* x;
  const double* v;
  double h;  ///< [s]
};

/// An estimate of the error: weights of the same terms, and what is allowed.
struct StageEstimate {
  const double* ex;  ///< error of positions: h^2 sum ex_j a_j
  const double* ev;  ///< error of velocities: h sum ev_j a_j
};

struct StageEnd {
  double notFinite = 0.0;  ///< 0 when all that was written, and all estimates, are finite
  /// Of each estimate the largest error of all lanes over what is allowed, where rounding of the value counts as none.
  double largest[2] = {};
};

struct StageKernels {
  /// A stage: X, and V unless that is null.
  void (*stage)(const StageBase& base, const StageTerms& terms, double c, double* X, double* V);
  /// The end of a step: X and V, and up to two estimates.
  void (*end)(const StageBase& base, const StageTerms& terms, const StageEstimate* estimates, std::size_t count,
              double allowedX, double allowedV, double* X, double* V, StageEnd& result);
  /// V = v + h a, X = x + h V; 0 when all of it is finite.
  double (*kickDrift)(std::size_t n, const double* x, const double* v, const double* a, double h, double* X, double* V);
  /// Half a step of velocity Verlet without drag: V = v + h/2 a, X = x + h V; and P = V + h/2 a unless that is null.
  void (*halfKickDrift)(std::size_t n, const double* x, const double* v, const double* a, double h, double* X,
                        double* V, double* P);
  /// V = V + h/2 a; 0 when X and V are finite.
  double (*halfKick)(std::size_t n, const double* a, double h, const double* X, double* V);
};

/// The kernels for n lanes on this processor.
const StageKernels& stageKernels(std::size_t n);

}  // namespace muelle::engine
