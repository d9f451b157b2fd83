#pragma once
#include "engine/kernels/grid_run.h"

#include <span>
#include <string>
#include <vector>

namespace muelle::engine::kernels {

/// What a search for equal strides found.
struct GridSearch {
  std::vector<GridRun> runs;
  std::vector<SpringData> loose;  ///< springs that are in no run: a few
  std::string refusal;            ///< why the springs are no grid; empty where they are one

  bool isGrid() const { return refusal.empty(); }
};

/// Finds the equal strides among springs: those of one difference of node numbers and one damping form are a run, where
/// they fill at least a third of it. A second spring between the same nodes begins a second run of the same stride. It
/// is no grid where more than one spring in twenty is left over, or runs have more gaps than springs altogether.
///
/// Springs between a node and itself have no force, and are left out.
/// \param sameMaterial springs of a run have one material where each coefficient differs from the first spring's by no
///   more than this part of it, and then have the first one's: rest lengths taken from rounded positions differ in
///   their last digits. With 0 no number changes.
GridSearch findRuns(int dimension, std::size_t nodes, std::span<const SpringData> springs, double sameMaterial = 0.0);

}  // namespace muelle::engine::kernels
