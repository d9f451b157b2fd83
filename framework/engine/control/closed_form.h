#pragma once
#include "engine/lane_motion.h"
#include "harness/state.h"

namespace muelle::engine {

/// What a time of h [s] adds to x and v where each lane goes its own way: under a constant acceleration a h (v + h/2 a)
/// and h a, of an oscillator the solution of its equation, below, at and above critical damping. The time and z are
/// those of `from`.
void closedFormIncrement(const State& from, double h, const LaneMotion& motion, State& increment);

/// The state after that time; `to` is another object.
void moveInClosedForm(const State& from, double h, const LaneMotion& motion, State& to);

}  // namespace muelle::engine
