#pragma once

namespace muelle {

/// A spring between two nodes of a mesh: plain data, in SI units.
struct Spring {
  int a = 0;        ///< index of the first node
  int b = 1;        ///< index of the second node
  double k = 1.0;   ///< stiffness [N/m], positive
  double L0 = 1.0;  ///< rest length [m], not negative
};

}  // namespace muelle
