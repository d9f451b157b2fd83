#pragma once
/// \file
/// Data that are smooth between declared times: which stretch a step is in. The internal variable of such data is 0
/// when live, else one more than the number of times that have passed, so that a step that ends at one of them sees the
/// near side alone.

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <vector>

namespace muelle::engine {

/// How many of the times have passed; one that is reached has.
inline int segmentAt(const std::vector<double>& times, double t) {
  return static_cast<int>(std::upper_bound(times.begin(), times.end(), t) - times.begin());
}

/// The segment that the internal variable z holds, or where it is live that of the time.
inline int segmentOf(double z, const std::vector<double>& times, double t) {
  return z > 0.0 ? static_cast<int>(z) - 1 : segmentAt(times, t);
}

/// Sets the internal variable for the time; true when a frozen one has changed.
inline bool commitSegment(double& z, const std::vector<double>& times, double t, bool frozen) {
  const double now = frozen ? segmentAt(times, t) + 1 : 0;
  const bool changed = z > 0.0 && now != z;
  z = now;
  return changed;
}

/// Appends the times in (from, to].
inline void appendTimes(const std::vector<double>& all, double from, double to, std::vector<double>& times) {
  std::copy_if(all.begin(), all.end(), std::back_inserter(times), [=](double t) { return from < t && t <= to; });
}

/// The period [s] at a time, of a list with one for each segment; infinite where there is none.
inline double periodAt(const std::vector<double>& periods, const std::vector<double>& times, double t) {
  if (periods.empty()) return std::numeric_limits<double>::infinity();
  return periods[static_cast<std::size_t>(segmentAt(times, t))];
}

}  // namespace muelle::engine
