#pragma once
#include "harness/state.h"

#include <limits>

namespace muelle::engine {

/// A motion in closed form, in which each lane goes its own way: x'' = force - stiffness x - damping v.
struct LaneMotion {
  In force;      ///< [m/s^2]; empty where there is no such motion
  In stiffness;  ///< [1/s^2]; empty: 0 everywhere
  In damping;    ///< [1/s]; 0 where the stiffness is; empty: 0 everywhere
  /// [s]: no lane turns round more than once within this time.
  double longest = std::numeric_limits<double>::infinity();

  bool exists() const { return !force.empty(); }
  bool isUniform() const { return stiffness.empty(); }
  double acceleration(const State& state, std::size_t lane) const {
    return isUniform() ? force[lane] : force[lane] - stiffness[lane] * state.x[lane] - damping[lane] * state.v[lane];
  }
};

/// Under these accelerations [m/s^2] throughout.
inline LaneMotion uniformMotion(In acceleration) { return {acceleration, {}, {}}; }

/// What a force batch adds to such a motion, by lanes: F = force - stiffness x - damping v. No pointer is null.
struct LaneForces {
  double* force;      ///< [N]
  double* stiffness;  ///< [N/m], not negative
  double* damping;    ///< [kg/s], not negative; only where there is a stiffness
};

}  // namespace muelle::engine
