#pragma once
#include "lab/bench/scene.h"
#include "peer_contestant.h"

namespace muelle::bench {

/// Boost.odeint: rk4, dopri5, fehlberg78, bulirsch_stoer, and where the force does not ask for the velocity
/// velocity_verlet and the symplectic sb3a methods.
template <class Problem>
void addOdeint(const Problem& problem, Contestants& all);

/// dopri5 with dense output on a ball over a ground: contacts found by bisection, each phase integrated as a smooth
/// one. Row A only: the phases need forces of their own. `scene` must outlive it.
void addOdeintBall(const BenchScene& scene, Contestants& all);

}  // namespace muelle::bench
