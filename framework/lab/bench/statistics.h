#pragma once
#include <vector>

namespace muelle::bench {

/// What is said of times that were measured several times.
struct Statistics {
  int count = 0;
  double least = 0.0, median = 0.0;
  double percentile95 = 0.0;  ///< the value that 95 % of all do not exceed
  /// Between which the median of many more lies, with at least 95 % probability where there are six values or more: by
  /// order statistics, without any assumption on how times are distributed. Of fewer: the least and the greatest.
  double low = 0.0, high = 0.0;
};

/// Throws std::invalid_argument of no values.
Statistics statisticsOf(std::vector<double> values);

}  // namespace muelle::bench
