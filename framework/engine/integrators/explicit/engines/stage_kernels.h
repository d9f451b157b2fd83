#pragma once
/// \file
/// The sums over stages of explicit methods for x'' = a(t, x, v), positions and velocities in one pass over the
/// accelerations:
///
///     X = x + (c h v + sum wx_j a_j),   V = v + sum wv_j a_j
///
/// The weights wx and wv have the step in them, h^2 and h, which saves two products a lane.
///
/// The same arithmetic in the same order on every instruction set: no contraction, no reordered sum. But for the sums
/// of all that was written, which tell whether it is finite: only that is to be read from them.

#include <cstddef>

namespace muelle::engine {

inline constexpr std::size_t mostStageTerms = 17;

/// The stages that enter a sum and what they are read from: first those that enter positions and velocities, then those
/// of positions alone, those of velocities alone, and those of estimates alone. A sum does not wait for accelerations
/// that it does not need: the positions of a Runge-Kutta stage do not depend on the stage before.
struct StageTerms {
  std::size_t both = 0, positions = 0, velocities = 0;
  std::size_t count = 0;            ///< of all
  const double* a[mostStageTerms];  ///< accelerations [m/s^2], n lanes each
  const double* wx = nullptr;       ///< weights of positions [s^2], one a term
  const double* wv = nullptr;       ///< weights of velocities [s]
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
  const double* ex;  ///< error of positions: sum ex_j a_j
  const double* ev;  ///< error of velocities: sum ev_j a_j
};

struct StageEnd {
  double sum = 0.0;  ///< of all that was written, and all estimates: see isFinite()
  /// Of each estimate the largest error of all lanes over what is allowed, where rounding of the value counts as none.
  double largest[2] = {};
};

/// Whether what made a sum was finite. What is not stays so in any sum; but a sum of values near the largest double may
/// be infinite by itself, so that a false answer has to be looked into.
inline bool isFinite(double sum) { return 0.0 * sum == 0.0; }

/// What is written may not be what is read.
struct StageKernels {
  /// A stage: X, and V unless that is null.
  void (*stage)(const StageBase& base, const StageTerms& terms, double c, double* X, double* V);
  /// The end of a step: X and V, and up to two estimates.
  void (*end)(const StageBase& base, const StageTerms& terms, const StageEstimate* estimates, std::size_t count,
              double allowedX, double allowedV, double* X, double* V, StageEnd& result);
  /// V = v + h a, X = x + h V; the sum of all of it.
  double (*kickDrift)(std::size_t n, const double* x, const double* v, const double* a, double h, double* X, double* V);
  /// The first half of a step of velocity Verlet without drag: X = x + h (v + h/2 a), and P = v + h/2 a + h/2 a unless
  /// that is null; the sum of X.
  double (*halfKickDrift)(std::size_t n, const double* x, const double* v, const double* a, double h, double* X,
                          double* P);
  /// The second half: V = v + h/2 a + h/2 b with the acceleration b at X; its sum.
  double (*twoHalfKicks)(std::size_t n, const double* v, const double* a, const double* b, double h, double* V);
};

/// The kernels for n lanes and the instruction set in use (kernels/instruction_set.h).
const StageKernels& stageKernels(std::size_t n);

}  // namespace muelle::engine
