#pragma once
/// \file
/// Sums over stages in one pass over memory.

#include "engine/integrator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

namespace muelle::engine {

/// Weighted stages w_1 k_1 + w_2 k_2 + ..., with the zero weights left out.
class Combination {
 public:
  /// Adds w k; k has as many entries as the vectors that the sum is added to. Nothing is kept of a zero weight.
  void add(double weight, const double* k);
  /// out = base + scale * sum, in one pass over all arrays. `out` may be `base`.
  void addTo(In base, double scale, Out out) const;
  /// out = scale * sum.
  void assignTo(double scale, Out out) const;
  /// The largest |scale * sum|_i over what is allowed: see errorRatio().
  double largestError(double scale, In from, In to, double allowed) const;

 private:
  /// Entries [begin, begin + count) of the sum, count at most blockSize.
  void block(std::size_t begin, std::size_t count, double* sum) const;

  static constexpr std::size_t blockSize = 256;  // doubles: stays in the first cache while the stages pass by
  struct Term {
    double weight;
    const double* k;
  };
  std::array<Term, 24> terms_;
  std::size_t count_ = 0;
};

/// What the rounding of sum = a + b lost (Knuth). A drift h (v + k) that forgets it errs by h ulp(v) in the same
/// direction often enough to show as a slow loss of energy in long compensated runs.
inline double lostIn(double sum, double a, double b) {
  const double part = sum - a;
  return (a - (sum - part)) + (b - part);
}

/// An estimated error over what is allowed, where the value itself is rounded: what rounding alone makes of an
/// estimate, a few units in the last place of the value, is no error of the method.
inline double errorRatio(double estimate, double from, double to, double allowed) {
  constexpr double rounding = 4.0 * std::numeric_limits<double>::epsilon();
  return std::abs(estimate) / (allowed + rounding * std::max(std::abs(from), std::abs(to)));
}

/// The larger of two; not a number when either is none (std::max would hide it).
inline double larger(double a, double b) { return std::isnan(a) || a > b ? a : b; }

/// Sets the sizes, z and time of the result of a step of h.
inline void prepareResult(const State& from, double h, State& to) {
  to.x.resize(from.x.size());
  to.v.resize(from.v.size());
  if (!from.z.empty() || !to.z.empty()) to.z = from.z;
  to.t = from.t + h;
}

/// Index of the first entry that is not finite, or -1.
int firstNotFinite(In values);

/// Failure when a position or a velocity of `to` is not finite; otherwise a result with the error given.
StepResult finiteOrFailure(const DynamicalSystem& system, const State& from, const State& to, double error);

}  // namespace muelle::engine
