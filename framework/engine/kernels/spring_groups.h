#pragma once
#include "engine/kernels/spring_run.h"

#include <span>
#include <vector>

namespace muelle::engine::kernels {

/// Springs of any topology, arranged for the kernels: one run a damping form, in an order in which each
/// eight have no node in common as far as that can be. Nodes are padded: node i has the lanes 4i to 4i + 3 as x y z 0
/// in 3D, 2i and 2i + 1 in 2D, i in 1D. The arrays must begin at a multiple of 16 bytes, as std::vector's do; those at
/// a multiple of 32 are read fastest.
///
/// Forces are added one spring after another in the order of order(), on every instruction set alike.
class SpringGroups {
 public:
  /// Springs between a node and itself have no force, and are left out.
  /// \param dimension 1, 2 or 3   \param nodes numbered so that neighbours are close (Cuthill-McKee)
  SpringGroups(int dimension, int nodes, std::span<const SpringData> springs);

  /// Adds the forces of all springs to f [N]. Padding lanes of x and v must be 0; those of f stay what they are.
  void addForce(const double* x, const double* v, double* f) const;

  /// The number in `springs` of each spring, in the order in which their forces are added.
  const std::vector<int>& order() const { return order_; }
  bool usesVelocity() const;

  /// The springs as they stand, a run for each damping form that there is, in the order of the forms.
  const std::vector<SpringRun>& runs() const { return runs_; }

 private:
  int dimension_;
  std::vector<SpringRun> runs_;
  std::vector<int> order_;
};

}  // namespace muelle::engine::kernels
