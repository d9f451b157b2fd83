#pragma once
#include "engine/contact/touch.h"

#include <cmath>

namespace muelle::engine {

/// A box along the axes; infinite half sizes make a slab or a bar. A node is pushed back through the face by which it
/// came in, however deep it is: with the nearest face a node past the middle would be pushed through. Faces are named
/// by their axis and side: +1 or -1 for the first axis, +2 or -2 for the second, and so on.
template <int D>
struct Box {
  using Vector = Eigen::Matrix<double, D, 1>;
  static constexpr bool hasFaces = true;

  Vector halfSize;  ///< [m]

  /// \param r position relative to the centre [m]   \param face by which the node came in; 0: the nearest
  Touch<D> touch(const Vector& r, int face) const {
    if (face == 0) face = this->face(r);
    const int axis = std::abs(face) - 1;
    const double side = face > 0 ? 1.0 : -1.0;
    Touch<D> touch;
    touch.gap = (r.cwiseAbs() - halfSize).maxCoeff();
    touch.depth = halfSize[axis] - side * r[axis];
    touch.normal[axis] = side;
    return touch;
  }
  /// The face that the node is at: the one it is farthest outside of, or least inside.
  int face(const Vector& r) const {
    int axis = 0;
    (r.cwiseAbs() - halfSize).maxCoeff(&axis);
    return r[axis] < 0.0 ? -(axis + 1) : axis + 1;
  }
  double thickness() const { return 2.0 * halfSize.minCoeff(); }
};

}  // namespace muelle::engine
