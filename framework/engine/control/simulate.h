#pragma once
#include "engine/control/simulation.h"
#include "harness/probes.h"
#include "harness/trajectory.h"

#include <string>
#include <vector>

namespace muelle::engine {

/// How a run goes: how its steps are taken, and what is kept of it.
struct RunOptions : StepOptions {
  double outputInterval = 0.0;  ///< [s]; 0: every step. Outputs between steps come from dense output
  /// In place of an interval: the times of the outputs [s], ascending, from dense output; no step ends for them.
  std::vector<double> sampleTimes = {};
  std::vector<Probe> probes = {};
  bool checkStability = true;         ///< warn before the run of a step beyond the stability limit
  bool checkNumericalDamping = true;  ///< warn when the method damps modes that carry energy more than the scene does
  /// Record every output; false keeps only the last one, though the probes are called at each (long runs).
  bool keepStates = true;
  /// What the recorded states may take [byte]. Beyond it every second one is dropped, again and again, and a warning
  /// says so; the first and the last stay.
  double mostMemory = 512.0 * 1024.0 * 1024.0;
  std::string label = {};  ///< of the progress bar; empty: none
};

/// What a run leaves.
struct RunResult {
  Trajectory trajectory;  ///< outputs, probes, and trajectory.stop with the reason of an early end
  State last;             ///< the last good state, with z
  Work work;
  std::vector<std::string> warnings;  ///< one line each, given before or during the run
  std::vector<RunEvent> events;       ///< at most 10000 are kept; work.events counts all
  long long subdividedSteps = 0;      ///< steps cut so that nothing passes through an obstacle
  double smallestStep = 0.0;          ///< [s] taken
  double wallTime = 0.0;              ///< [s] of the run itself
  double checkTime = 0.0;             ///< [s] of the looks at stability and numerical damping

  bool failed() const { return trajectory.stop.stopped; }
};

/// Advances the system from `start` to the end of the duration, step by step as a Simulation does, and records. (For a
/// look or a push between steps, use that.)
///
/// Never returns numbers that are not finite: the run stops with a report that names the unknown and the time. An
/// adaptive method on a system with forces that it cannot foresee (no declared times, no guard) takes at most
/// options.largestStep.
///
/// Throws std::invalid_argument as Simulation does, and on outputs that make no sense.
RunResult simulate(const DynamicalSystem& system, Integrator& method, State start, const RunOptions& options);

}  // namespace muelle::engine
