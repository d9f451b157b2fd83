#pragma once
#include "engine/integrator.h"

#include <limits>
#include <vector>

namespace muelle::engine {

/// How steps are taken, whoever looks at them.
struct StepOptions {
  double duration = 1.0;   ///< [s], positive: how far from the start steps may go
  double h = 0.0;          ///< step [s] of a fixed-step method, first step of an adaptive one (0: chosen)
  bool fixedStep = false;  ///< take h throughout even when the method has an error estimate
  Tolerance tolerance = {};
  double largestStep = std::numeric_limits<double>::infinity();  ///< [s], for adaptive methods
  double stepsAPeriod = 8.0;          ///< an adaptive method takes at least so many in the shortest period of what acts
  long long mostSteps = 100'000'000;  ///< stop, with a report, after so many steps
  long long mostForceEvaluations = std::numeric_limits<long long>::max();  ///< the same for force evaluations
  std::vector<double> outputTimes = {};  ///< exact times to be hit by a step [s], ascending
  /// Integrate to declared times and to zeros of guards, and restart there. At thin obstacles steps are cut in any
  /// case, and adaptive methods end steps at declared times in any case: at rest nothing else tells them of a pulse.
  bool locateEvents = true;
  bool compensated = false;  ///< compensated summation of the state and of the time (long runs)
  double explosion = 1e5;    ///< stop when the energy exceeds this multiple of its natural scale
};

}  // namespace muelle::engine
