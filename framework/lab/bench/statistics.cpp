#include "lab/bench/statistics.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace muelle::bench {

namespace {

/// How many values may be left out at each end of n: the most for which the chance that the median lies there (both
/// ends together, binomial) stays below 5 %.
std::size_t cutAtEachEnd(std::size_t n) {
  double chance = std::ldexp(1.0, -static_cast<int>(n)), sum = 0.0;  // of k successes in n throws of a coin
  std::size_t cut = 0;
  for (std::size_t k = 0; k < n / 2; ++k) {
    sum += chance;
    if (2.0 * sum > 0.05) break;
    cut = k;
    chance *= static_cast<double>(n - k) / static_cast<double>(k + 1);
  }
  return cut;
}

}  // namespace

Statistics statisticsOf(std::vector<double> values) {
  if (values.empty()) throw std::invalid_argument("statistics of no values");
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size(), cut = cutAtEachEnd(n);
  Statistics result;
  result.count = static_cast<int>(n);
  result.least = values.front();
  result.median = n % 2 == 1 ? values[n / 2] : 0.5 * (values[n / 2 - 1] + values[n / 2]);
  result.percentile95 = values[static_cast<std::size_t>(std::ceil(0.95 * static_cast<double>(n))) - 1];
  result.low = values[cut];
  result.high = values[n - 1 - cut];
  return result;
}

}  // namespace muelle::bench
