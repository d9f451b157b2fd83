#pragma once
#include "engine/kernels/spring_data.h"

#include <cstddef>
#include <span>
#include <vector>

namespace muelle::engine::kernels {

/// A place in the box around a lattice for each node: the shortest side of the box runs fastest.
struct LatticePlaces {
  std::vector<int> place;  ///< empty where the nodes lie on no lattice
  std::size_t places = 0;  ///< at most twice as many as nodes
};

/// Finds up to three vectors of springs such that each spring's and each node's position relative to the first is a sum
/// of whole multiples of them, to a hundredth. \param x positions, `dimension` numbers a node
LatticePlaces placesOnLattice(int dimension, std::span<const double> x, std::span<const SpringData> springs);

}  // namespace muelle::engine::kernels
