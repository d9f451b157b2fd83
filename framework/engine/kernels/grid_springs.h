#pragma once
#include "engine/kernels/fixed_window.h"
#include "engine/kernels/grid_buffers.h"
#include "engine/kernels/grid_run.h"
#include "engine/kernels/kernel_arguments.h"
#include "engine/kernels/precision.h"

#include <optional>
#include <span>
#include <vector>

namespace muelle::engine::kernels {

/// Doubles between the components of nodes in planes: a multiple of 8, not less than the number of nodes, and such that
/// the same node's components do not fall into the same set of the first cache.
std::size_t planeFor(std::size_t nodes);

/// Springs of a grid (a chain, a cloth, a lattice): for each stride a buffer takes the force of every spring, and one
/// pass over the nodes sums f[i] = sum of g_s[i] - g_s[i - s], in the order of the runs, own before past; loose springs
/// follow, one after another. So the sums are the same on every instruction set, and whatever the size of the blocks.
///
/// It goes over the nodes in blocks, for each all runs and then the sum; a buffer reaches back by its stride and no
/// further, so that they stay in the cache.
///
/// evaluate() uses scratch memory of the object: one thread an object.
class GridSprings {
 public:
  /// \param dimension 1, 2 or 3   \param nodes places in the grid, empty ones included
  /// \param loose springs that are in no run   \param block nodes a block, a multiple of 8; 0: what is fast
  /// \param precision of the runs; loose springs are computed in double
  GridSprings(int dimension, std::size_t nodes, std::vector<GridRun> runs, std::vector<SpringData> loose = {},
              std::size_t block = 0, Precision precision = Precision::Double);

  /// Writes accelerations or forces of all nodes to finish.out, 0 in the rest of each plane.
  void evaluate(const PlanarState& at, const PlanarFinish& finish) const;

  std::size_t springs() const;
  bool usesVelocity() const;
  const std::vector<GridRun>& runs() const { return runs_; }
  const std::vector<SpringData>& loose() const { return loose_; }

 private:
  /// Springs of a run in single precision.
  struct SingleMaterial {
    std::vector<float> k, L0, dRelative, dProjected;
  };

  void evaluateDouble(const PlanarState& at, const PlanarFinish& finish) const;
  bool evaluateSingle(const PlanarState& at, const PlanarFinish& finish) const;
  void sweepSingle(const PlanarState& at, const PlanarFinish& finish) const;
  template <class Real, class RunForce, class Pass>
  void sweep(GridBuffers<Real>& buffers, const RunForce& force, const Pass& pass) const;
  std::vector<std::size_t> strides() const;
  bool runsAreDamped() const;
  void addLoose(const PlanarState& at, const PlanarFinish& finish) const;

  int dimension_;
  std::size_t nodes_;
  std::size_t lanes_;  ///< of a plane that are gone over: the nodes, rounded up to a multiple of 8
  std::size_t block_;
  Precision precision_;
  std::vector<GridRun> runs_;
  std::vector<SpringData> loose_;
  std::vector<SingleMaterial> single_;               ///< of each run, where it is asked for
  mutable std::optional<GridBuffers<double>> sums_;  ///< made when they are first needed
  mutable std::optional<GridBuffers<float>> singleSums_;
  mutable std::optional<FixedWindow> x_, v_;  ///< v where any run is damped
  mutable std::vector<std::size_t> gap_;      ///< of each run, the first one ahead
};

}  // namespace muelle::engine::kernels
