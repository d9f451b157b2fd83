#pragma once
#include <chrono>

namespace muelle::lab {

/// So many seconds of the clock on the wall, from now on.
class Countdown {
 public:
  explicit Countdown(double seconds) : seconds_(seconds), begun_(Clock::now()) {}

  double passed() const { return std::chrono::duration<double>(Clock::now() - begun_).count(); }
  double left() const { return seconds_ - passed(); }

 private:
  using Clock = std::chrono::steady_clock;

  double seconds_;
  Clock::time_point begun_;
};

}  // namespace muelle::lab
