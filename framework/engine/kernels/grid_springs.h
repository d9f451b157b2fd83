#pragma once
#include "engine/kernels/grid_run.h"
#include "engine/kernels/kernel_arguments.h"

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
  GridSprings(int dimension, std::size_t nodes, std::vector<GridRun> runs, std::vector<SpringData> loose = {},
              std::size_t block = 0);

  /// Writes accelerations or forces of all nodes to finish.out, 0 in the rest of each plane.
  void evaluate(const PlanarState& at, const PlanarFinish& finish) const;

  std::size_t springs() const;
  bool usesVelocity() const;
  const std::vector<GridRun>& runs() const { return runs_; }
  const std::vector<SpringData>& loose() const { return loose_; }

 private:
  /// Where a run's forces stand: the block's own from `lead` on, behind them the last ones of the block before; or, for
  /// a long stride, a ring of blocks, of which the first is repeated behind the last.
  struct Buffer {
    std::size_t stride, lead, ring, plane, offset;
    std::size_t own(std::size_t begin) const { return offset + lead + (ring ? begin % ring : 0); }
    std::size_t past(std::size_t begin) const {
      return ring ? offset + (begin + ring - stride % ring) % ring : offset + lead - stride;
    }
  };

  Buffer bufferFor(std::size_t stride, std::size_t offset) const;
  double* scratch() const;
  void clearPast() const;
  void runBlock(std::size_t r, const PlanarState& at, std::size_t begin, std::size_t end) const;
  void keepPast(std::size_t r, std::size_t begin, std::size_t end) const;
  void addLoose(const PlanarState& at, const PlanarFinish& finish) const;

  int dimension_;
  std::size_t lanes_;  ///< of a plane that are gone over: the nodes, rounded up to a multiple of 8
  std::size_t block_;
  std::vector<GridRun> runs_;
  std::vector<SpringData> loose_;
  std::vector<Buffer> buffers_;
  std::vector<std::size_t> planes_;
  mutable std::vector<double> scratch_;
  mutable std::vector<std::size_t> gap_;  ///< of each run, the first one ahead
  mutable std::vector<const double*> own_, past_;
};

}  // namespace muelle::engine::kernels
