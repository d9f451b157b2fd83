#pragma once
#include "engine/kernels/grid_search.h"

#include <span>
#include <vector>

namespace muelle::engine::kernels {

/// How the nodes of a grid were found to lie.
enum class GridOrder {
  AsGiven,      ///< as a generator numbers them
  AlongChains,  ///< no node has more than two neighbours: from one end to the other, chain after chain
  Lattice,      ///< by steps between positions
  None,         ///< no grid
};

/// Places for the nodes of a grid, and the springs between places.
struct GridNumbering {
  GridOrder order = GridOrder::None;
  std::vector<int> place;  ///< of each node; some places may have none
  std::size_t places = 0;
  GridSearch search;  ///< runs and loose springs in places; where there is no grid, why the order as given is none
};

/// Finds the grid in springs between nodes: first in the order as given; then along chains; then by a lattice, where
/// the springs' vectors between the positions are sums of whole multiples of at most three of them (a cloth or a block,
/// turned or sheared or not, with holes or not, in any order). A bent sheet whose nodes are in no grid order is not
/// found. \param x positions [m], `dimension` numbers a node, best those in which the springs are at rest \param
/// sameMaterial as for findRuns()
GridNumbering findGrid(int dimension, std::span<const double> x, std::span<const SpringData> springs,
                       double sameMaterial = 0.0);

}  // namespace muelle::engine::kernels
