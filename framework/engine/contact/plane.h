#pragma once
#include "engine/contact/touch.h"

#include <limits>

namespace muelle::engine {

/// A half space: what lies below the plane through the centre, across the normal, is inside.
template <int D>
struct Plane {
  using Vector = Eigen::Matrix<double, D, 1>;
  static constexpr bool hasFaces = false;

  Vector normal;  ///< unit length, outward

  /// \param r position relative to the centre [m]
  Touch<D> touch(const Vector& r, int /*face*/) const {
    const double gap = normal.dot(r);
    return {gap, -gap, normal, 0.0};
  }
  int face(const Vector&) const { return 0; }
  /// Nothing passes through a half space.
  double thickness() const { return std::numeric_limits<double>::infinity(); }
};

}  // namespace muelle::engine
