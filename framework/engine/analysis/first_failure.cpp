#include "engine/analysis/first_failure.h"

#include <algorithm>
#include <limits>

namespace muelle::engine {

namespace {

/// Between a z at which it holds and one at which it fails.
double bisect(const std::function<bool(double z)>& holds, double low, double high) {
  while (high - low > 1e-7 * high) {
    const double middle = 0.5 * (low + high);
    (holds(middle) ? low : high) = middle;
  }
  return low;
}

}  // namespace

double firstFailure(const std::function<bool(double z)>& holds, double most, bool searchBelow, double ratio) {
  constexpr double start = 0.05, smallest = 1e-9;
  if (!holds(start)) return searchBelow && holds(smallest) ? bisect(holds, smallest, start) : 0.0;
  double low = start;
  while (low < most) {
    const double high = low * (low > 10.0 ? std::max(ratio, 1.02) : ratio);
    if (!holds(high)) return bisect(holds, low, high);
    low = high;
  }
  return std::numeric_limits<double>::infinity();
}

}  // namespace muelle::engine
