#pragma once
#include "reference/binary128.h"

#include <functional>
#include <vector>

namespace muelle::hard_cases {

/// The slope of y' = f(t, y): overwrites `slope`, which is as long as y.
template <class Real>
using SlopeOf = std::function<void(Real t, const std::vector<Real>& y, std::vector<Real>& slope)>;
using Slope = SlopeOf<Quad>;

/// Integrates y' = f(t, y) from `from` to `to` [s] and returns y there.
///
/// Gragg's modified midpoint rule with 2, 4, .. 24 substeps, extrapolated in h^2 to order 24 (Hairer, Norsett and
/// Wanner, Solving Ordinary Differential Equations I, II.9; no smoothing step). A step is accepted when the last two
/// extrapolations differ by less than `tolerance`, relative to max(1, |y_i|), in every component. It shares no line
/// with the engine. Throws std::runtime_error when the step becomes too small to advance the time.
QuadVector integrate(const Slope& slope, QuadVector y, Quad from, Quad to, Quad tolerance);
/// The same with the 64 bits of long double, ten times as fast, for what needs a million evaluations.
std::vector<long double> integrate(const SlopeOf<long double>& slope, std::vector<long double> y, long double from,
                                   long double to, long double tolerance);

}  // namespace muelle::hard_cases
