#pragma once
#include "harness/types.h"

namespace muelle {

/// A point that carries mass: plain data, in SI units.
struct Node {
  Vec3 x = Vec3::Zero();  ///< position [m]
  Vec3 v = Vec3::Zero();  ///< velocity [m/s]
  double m = 1.0;         ///< mass [kg], positive
  bool pinned = false;    ///< a pinned node does not move, whatever the force
};

}  // namespace muelle
