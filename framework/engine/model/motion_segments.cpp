#include "engine/model/motion_segments.h"

#include "engine/forces/segment.h"

#include <algorithm>

namespace muelle::engine {

MotionSegments::MotionSegments(const std::vector<Motion>& motions) : motions_(motions) {
  const bool anyChanges = std::ranges::any_of(motions, [](const Motion& motion) { return !motion.times.empty(); });
  if (anyChanges) internalSize_ = static_cast<int>(motions.size());
}

int MotionSegments::at(std::size_t motion, double t, In z) const {
  const double own = z.empty() || internalSize_ == 0 ? 0.0 : z[offset_ + motion];
  return segmentOf(own, motions_[motion].times, t);
}

bool MotionSegments::commit(double t, bool frozen, double* z) const {
  bool changed = false;
  for (std::size_t i = 0; i < static_cast<std::size_t>(internalSize_); ++i) {
    changed = commitSegment(z[offset_ + i], motions_[i].times, t, frozen) || changed;
  }
  return changed;
}

void MotionSegments::declaredTimes(double from, double to, std::vector<double>& times) const {
  for (const Motion& motion : motions_) appendTimes(motion.times, from, to, times);
}

}  // namespace muelle::engine
