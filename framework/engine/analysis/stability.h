#pragma once
#include "engine/analysis/look_budget.h"
#include "engine/analysis/spectrum.h"
#include "engine/analysis/spectrum_bound.h"
#include "engine/integrator.h"

#include <limits>
#include <string>

namespace muelle::engine {

/// The largest stable step of a method on a system about a state.
struct StabilityReport {
  /// [s]; infinite when every step is stable, 0 when every step makes a mode grow.
  double largestStep = std::numeric_limits<double>::infinity();
  Mode mode;             ///< the one that sets the limit
  std::string unknown;   ///< where it moves most, in the user's words
  std::string sentence;  ///< the same for people
};

/// What may close counts as closed: contacts and one-sided springs (see Switching::close()). The limit holds for the
/// whole of a run that begins in `state`, as far as one can tell there.
///
/// The supremum of the steps h without growth over the extreme modes of the coupled stiffness and damping (Krylov
/// estimates, see extremeModes()), from the method's own steps on each mode (see Amplification). Modes of negative
/// stiffness grow by their physics and set no limit.
///
/// Exact for Runge-Kutta methods. Where a method treats positions and velocities apart and stiffness and damping do not
/// commute, the limit is an estimate, off by a few per cent.
///
/// `method` is run on systems of the function's own: prepare() it again before it goes on with another one.
StabilityReport stability(const DynamicalSystem& system, Integrator& method, const State& state);

/// A step up to which no mode within the bound grows [s]: at most the limit of stability(), which it approaches where
/// the bound is close. 0 where a method has no stable step on modes that damping may leave alone.
double sureStep(Integrator& method, const SpectrumBound& bound);

/// What a step of h does: one sentence with the limit when, over `steps` steps, an unstable mode grows tenfold or more;
/// empty otherwise. Cheaper than stability() when all is well. `method` as above.
///
/// Where the modes would cost more than the budget has, the step is held against sureStep(): the sentence then says
/// that it may be unstable, and up to which step it surely is not. A system without matrices has no such bound: it gets
/// as many vectors as the budget has.
std::string instabilityWarning(const DynamicalSystem& system, Integrator& method, const State& state, double h,
                               double steps, LookBudget& budget);

/// The same during a run, where modes have switched on: by the method's known limit of h omega on undamped modes, so
/// that the method itself is left alone. Empty where it has none.
std::string lateInstabilityWarning(const DynamicalSystem& system, const MethodInfo& method, const State& state,
                                   double h, LookBudget& budget);

}  // namespace muelle::engine
