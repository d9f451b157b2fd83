#pragma once
#include "engine/analysis/look_budget.h"
#include "engine/integrator.h"

#include <string>

namespace muelle::engine {

/// How a fixed step of a method damps the modes that carry energy, against the scene's own damping.
struct NumericalDamping {
  bool exceeds = false;         ///< on modes with h omega > 0.5 and together a tenth of the energy or more
  double share = 0.0;           ///< of the energy in those modes
  double frequency = 0.0;       ///< angular frequency of the one with the most energy [1/s]
  double numericalDecay = 0.0;  ///< amplitude decay that the method adds to it [1/s]
  double ownDecay = 0.0;        ///< amplitude decay by the scene's own damping [1/s]
  std::string sentence;         ///< "... numerical damping exceeds yours ..."; empty when it does not
};

/// Looks at the start and at the end of a pilot run of at most ten steps (and a twentieth of the run): which modes hold
/// the kinetic energy and the elastic energy that the forces can release (Lanczos from the velocities and from the
/// accelerations), and what a step does to each (see Amplification). A decay that costs less than 5 % of the amplitude
/// in `duration` is not worth a word. Within the budget: as many vectors as it has, none below a handful.
///
/// `method` is run on systems of the function's own and on `system`: prepare() it again before it goes on.
NumericalDamping numericalDamping(const DynamicalSystem& system, Integrator& method, const State& start, double h,
                                  double duration, LookBudget& budget);
inline NumericalDamping numericalDamping(const DynamicalSystem& system, Integrator& method, const State& start,
                                         double h, double duration) {
  LookBudget unbounded;
  return numericalDamping(system, method, start, h, duration, unbounded);
}

/// What the method's stability function R takes, by linear theory about the start.
struct StabilityFunctionLoss {
  /// The part of the modes' energy that goes in the whole run: the share of each mode that holds energy at the start,
  /// times 1 - |R(i h omega)|^(2 steps). What moves from slow modes into fast ones on the way is lost besides.
  double share = 0.0;
  double fastest = 0.0;  ///< h omega of the fastest mode
  double factor = 1.0;   ///< |R| there: what a step leaves of its amplitude
};
/// `method` is run on systems of the function's own.
StabilityFunctionLoss stabilityFunctionLoss(const DynamicalSystem& system, Integrator& method, const State& start,
                                            double h, double steps);

}  // namespace muelle::engine
