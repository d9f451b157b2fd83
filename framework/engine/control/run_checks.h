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

/// The shortest period [s] of what acts or moves at any time of a run, however short it acts: looked at between all
/// declared times, at which periods change. Infinite where nothing has one.
double shortestPeriodOf(const DynamicalSystem& system, double from, double to);

/// The largest part of a period that a fixed step may be, to be taken for resolving it.
inline constexpr double resolvedPart = 0.25;

/// One sentence where a fixed step h does not resolve what acts from `from` to `to`; empty otherwise.
std::string unresolvedWarning(const DynamicalSystem& system, double from, double to, double h);

}  // namespace muelle::engine
