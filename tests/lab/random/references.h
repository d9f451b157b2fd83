#pragma once
#include "engine/model/model_system.h"
#include "engine/scene/scene.h"
#include "harness/trajectory.h"

#include <vector>

namespace muelle::lab {

/// The motion of a scene from `start`, at `times` and at the start, far finer than any run of a study: by dop853 at a
/// tolerance of 1e-13; with rods, which it does not hold, by rattle at four steps, each half of the one before, of
/// 1/32 of the scene's and less, extrapolated to 0 (its error is even in the step); with contacts the finest as it is.
Trajectory finestRun(const engine::Scene& scene, const engine::ModelSystem& system, const State& start,
                     const std::vector<double>& times);

/// The same from a second source: the extrapolation of Boost.odeint (Bulirsch, Stoer) at a tolerance of 1e-13, whose
/// steps end where a force jumps and which else knows nothing of events and modes, with the forces of rods from d^2 L /
/// dt^2 = 0. Friction has a memory that only the engine's control carries from step to step: with it the second source
/// is dormand_prince_5 at 1e-12.
Trajectory secondRun(const engine::Scene& scene, const engine::ModelSystem& system, const State& start,
                     const std::vector<double>& times);

}  // namespace muelle::lab
