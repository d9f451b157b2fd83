#pragma once
#include "engine/model/model_system.h"
#include "harness/trajectory.h"

#include <string>

namespace muelle::lab {

/// A system's motion at 400 equal times by an adaptive method at a tolerance; for a reference dop853 at 1e-14.
/// \param duration [s]
Trajectory runAtTolerance(const engine::ModelSystem& system, const std::string& method, double tolerance,
                          double duration);

/// The largest difference of an unknown at any of the outputs that both have, in parts of the motion (see
/// engine::MotionFrame): of the whole run, for at one instant amplitude and phase can cancel. Infinite where `path` did
/// not reach its end.
double errorOver(const engine::ModelSystem& system, const Trajectory& path, const Trajectory& exact);

}  // namespace muelle::lab
