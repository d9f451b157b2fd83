#pragma once
#include "engine/integrator.h"
#include "harness/probes.h"
#include "harness/trajectory.h"

#include <limits>
#include <string>
#include <vector>

namespace muelle::engine {

/// How a run goes.
struct RunOptions {
  double duration = 1.0;   ///< [s], positive
  double h = 0.0;          ///< step [s] of a fixed-step method, first step of an adaptive one (0: chosen)
  bool fixedStep = false;  ///< take h throughout even when the method has an error estimate
  Tolerance tolerance = {};
  double largestStep = std::numeric_limits<double>::infinity();  ///< [s], for adaptive methods
  double stepsAPeriod = 8.0;          ///< an adaptive method takes at least so many in the shortest period of what acts
  long long mostSteps = 100'000'000;  ///< stop, with a report, after so many steps
  long long mostForceEvaluations = std::numeric_limits<long long>::max();  ///< the same for force evaluations
  double outputInterval = 0.0;  ///< [s]; 0: every step. Outputs between steps come from dense output
  /// In place of an interval: the times of the outputs [s], ascending, from dense output; no step ends for them.
  std::vector<double> sampleTimes = {};
  std::vector<double> outputTimes = {};  ///< besides: exact times to be hit by a step [s], ascending
  std::vector<Probe> probes = {};
  /// Integrate to declared times and to zeros of guards, and restart there. At thin obstacles steps are cut in any
  /// case.
  bool locateEvents = true;
  bool compensated = false;           ///< compensated summation of the state and of the time (long runs)
  bool checkStability = true;         ///< warn before the run of a step beyond the stability limit
  bool checkNumericalDamping = true;  ///< warn when the method damps modes that carry energy more than the scene does
  /// Record every output; false keeps only the last one, though the probes are called at each (long runs).
  bool keepStates = true;
  /// What the recorded states may take [byte]. Beyond it every second one is dropped, again and again, and a warning
  /// says so; the first and the last stay.
  double mostMemory = 512.0 * 1024.0 * 1024.0;
  double explosion = 1e5;  ///< stop when the energy exceeds this multiple of its natural scale
  std::string label = {};  ///< of the progress bar; empty: none
};

/// Something found during a run, with its time.
struct RunEvent {
  double t = 0.0;
  std::string what;  ///< "node 3 touches 'ground'", "declared time"
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
  double checkTime = 0.0;             ///< [s] of the looks at stability and numerical damping before it

  bool failed() const { return trajectory.stop.stopped; }
};

/// Advances the system from `start` (start.z may be empty: it is set by the system). Steps are chosen by the error
/// estimate of an adaptive method, else they are options.h; they end at declared times, at zeros of guards and at the
/// output times, and are cut where a node could pass through an obstacle.
///
/// Never returns numbers that are not finite: the run stops with a report that names the unknown and the time. An
/// adaptive method on a system with forces that it cannot foresee (no declared times, no guard) takes at most
/// options.largestStep.
///
/// Throws std::invalid_argument on sizes, masses or options that make no sense, and when the system lacks what the
/// method needs.
RunResult simulate(const DynamicalSystem& system, Integrator& method, State start, const RunOptions& options);

}  // namespace muelle::engine
