#include "lab/bench/stopwatch.h"

#include <algorithm>
#include <ctime>

namespace muelle::bench {

double processorTime() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double secondsOf(const std::function<void()>& work, const Clock& now, double least) {
  const double start = now();
  long long calls = 0;
  double passed = 0.0;
  do {
    // As many again: to read the clock is a call of the system, which takes longer than a small force.
    const long long again = std::max(1LL, calls);
    for (long long i = 0; i < again; ++i) work();
    calls += again;
    passed = now() - start;
  } while (passed < least);
  return passed / static_cast<double>(calls);
}

}  // namespace muelle::bench
