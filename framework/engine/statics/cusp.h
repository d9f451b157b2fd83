#pragma once
#include "engine/dynamical_system.h"

#include <vector>

namespace muelle::engine {

/// Nodes (as the system numbers them: unknown / dimension) at whose place the energy has no gradient: the force jumps,
/// however small the move, down to 1e-9 of an element. So it is where two nodes joined by a spring with L0 > 0
/// coincide, at the centre of a ball, on a straight 3D angle whose rest angle is not 0: the force that the system
/// states there (0) is none.
///
/// Each node is moved by 1e-6 and by 1e-9 of `size` [m], the length of a typical element; where the force is
/// continuous the second change is a thousandth of the first.
std::vector<int> nodesOnACusp(const DynamicalSystem& system, const State& state, double size);

}  // namespace muelle::engine
