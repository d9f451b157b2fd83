#pragma once
#include "engine/control/step_options.h"
#include "harness/trajectory.h"

namespace muelle::engine {

/// Why steps end before their time, in one line that names time, unknown and what to do.

/// The unknown whose force at time t, from this state, is not finite; no stop when all are.
StopReport notFiniteForce(const DynamicalSystem& system, const State& state, double t);
/// A step of this length cannot be taken, and shorter ones neither.
StopReport failedStep(const MethodInfo& method, double t, double length, const StepResult& result);
/// Steps in pieces of `nominal` fail again and again, the last one of this length.
StopReport failingPieces(const MethodInfo& method, double t, double nominal, double length, const StepResult& result);
/// A step of this length is as short as may be and misses the tolerance still.
StopReport inexactStep(double t, double length, const StepResult& result, const Tolerance& tolerance);
/// A limit of the options is reached; no stop when none is.
StopReport reachedLimit(const StepOptions& options, const Work& work, double t);

}  // namespace muelle::engine
