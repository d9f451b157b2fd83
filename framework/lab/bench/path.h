#pragma once
#include "harness/state.h"

#include <vector>

namespace muelle::bench {

/// All nodes of a scene at one time, in its own numbering: node i of a scene of dimension D has entries D i ... of x
/// [m] and of v [m/s], nodes that are held included.
struct PathPoint {
  double t = 0.0;  ///< [s]
  std::vector<double> x, v;
};

/// What is kept of a run to tell its error: the first end of a step at or behind each of so many equal times, so that
/// no method is asked for more than the states that it makes. A method that steps over several of these times is looked
/// at once for all of them.
class Path {
 public:
  Path(double duration, int samples) : duration_(duration), samples_(samples) {}

  /// Whether a step that ends at t [s] is to be shown.
  bool wants(double t) const;
  /// Takes the state at the end of a step.
  void see(PathPoint point);

  const std::vector<PathPoint>& points() const { return points_; }
  double duration() const { return duration_; }
  /// The time from which on the next state is wanted, and later ones [s]: j duration / samples.
  double sampleTime(int j) const { return duration_ * j / samples_; }
  int samples() const { return samples_; }

 private:
  double duration_;
  int samples_;
  int next_ = 1;
  std::vector<PathPoint> points_;
};

}  // namespace muelle::bench
