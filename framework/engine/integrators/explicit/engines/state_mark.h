#pragma once
#include "harness/state.h"

namespace muelle::engine {

/// Tells whether a state is the one at which a force is kept, by its time and a few of its entries. It guards against
/// a caller that goes on from another state without restart(); the internal variables are the caller's to announce.
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
    if (!set_ || t_ != state.t) return false;
    for (int i = 0; i < samples; ++i) {
      if (x_[i] != sample(state.x, i) || v_[i] != sample(state.v, i)) return false;
    }
    return true;
  }

 private:
  static constexpr int samples = 5;
  static double sample(const std::vector<double>& values, int i) {
    return values.empty() ? 0.0 : values[(values.size() - 1) * static_cast<std::size_t>(i) / (samples - 1)];
  }

  bool set_ = false;
  double t_ = 0.0;
  double x_[samples] = {};
  double v_[samples] = {};
};

}  // namespace muelle::engine
