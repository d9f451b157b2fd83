#pragma once
#include <chrono>
#include <string>

namespace muelle {

/// A bar on the standard error stream for work that takes more than a second; draws nothing when that is no terminal.
class ProgressBar {
 public:
  /// \param label shown before the bar; empty: no bar
  explicit ProgressBar(std::string label);
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;
  /// Wipes the bar.
  ~ProgressBar();

  /// Draws at most ten times a second. \param fraction of the work done, from 0 to 1
  void update(double fraction);

 private:
  using Clock = std::chrono::steady_clock;

  std::string label_;
  bool active_;
  bool drawn_ = false;
  Clock::time_point nextDraw_;
};

}  // namespace muelle
