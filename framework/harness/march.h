#pragma once
#include "harness/probes.h"
#include "harness/symplectic_euler.h"
#include "harness/trajectory.h"

#include <functional>
#include <string>
#include <vector>

namespace muelle {

/// A method: one step of h [s] from `from` to `to`, which has the same sizes and is another object.
using Step = std::function<void(const DynamicalSystem& system, const State& from, double h, State& to)>;

/// How a march goes.
struct MarchOptions {
  double h = 1e-3;        ///< step [s], positive
  double duration = 1.0;  ///< how long to simulate [s]; the last step is shortened to end there
  int outputEvery = 1;    ///< record every so many steps (the first and the last state always)
  std::vector<Probe> probes = {};
  double explosion = 1e6;  ///< stop when the kinetic energy exceeds this multiple of its natural scale (see march())
  std::string label = {};  ///< shown with a progress bar on a terminal when the run is long; empty: no bar
  /// Degrees of freedom a node (1, 2 or 3), to name nodes in a stop report. 0: 3 when the masses come in triples of
  /// equal numbers, otherwise 1.
  int dimension = 0;
};

/// Advances the system from `start` step by step and records what happens: the small run of demos and exercises. Every
/// step is exactly h but the last, which is shortened to end at start.t + duration (a remainder below 1e-12 of the
/// duration is rounding and makes no step of its own).
///
/// Stops early, with a report in Trajectory::stop, when a position, velocity or force is not finite, or when the
/// kinetic energy explodes; the states before that are kept, and the last of them is always recorded. The force is
/// evaluated once at the start for this, and once more after a failure to tell whether it is the cause.
///
/// Explosion: the kinetic energy exceeds options.explosion times its natural scale
///
///     S = max( M v1^2 / 2,  sum_i m_i (|v_i| + |F_i| T / m_i)^2 / 2 ),
///
/// with M the total of the masses given, v1 = 1 m/s, v_i, F_i at the start, and T the duration. The sum bounds what
/// constant forces of the initial size could give: a fall from rest has at most S, whatever its length, and an
/// oscillator of angular frequency w at most S / (w T)^2. The first term covers a start at rest and in balance, where
/// both v_i and F_i vanish and a load comes later: with the default 1e6 nothing slower than 1 km/s stops the run. An
/// unstable method multiplies the energy by a constant factor each step, so it passes 1e6 S long before numbers
/// overflow; a single step that overflows at once is caught as not finite.
///
/// Throws std::invalid_argument on sizes, masses or options that make no sense; what a force or a probe throws passes
/// through.
Trajectory march(const DynamicalSystem& system, State start, const MarchOptions& options,
                 const Step& step = symplecticEulerStep);

}  // namespace muelle
