#include "engine/forces/matrix_pattern.h"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

namespace muelle::engine {

MatrixPattern::MatrixPattern(int dimension, std::vector<int> rank)
    : dimension_(dimension),
      rank_(std::move(rank)),
      freeNodes_(static_cast<int>(std::ranges::count_if(rank_, [](int r) { return r >= 0; }))) {}

void MatrixPattern::couple(std::span<const int> nodes) {
  for (const int i : nodes) {
    const int column = rank_[static_cast<std::size_t>(i)];
    if (column < 0) continue;
    for (const int j : nodes) {
      const int row = rank_[static_cast<std::size_t>(j)];
      if (row >= 0 && row != column) pairs_.emplace_back(column, row);
    }
  }
}

void MatrixPattern::finish() {
  for (int i = 0; i < freeNodes_; ++i) pairs_.emplace_back(i, i);
  std::sort(pairs_.begin(), pairs_.end());
  pairs_.erase(std::unique(pairs_.begin(), pairs_.end()), pairs_.end());
  const auto d = static_cast<std::size_t>(dimension_);
  if (pairs_.size() * d * d > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
    throw std::length_error("the model's stiffness matrix has more than 2^31 entries; use a method without matrices");
  }
  blockStart_.assign(static_cast<std::size_t>(freeNodes_) + 1, 0);
  blockRow_.reserve(pairs_.size());
  for (const auto& [column, row] : pairs_) {
    ++blockStart_[static_cast<std::size_t>(column) + 1];
    blockRow_.push_back(row);
  }
  for (std::size_t i = 1; i < blockStart_.size(); ++i) blockStart_[i] += blockStart_[i - 1];
  pairs_.clear();
  pairs_.shrink_to_fit();

  const int n = dimension_ * freeNodes_;
  zero_.resize(n, n);
  zero_.resizeNonZeros(static_cast<Eigen::Index>(blockRow_.size() * d * d));
  std::fill_n(zero_.valuePtr(), zero_.nonZeros(), 0.0);
  int entry = 0;
  for (int j = 0; j < freeNodes_; ++j) {
    for (int c = 0; c < dimension_; ++c) {
      zero_.outerIndexPtr()[dimension_ * j + c] = entry;
      for (int b = blockStart_[static_cast<std::size_t>(j)]; b < blockStart_[static_cast<std::size_t>(j) + 1]; ++b) {
        for (int r = 0; r < dimension_; ++r) {
          zero_.innerIndexPtr()[entry++] = dimension_ * blockRow_[static_cast<std::size_t>(b)] + r;
        }
      }
    }
  }
  zero_.outerIndexPtr()[n] = entry;
  std::fill_n(zero_.valuePtr(), entry, 0.0);
}

BlockSlot MatrixPattern::slot(int i, int j) const {
  const int row = rank_[static_cast<std::size_t>(i)], column = rank_[static_cast<std::size_t>(j)];
  if (row < 0 || column < 0) return {};
  const auto next = blockStart_.begin() + column;
  const int start = *next, end = *(next + 1);
  const auto place = std::lower_bound(blockRow_.begin() + start, blockRow_.begin() + end, row);
  const int rank = static_cast<int>(place - blockRow_.begin()) - start;
  return {dimension_ * dimension_ * start + dimension_ * rank, dimension_ * (end - start)};
}

void MatrixPattern::clear(Eigen::SparseMatrix<double>& matrix) const {
  const bool same =
      matrix.rows() == zero_.rows() && matrix.cols() == zero_.cols() && matrix.isCompressed() &&
      matrix.outerIndexPtr()[matrix.cols()] == zero_.outerIndexPtr()[zero_.cols()] &&
      std::equal(zero_.outerIndexPtr(), zero_.outerIndexPtr() + zero_.cols() + 1, matrix.outerIndexPtr()) &&
      std::equal(zero_.innerIndexPtr(), zero_.innerIndexPtr() + zero_.outerIndexPtr()[zero_.cols()],
                 matrix.innerIndexPtr());
  if (same) {
    std::fill_n(matrix.valuePtr(), zero_.outerIndexPtr()[zero_.cols()], 0.0);
  } else {
    matrix = zero_;
  }
}

}  // namespace muelle::engine
