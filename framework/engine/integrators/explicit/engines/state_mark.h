#pragma once
#include "harness/state.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace muelle::engine {

/// Tells whether a state is the one at which a force is kept, by its time and a few of its entries. It guards against
/// a caller that goes on from another state without restart(); the internal variables are the caller's to announce.
/// Differences of a few units in the last place are the caller's rounding (compensated summation, times on a grid) and
/// make no other state.
class StateMark {
 public:
  void set(const State& state) {
    set_ = true;
    marked_ = samplesOf(state);
  }
  void clear() { set_ = false; }
  bool matches(const State& state) const {
    if (!set_ || !isNear(state.t, marked_[0])) return false;
    const Samples samples = samplesOf(state);
    std::uint64_t different = 0;  // one branch instead of seven, on numbers that were hardly computed
    for (std::size_t i = 0; i < samples.size(); ++i) {
      different |= std::bit_cast<std::uint64_t>(samples[i]) ^ std::bit_cast<std::uint64_t>(marked_[i]);
    }
    return different == 0 || std::ranges::equal(samples, marked_, isNear);
  }

 private:
  /// The time, and the first, a middle and the last entry of x and v.
  using Samples = std::array<double, 7>;
  static Samples samplesOf(const State& state) {
    if (state.x.empty()) return {state.t};
    const std::size_t last = state.x.size() - 1, middle = last / 2;
    return {state.t, state.x[0], state.x[middle], state.x[last], state.v[0], state.v[middle], state.v[last]};
  }
  static bool isNear(double a, double b) {
    return std::abs(a - b) <= 4.0 * std::numeric_limits<double>::epsilon() * std::max(std::abs(a), std::abs(b));
  }

  bool set_ = false;
  Samples marked_{};
};

}  // namespace muelle::engine
