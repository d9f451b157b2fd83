#pragma once
#include "harness/integrator.h"
#include "harness/probes.h"
#include "harness/trajectory.h"

#include <string>
#include <vector>

namespace muelle {

/// How a run goes.
struct SimulationOptions {
  double h = 1e-3;         ///< step [s], positive
  double duration = 1.0;   ///< how long to simulate [s]; the last step is shortened to end there
  int outputEvery = 1;     ///< record every so many steps (the first and the last state always)
  std::vector<Probe> probes;
  double explosion = 1e6;  ///< stop when the kinetic energy exceeds this multiple of its natural scale (see simulate())
  std::string label;       ///< shown with a progress bar on a terminal when the run is long; empty: no bar
};

/// Advances the system from `start` and records what happens.
///
/// Stops early, with a report in Trajectory::stop, when a position, velocity or force is not finite, or when the kinetic
/// energy exceeds options.explosion times the larger of its start value and the work scale of the initial forces over
/// the first step's sensible length; the states recorded so far are kept. Throws std::invalid_argument on sizes, masses
/// or options that make no sense.
Trajectory simulate(const DynamicalSystem& system, Integrator& integrator, State start,
                    const SimulationOptions& options);

}  // namespace muelle
