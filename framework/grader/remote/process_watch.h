#pragma once
#include <sys/types.h>
#include <chrono>
#include <cstddef>
#include <ctime>

namespace muelle::grader {

/// A process as the kernel shows it from outside: nothing that it does to itself can change what is read here.
class ProcessWatch {
 public:
  using Clock = std::chrono::steady_clock;

  ProcessWatch() = default;
  /// Watches the innermost of a chain of single children: the program that a sandbox has started.
  /// \param outermost the process that was started; must have reached its program
  explicit ProcessWatch(pid_t outermost);

  pid_t pid() const { return pid_; }
  /// Processor time so far; the last value read when the process has gone.
  std::chrono::nanoseconds cpu() const;
  /// Memory that it really holds [bytes]; 0 when it cannot be read.
  std::size_t residentBytes() const;

  /// Looks whether it sleeps. To be called every few hundredths of a second while waiting for it.
  void observe();
  /// True when it has done nothing but sleep, in every one of many looks, for `span`: it waits for what never comes.
  /// A process that is stopped, or that waits for a disk or for its turn, does not sleep.
  bool sleptFor(std::chrono::milliseconds span) const;

 private:
  void forgetSleep();

  pid_t pid_ = 0;
  clockid_t clock_ = CLOCK_MONOTONIC;
  mutable std::chrono::nanoseconds lastCpu_{0};
  std::chrono::nanoseconds cpuAtSleep_{0};
  Clock::time_point asleepSince_;
  int looks_ = 0;
};

}  // namespace muelle::grader
