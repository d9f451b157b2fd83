#pragma once
/// \file
/// How a step begins and ends: sizes, what rounding lost, estimated errors, numbers that are not finite.

#include "engine/integrator.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace muelle::engine {

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

/// The largest errorRatio() of an estimate; not a number where one is none.
double largestErrorRatio(In estimate, In from, In to, double allowed);

/// What a step's estimate of the order h^`power` may be, in parts of the motion, so that a run's error goes with the
/// tolerance. Most estimates are of the power p of a method of order p (of what a lower order would have left), and so
/// is a run's error. An estimate of the result's own error is of the power p + 1: bounded by the tolerance T itself it
/// lets h go with T^(1/(p+1)), and the error with T^(p/(p+1)). Bounded by T^((p+1)/p) it makes h^p go with T.
inline double stepTolerance(double tolerance, int order, int power) {
  return power > order ? std::pow(tolerance, static_cast<double>(power) / order) : tolerance;
}

/// Gives `to` the sizes and z of `from`.
void takeSizes(const State& from, State& to);

/// Sets the sizes, z and time of the result of a step of h.
inline void prepareResult(const State& from, double h, State& to) {
  const bool hasSizes = to.x.size() == from.x.size() && to.v.size() == from.v.size();
  if (!hasSizes || !from.z.empty() || !to.z.empty()) takeSizes(from, to);
  to.t = from.t + h;
}

/// Index of the first entry that is not finite, or -1.
int firstNotFinite(In values);

/// Failure when a position or a velocity of `to` is not finite; otherwise a result with the error given.
StepResult finiteOrFailure(const DynamicalSystem& system, const State& from, const State& to, double error);

}  // namespace muelle::engine
