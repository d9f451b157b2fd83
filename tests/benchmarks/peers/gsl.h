#pragma once
#include "peer_contestant.h"

namespace muelle::bench {

/// GNU Scientific Library: rk8pd, msadams, and on at most 20 unknowns msbdf, whose matrix is dense.
template <class Problem>
void addGsl(const Problem& problem, Contestants& all);

std::string gslVersion();

}  // namespace muelle::bench
