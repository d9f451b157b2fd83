#pragma once
#include "harness/types.h"

namespace muelle::engine {

/// Where a node is with respect to an obstacle.
template <int D>
struct Touch {
  double gap = 0.0;    ///< [m], below 0 inside the obstacle, 0 on its surface
  double depth = 0.0;  ///< [m] below the surface through which the node came in; -gap but for boxes
  Eigen::Matrix<double, D, 1> normal = Eigen::Matrix<double, D, 1>::Zero();  ///< outward, of unit length
  double curvature = 0.0;  ///< [1/m]: the normal turns by curvature times a displacement along the surface
};

}  // namespace muelle::engine
