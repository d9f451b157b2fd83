#include "base/progress_bar.h"

#include <unistd.h>
#include <algorithm>
#include <cstdio>
#include <utility>

namespace muelle {

ProgressBar::ProgressBar(std::string label)
    : label_(std::move(label)),
      active_(!label_.empty() && ::isatty(STDERR_FILENO) != 0),
      nextDraw_(Clock::now() + std::chrono::seconds(1)) {}

ProgressBar::~ProgressBar() {
  if (drawn_) std::fputs("\r\033[K", stderr);
}

void ProgressBar::update(double fraction) {
  if (!active_) return;
  const Clock::time_point now = Clock::now();
  if (now < nextDraw_) return;
  nextDraw_ = now + std::chrono::milliseconds(100);
  drawn_ = true;
  constexpr int width = 40;
  const double shown = std::clamp(fraction, 0.0, 1.0);
  const auto filled = static_cast<std::size_t>(shown * width);
  const std::string bar = std::string(filled, '#') + std::string(width - filled, '.');
  std::fprintf(stderr, "\r%s [%s] %3.0f %%", label_.c_str(), bar.c_str(), 100 * shown);
  std::fflush(stderr);
}

}  // namespace muelle
