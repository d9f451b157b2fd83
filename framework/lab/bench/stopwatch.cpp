#include "lab/bench/stopwatch.h"

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
    work();
    ++calls;
    passed = now() - start;
  } while (passed < least);
  return passed / static_cast<double>(calls);
}

}  // namespace muelle::bench
