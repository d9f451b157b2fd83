#pragma once
#include "engine/kernels/spring_data.h"

#include <cstddef>
#include <vector>

namespace muelle::benchmarks {

/// A square cloth in space, n by n nodes of which the positions are a little beside the grid, with structural, shear
/// and bending springs; node (i, j) is number i n + j.
struct Cloth {
  int nodes = 0;
  std::vector<engine::kernels::SpringData> springs;
  std::vector<double> x, v;  ///< three numbers a node
};

/// \param damped whether each spring has projected damping
Cloth makeCloth(int n, bool damped);

/// The same cloth with nodes numbered and springs listed in a random order.
Cloth shuffled(const Cloth& cloth);

/// The same cloth with nodes numbered by the engine's reverse Cuthill-McKee order.
Cloth renumbered(const Cloth& cloth);

/// The same cloth with node i at `place[i]` of `count`.
Cloth placed(const Cloth& cloth, const std::vector<int>& place, int count);

}  // namespace muelle::benchmarks
