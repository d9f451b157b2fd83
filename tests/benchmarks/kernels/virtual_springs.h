#pragma once
#include "cloth.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace muelle::benchmarks {

/// Springs as the lecture's object-oriented design has them: an object each, with a virtual function.
class VirtualSprings {
 public:
  /// \param scattered allocated in a random order, with other allocations between; they act in the cloth's order
  VirtualSprings(const Cloth& cloth, bool scattered);
  ~VirtualSprings();
  void force(const double* x, double* f, std::size_t numbers) const;

 private:
  class Element;
  class Spring;
  std::vector<std::unique_ptr<Element>> elements_;
  std::vector<std::unique_ptr<char[]>> between_;
};

}  // namespace muelle::benchmarks
