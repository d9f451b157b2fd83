#pragma once
#include "harness/node.h"
#include "harness/spring.h"

#include <vector>

namespace muelle {

/// Nodes and the springs between them, as data. Building one, lumping its mass and choosing its springs are exercises,
/// so nothing here does it: a demo that needs a mesh has it written out, in a header of its folder where it is long.
///
///     const muelle::Mesh bar = {{{Vec3(0, 0, 0)}, {Vec3(0, 0, 1)}}, {{0, 1, 100.0, 1.0}}};
struct Mesh {
  std::vector<Node> nodes;
  std::vector<Spring> springs;
};

}  // namespace muelle
