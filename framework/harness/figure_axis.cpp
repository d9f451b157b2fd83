#include "harness/figure_axis.h"

#include <algorithm>
#include <cmath>

namespace muelle {

bool isDrawable(double value, bool logarithmic) {
  constexpr double largest = 1e100;
  if (!std::isfinite(value) || std::abs(value) > largest) return false;
  return !logarithmic || value >= 1.0 / largest;
}

void AxisFitter::include(double value) {
  if (!isDrawable(value, logarithmic_)) return;
  seen_.low = empty_ ? value : std::min(seen_.low, value);
  seen_.high = empty_ ? value : std::max(seen_.high, value);
  empty_ = false;
}

AxisRange AxisFitter::range(double margin) const {
  if (logarithmic_) {
    if (empty_) return {1.0, 10.0};
    const double low = std::floor(std::log10(seen_.low));
    return {std::pow(10.0, low), std::pow(10.0, std::max(std::ceil(std::log10(seen_.high)), low + 1))};
  }
  if (empty_) return {0.0, 1.0};
  const double size = std::max(std::abs(seen_.low), std::abs(seen_.high));
  // Round-off: no quantity of the course is that small.
  if (size < 1e-12) return {-1.0, 1.0};
  if (seen_.span() < 1e-9 * size) return {seen_.middle() - 0.1 * size, seen_.middle() + 0.1 * size};
  return widened(seen_, (1.0 + 2.0 * margin) * seen_.span());
}

AxisRange widened(const AxisRange& range, double span) {
  return {range.middle() - 0.5 * span, range.middle() + 0.5 * span};
}

}  // namespace muelle
