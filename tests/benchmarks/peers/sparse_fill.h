#pragma once
#include <sunmatrix/sunmatrix_sparse.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace muelle::bench {

/// A sparse matrix (compressed columns) that is filled again and again by the same sequence of entries: where each goes
/// is found out once, as a good user of KLU does.
class SparseFill {
 public:
  /// Notes an entry of the sequence.
  void note(std::size_t row, std::size_t column) { entries_.emplace_back(column, row); }

  /// Ends the sequence.
  void close(std::size_t n) {
    std::vector<std::pair<std::size_t, std::size_t>> sorted = entries_;
    std::sort(sorted.begin(), sorted.end());
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
    rows_.clear();
    begins_.assign(n + 1, 0);
    for (const auto& [column, row] : sorted) {
      rows_.push_back(static_cast<sunindextype>(row));
      ++begins_[column + 1];
    }
    for (std::size_t j = 0; j < n; ++j) begins_[j + 1] += begins_[j];
    slots_.clear();
    for (const auto& entry : entries_) {
      slots_.push_back(
          static_cast<std::size_t>(std::lower_bound(sorted.begin(), sorted.end(), entry) - sorted.begin()));
    }
  }

  bool closed() const { return !begins_.empty(); }
  std::size_t count() const { return rows_.size(); }

  /// Writes the pattern and zeros, for the sequence to be added.
  void begin(SUNMatrix matrix) {
    std::copy(begins_.begin(), begins_.end(), SUNSparseMatrix_IndexPointers(matrix));
    std::copy(rows_.begin(), rows_.end(), SUNSparseMatrix_IndexValues(matrix));
    values_ = SUNSparseMatrix_Data(matrix);
    std::fill(values_, values_ + rows_.size(), 0.0);
    next_ = 0;
  }
  void add(double value) { values_[slots_[next_++]] += value; }

 private:
  std::vector<std::pair<std::size_t, std::size_t>> entries_;  // column, row
  std::vector<std::size_t> slots_;
  std::vector<sunindextype> rows_, begins_;
  double* values_ = nullptr;
  std::size_t next_ = 0;
};

}  // namespace muelle::bench
