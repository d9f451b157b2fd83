#pragma once
#include <algorithm>
#include <cstddef>
#include <ctime>
#include <vector>

namespace muelle::benchmarks {

/// Time that this thread has computed [s]: on a busy machine the time in which others did does not count.
inline double threadSeconds() {
  timespec now = {};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Median of ratios of times taken in turns, with the interval that holds the true median in at least 95 of 100 cases.
struct Ratio {
  double median, low, high;
  double first, second;  ///< medians of the two times [s] of one call
};

/// The time of `first` over that of `second`. \param least how long a time is taken at least [s]
template <class First, class Second>
Ratio ratioOfTimes(First first, Second second, int pairs = 25, double least = 1.5e-3) {
  const auto once = [](auto& work, int calls) {
    const double start = threadSeconds();
    for (int i = 0; i < calls; ++i) work();
    return (threadSeconds() - start) / calls;
  };
  const auto callsFor = [&](auto& work) {
    once(work, 1);
    return std::max(1, static_cast<int>(least / once(work, 1)));
  };
  const int callsOfFirst = callsFor(first), callsOfSecond = callsFor(second);
  std::vector<double> ratios, firsts, seconds;
  for (int i = 0; i < pairs; ++i) {
    firsts.push_back(once(first, callsOfFirst));
    seconds.push_back(once(second, callsOfSecond));
    ratios.push_back(firsts.back() / seconds.back());
  }
  for (auto* values : {&ratios, &firsts, &seconds}) std::sort(values->begin(), values->end());
  // Order statistics of the binomial distribution: with n values the ranks n/2 -+ 0.98 sqrt(n) bound the median.
  const auto n = static_cast<std::size_t>(pairs);
  std::size_t reach = 1;
  while (static_cast<double>(reach * reach) < 0.9604 * static_cast<double>(n)) ++reach;
  const std::size_t middle = n / 2, low = middle > reach ? middle - reach : 0, high = std::min(middle + reach, n - 1);
  return {ratios[middle], ratios[low], ratios[high], firsts[middle], seconds[middle]};
}

}  // namespace muelle::benchmarks
