#pragma once
#include "engine/kernels/kernel_arguments.h"

#include <vector>

namespace muelle::engine::kernels {

/// Springs of any topology and of one damping form, in arrays. A node is given by its first lane.
struct SpringRun {
  Damping damping = Damping::None;
  std::vector<int> a, b;                ///< first lane of each end
  std::vector<double> k, L0;            ///< [N/m], [m]
  std::vector<double> dRelative = {};   ///< [kg/s]; empty where the form has none
  std::vector<double> dProjected = {};  ///< [kg/s]; empty where the form has none

  std::size_t size() const { return a.size(); }
  SpringArrays arrays() const {
    return {size(), a.data(), b.data(), k.data(), L0.data(), dRelative.data(), dProjected.data()};
  }
  /// \param width lanes from a node to the next
  void append(const SpringData& spring, int dimension, int width) {
    a.push_back(width * spring.a);
    b.push_back(width * spring.b);
    k.push_back(spring.k);
    L0.push_back(spring.L0);
    if (damping == Damping::Relative || damping == Damping::Both) {
      dRelative.push_back(relativeDampingOf(spring, dimension));
    }
    if (damping == Damping::Projected || damping == Damping::Both) dProjected.push_back(spring.dProjected);
  }
};

}  // namespace muelle::engine::kernels
