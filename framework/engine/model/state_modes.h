#pragma once
#include "harness/state.h"

#include <vector>

namespace muelle::engine {

/// The internal variables of a state. A recorded one has lost them: with zeros the modes are live, as the positions
/// say, and no anchor is known.
struct StateModes {
  /// \param count how many internal variables the system has. The state must outlive this.
  StateModes(const State& state, int count)
      : live(state.z.empty() ? static_cast<std::size_t>(count) : 0, 0.0), z(state.z.empty() ? In(live) : In(state.z)) {}
  StateModes(const StateModes&) = delete;
  StateModes& operator=(const StateModes&) = delete;

  std::vector<double> live;
  In z;
};

}  // namespace muelle::engine
