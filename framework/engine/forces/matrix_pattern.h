#pragma once
#include "harness/types.h"

#include <cstddef>
#include <Eigen/SparseCore>
#include <span>
#include <utility>
#include <vector>

namespace muelle::engine {

/// Where a D x D block lies among the values of a compressed column-major matrix: its column c starts at
/// base + c * stride. base is -1 for a block of a node that is no unknown.
struct BlockSlot {
  int base = -1;
  int stride = 0;
};

/// The sparsity of a system's matrix: the diagonal blocks of all free nodes and the blocks of every pair of free nodes
/// that share an element. It is fixed when the model is first linearised, so that values can be written by position.
class MatrixPattern {
 public:
  /// \param dimension of the blocks   \param rank of each node among the free ones, -1 where it is held
  MatrixPattern(int dimension, std::vector<int> rank);

  /// Couples all nodes of an element with one another; nodes that are not free are left out. Before finish().
  void couple(std::span<const int> nodes);
  /// Sorts what was coupled and lays out the matrix.
  void finish();

  /// The place of block (row node i, column node j); base -1 when either is not free. After finish().
  BlockSlot slot(int i, int j) const;
  /// Makes `matrix` one of this pattern (no allocation when it is already) and sets its values to zero.
  void clear(Eigen::SparseMatrix<double>& matrix) const;

 private:
  int dimension_;
  std::vector<int> rank_;
  int freeNodes_;
  std::vector<std::pair<int, int>> pairs_;  ///< (column, row), by ranks
  std::vector<int> blockStart_;             ///< first block of each block column, and the end
  std::vector<int> blockRow_;
  Eigen::SparseMatrix<double> zero_;
};

/// Adds factor * block at a place; blocks of nodes that are no unknowns vanish.
template <int D>
inline void addBlock(double* values, BlockSlot slot, double factor, const Eigen::Matrix<double, D, D>& block) {
  if (slot.base < 0) return;
  for (int c = 0; c < D; ++c) {
    double* column = values + slot.base + c * slot.stride;
    for (int r = 0; r < D; ++r) column[r] += factor * block(r, c);
  }
}

}  // namespace muelle::engine
