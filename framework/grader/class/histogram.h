#pragma once
#include <optional>
#include <string>
#include <vector>

namespace muelle::grader {

/// Numbers counted in intervals of equal width from 0 on; each holds its lower end, the last one both. The last one
/// ends at `most`, and may be narrower.
struct Histogram {
  double most = 0.0;
  double step = 1.0;
  std::vector<int> counts;

  double low(std::size_t i) const { return step * static_cast<double>(i); }
  double high(std::size_t i) const;
};

/// At most `intervals` of them, with a width of 1, 2 or 5 times a power of ten. None when `most` is not positive.
Histogram histogramOf(const std::vector<double>& values, double most, int intervals);

/// The histogram as an inline SVG with labelled axes, and a line at the median. Its colours are classes of
/// class_style.h.
std::string drawn(const Histogram& histogram, const std::optional<double>& median);

}  // namespace muelle::grader
