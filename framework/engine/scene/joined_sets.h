#pragma once
#include <numeric>
#include <vector>

namespace muelle::engine {

/// What hangs together: each of 0 .. size - 1 is a set of its own, until sets are joined (union-find with halved
/// paths).
class JoinedSets {
 public:
  explicit JoinedSets(int size) : parent_(static_cast<std::size_t>(size)) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  void join(int i, int j) { at(of(i)) = of(j); }
  /// One member of i's set, the same for all of it.
  int of(int i) {
    while (at(i) != i) i = at(i) = at(at(i));
    return i;
  }

 private:
  int& at(int i) { return parent_[static_cast<std::size_t>(i)]; }

  std::vector<int> parent_;
};

}  // namespace muelle::engine
