#pragma once
#include "engine/kernels/grid_springs.h"
#include "engine/model/model.h"
#include "harness/state.h"

#include <vector>

namespace muelle::engine {

/// What a pass over the nodes of a grid takes besides the springs.
struct GridNodes {
  std::size_t plane = 0;        ///< lanes between the components of a node
  std::vector<double> drag;     ///< [kg/s] of each place; empty: none
  Vec3 gravity = Vec3::Zero();  ///< [m/s^2], by the scene's own components
};

/// The accelerations of a model whose springs lie on a grid, all of them plain: springs, gravity, drag and 1/m in one
/// pass of the kernels (engine/kernels/grid_springs.h). It is the same sum as that of the batches of these forces, in
/// another order.
class GridForce {
 public:
  GridForce(kernels::GridSprings springs, GridNodes nodes) : springs_(std::move(springs)), nodes_(std::move(nodes)) {}

  /// Overwrites a. \param added [N] all other forces, by lanes; null: none   \param withDrag whether the drag acts
  void accelerate(In x, In v, const double* added, std::span<const double> inverseMass, bool withDrag, Out a) const;

 private:
  kernels::GridSprings springs_;
  GridNodes nodes_;
};

}  // namespace muelle::engine
