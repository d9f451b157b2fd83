#include "figures/axis.h"

#include <fmt/format.h>
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

double ticStep(const AxisRange& range, double length, double pitch) {
  const double least = range.span() * pitch / length;
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double digit : {1.0, 2.0, 5.0}) {
    if (digit * power >= least * (1.0 - 1e-9)) return digit * power;
  }
  return 10.0 * power;
}

bool needsShortNumbers(const AxisRange& range) {
  constexpr double largest = 1e7, smallest = 1e-4;
  return std::max(std::abs(range.low), std::abs(range.high)) >= largest || range.span() < smallest;
}

std::size_t widestNumber(const AxisRange& range, double step) {
  std::size_t widest = 1;
  constexpr int most = 100;  // numbers on an axis, for ranges without any sense
  const double first = std::ceil(range.low / step);
  for (int i = 0; i < most && (first + i) * step <= range.high; ++i) {
    const double number = (first + i) * step;
    widest = std::max(widest, needsShortNumbers(range) ? fmt::format("{:.4g}", number).size()
                                                       : fmt::format("{:.10g}", number).size());
  }
  return widest;
}

AxisRange widened(const AxisRange& range, double span) {
  return {range.middle() - 0.5 * span, range.middle() + 0.5 * span};
}

}  // namespace muelle
