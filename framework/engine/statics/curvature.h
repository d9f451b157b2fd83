#pragma once
#include <vector>

namespace muelle::engine {

/// The smallest eigenvalue of the stiffness matrix at a shape, and how well it is known.
struct Curvature {
  bool known = false;         ///< false: no factorisation could be trusted
  double smallest = 0.0;      ///< [N/m]
  double roundOff = 0.0;      ///< what round-off does to it [N/m]: within it nobody knows its sign
  int negative = 0;           ///< how many eigenvalues are below zero, those within round-off aside
  std::vector<double> along;  ///< its eigenvector, of length 1
};

}  // namespace muelle::engine
