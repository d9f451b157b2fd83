#pragma once
#include "harness/state.h"

#include <algorithm>
#include <cmath>
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
    t_ = state.t;
    for (int i = 0; i < samples; ++i) {
      x_[i] = sample(state.x, i);
      v_[i] = sample(state.v, i);
    }
  }
  void clear() { set_ = false; }
  bool matches(const State& state) const {
    if (!set_) return false;
    bool same = t_ == state.t;
    for (int i = 0; same && i < samples; ++i) same = x_[i] == sample(state.x, i) && v_[i] == sample(state.v, i);
    return same || isNear(state);
  }

 private:
  bool isNear(const State& state) const {
    if (!near(t_, state.t)) return false;
    for (int i = 0; i < samples; ++i) {
      if (!near(x_[i], sample(state.x, i)) || !near(v_[i], sample(state.v, i))) return false;
    }
    return true;
  }
  static constexpr int samples = 3;
  static bool near(double a, double b) {
    return std::abs(a - b) <= 4.0 * std::numeric_limits<double>::epsilon() * std::max(std::abs(a), std::abs(b));
  }
  static double sample(const std::vector<double>& values, int i) {
    return values.empty() ? 0.0 : values[(values.size() - 1) * static_cast<std::size_t>(i) / (samples - 1)];
  }

  bool set_ = false;
  double t_ = 0.0;
  double x_[samples] = {};
  double v_[samples] = {};
};

}  // namespace muelle::engine
