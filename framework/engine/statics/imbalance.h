#pragma once

namespace muelle::engine {

/// How far a shape is from rest.
struct Imbalance {
  double force = 0.0;       ///< largest sum of forces on a free node, springs by their tensions [N]
  int worstUnknown = 0;     ///< an unknown of that node
  double length = 0.0;      ///< largest |L - L0 - T/k| of the springs whose tension is an unknown [m]; -1: none is
  bool atRoundOff = false;  ///< both are what the last bits of tensions, lengths and the other forces leave
  double forceFloor = 0.0;  ///< what these bits do to the sum of forces on that node [N]
  double merit = 0.0;       ///< both in one number, for line searches: 1 is the size of the loads
};

}  // namespace muelle::engine
