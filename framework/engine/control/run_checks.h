#pragma once
#include "engine/control/simulate.h"

namespace muelle::engine {

/// Throws std::invalid_argument when an option makes no sense for a run from `start` with this method.
void checkStepOptions(const StepOptions& options, const State& start, bool adaptive);
/// The same of what a run records, after its steps have been checked.
void checkOutputOptions(const RunOptions& options, const State& start);
/// Throws std::invalid_argument when an adaptive method without a largest step could step over a force that no declared
/// time announces: its error estimate never sees what lies between its stages.
void checkForesight(const DynamicalSystem& system, const MethodInfo& method, const StepOptions& options);
/// Throws std::invalid_argument when sizes, masses or the start time make no sense.
void checkSizes(const DynamicalSystem& system, const State& start);
/// Throws std::invalid_argument when the system has rods and the method does not hold them.
void checkRodsAreHeld(const DynamicalSystem& system, const MethodInfo& method);

}  // namespace muelle::engine
