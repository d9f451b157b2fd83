#pragma once
#include "engine/control/simulate.h"
#include "engine/model/model_system.h"

#include <string>

namespace muelle::lab {

/// How far a method's own, modified energy may differ from the true one at a step of a fixed length.
struct OwnEnergy {
  /// The factor by which the energy of a mode may rise (Amplification::energySwing), the largest of the modes that the
  /// system has with everything closed that may close.
  double swing = 1.0;
  bool stable = false;  ///< the step lets none of these modes grow
};
OwnEnergy ownEnergy(const engine::ModelSystem& system, const std::string& method, const engine::RunOptions& options);

/// Where the energy at the ends of a run's steps gets to, less the start's [J].
struct EnergyClimb {
  double highest = 0.0;
  double allowed = 0.0;  ///< how far it might have: up to the end, or to the step at which it went beyond
};

/// Runs up to `until` [s] and follows the energy, no further than to where it is beyond what is allowed.
///
/// Between two switches (a contact or a one-sided spring sets in or lets go, a step is cut in two at an event) a method
/// keeps an energy of its own, and the true one rises to at most `swing` times what the scene had after the first. At a
/// switch the method goes on with another energy of its own, that of other forces or of steps of another length. Both
/// are quadratic forms of the same state, each within the factor `swing` of the true energy, so that within the step of
/// the switch, too, the true one rises by such a factor at most: velocity Verlet that falls on a spring with the speed
/// v between two points of its grid, and is after its step at the depth d, 0 < d <= h v, keeps the share 1 - (h
/// omega)^2 u (1 - u) of its energy, u = d / (h v), and leaves with what it has over the same expression for its last
/// step: a bounce multiplies the energy by 1 / (1 - (h omega)^2 / 4) at most, `swing`; where steps are cut at the
/// events by 1 / (1 - (h omega)^4 / 16). Bounces so take the energy on a random walk, with no end where there are many
/// of them. That is what a stable method makes of a scene that switches; a step that is not stable has no such excuse,
/// nor has one over a place where the force itself jumps (a spring through zero length, without events).
/// \param scale  of the scene's energies [J], see energyScale()
/// \param harmless  a rise that is always allowed [J]
EnergyClimb energyClimb(const engine::ModelSystem& system, const std::string& method,
                        const engine::StepOptions& options, double until, double scale, double harmless,
                        const OwnEnergy& own);

}  // namespace muelle::lab
