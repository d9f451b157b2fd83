#pragma once
#include "peer_contestant.h"

namespace muelle::bench {

/// The loops of the lecture, written by hand without a library: symplectic Euler and velocity Verlet.
template <class Problem>
void addNaive(const Problem& problem, Contestants& all);

}  // namespace muelle::bench
