#pragma once
#include "engine/model/model.h"

namespace muelle::engine {

/// Throws std::invalid_argument, naming the item and what is wrong with it, for the first of these:
/// a dimension other than 1, 2, 3 or a plane that is not two different axes; no nodes, or none free; numbers that are
/// not finite; masses that are not positive; stiffnesses, rest lengths or dampings below 0; stiffnesses and masses so
/// small that they are stored with fewer digits (denormal); indices of nodes or motions that do not exist; elements
/// that use a node twice; two springs between the same nodes; volumes and dihedrals outside 3D, areas and angles in 1D;
/// gravity or a plane's normal out of the scene's axes; directions that are not of unit length.
///
/// Allowed on purpose: a free node without any spring (it flies), coincident nodes (the force of a spring of zero
/// length is 0), stiffness 0, and coordinates up to the largest double (lengths do not overflow before they must).
void validate(const Model& model);

}  // namespace muelle::engine
