#pragma once
/// \file
/// H16's cloth, written once more and apart from the engine, for the references of its stiff variants.

#include <vector>

namespace muelle::hard_cases {

/// Positions (x, y, z) of nodes 44 and 99 and the energy [J], seven numbers, of the cloth of H16 after `duration` [s]
/// with the stiffness k [N/m] and the case's damping of 0.01 kg/s. By the integrator of gragg_bulirsch_stoer.h in long
/// double. The values of cases.json are those of the tolerance 1e-12; below it the rounding of 64 bits takes over.
std::vector<long double> clothAfter(long double k, long double duration, long double tolerance);

}  // namespace muelle::hard_cases
