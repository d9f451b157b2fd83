#pragma once
#include "harness/state.h"

namespace muelle::engine {

/// What a time of h [s] adds to x and v under the acceleration a [m/s^2] of each lane: h (v + h/2 a) and h a. The time
/// and z are those of `from`.
void uniformIncrement(const State& from, double h, In a, State& increment);

/// The state after that time; `to` is another object.
void moveUniformly(const State& from, double h, In a, State& to);

}  // namespace muelle::engine
