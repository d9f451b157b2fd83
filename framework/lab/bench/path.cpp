#include "lab/bench/path.h"

#include <utility>

namespace muelle::bench {

bool Path::wants(double t) const {
  // Times that are sums of steps miss a sample by rounding.
  return next_ <= samples_ && t >= sampleTime(next_) - 1e-12 * duration_;
}

void Path::see(PathPoint point) {
  while (wants(point.t)) ++next_;
  points_.push_back(std::move(point));
}

}  // namespace muelle::bench
