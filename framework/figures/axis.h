#pragma once
#include <cstddef>

namespace muelle {

/// What an axis shows, from low to high.
struct AxisRange {
  double low = 0.0;
  double high = 1.0;

  double span() const { return high - low; }
  double middle() const { return 0.5 * low + 0.5 * high; }
};

/// Whether a figure can show the number: finite, at most 1e100, and positive on a logarithmic axis.
bool isDrawable(double value, bool logarithmic);

/// Collects the numbers of an axis and finds a range that shows them.
class AxisFitter {
 public:
  explicit AxisFitter(bool logarithmic) : logarithmic_(logarithmic) {}

  void include(double value);
  bool isEmpty() const { return empty_; }
  /// Never empty: a constant gets room on both sides, and round-off counts as constant. `margin` is the part of the
  /// span left free on each side of a linear axis; a logarithmic one ends at powers of ten.
  AxisRange range(double margin) const;

 private:
  bool logarithmic_;
  bool empty_ = true;
  AxisRange seen_;
};

/// Distance of the numbers on a linear axis: the smallest of 1, 2 and 5 times a power of ten that leaves at least
/// `pitch` between them where the axis is `length` long.
double ticStep(const AxisRange& range, double length, double pitch);

/// Whether the numbers of the range are too long for an axis when they are written out: many digits before the point,
/// or behind it.
bool needsShortNumbers(const AxisRange& range);

/// How many characters the longest of the multiples of `step` in the range has.
std::size_t widestNumber(const AxisRange& range, double step);

/// Widens a range about its middle to the given span.
AxisRange widened(const AxisRange& range, double span);

}  // namespace muelle
