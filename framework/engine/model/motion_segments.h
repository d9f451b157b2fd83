#pragma once
#include "engine/model/model.h"
#include "harness/state.h"

namespace muelle::engine {

/// Which of its segments each motion of a model is in (forces/segment.h): an internal variable a motion, where any of
/// them has declared times.
class MotionSegments {
 public:
  /// `motions` must outlive this.
  explicit MotionSegments(const std::vector<Motion>& motions);

  int internalSize() const { return internalSize_; }
  /// Where its variables begin in z.
  void setInternalOffset(int offset) { offset_ = static_cast<std::size_t>(offset); }

  /// The segment of a motion at time t; where `z` is empty the time alone tells.
  int at(std::size_t motion, double t, In z) const;
  /// Sets the variables in z for time t; true when a frozen one has changed.
  bool commit(double t, bool frozen, double* z) const;
  /// Appends the declared times in (from, to].
  void declaredTimes(double from, double to, std::vector<double>& times) const;

 private:
  const std::vector<Motion>& motions_;
  int internalSize_ = 0;
  std::size_t offset_ = 0;
};

}  // namespace muelle::engine
