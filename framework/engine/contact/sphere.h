#pragma once
#include "engine/contact/touch.h"
#include "engine/forces/length.h"

namespace muelle::engine {

/// A ball (a disc in 2D, an interval in 1D). At the centre itself there is no normal, and so no force.
template <int D>
struct Sphere {
  using Vector = Eigen::Matrix<double, D, 1>;
  static constexpr bool hasFaces = false;

  double radius;  ///< [m]

  /// \param r position relative to the centre [m]
  Touch<D> touch(const Vector& r, int /*face*/) const {
    const double L = length<D>(r);
    const double gap = L - radius;
    if (L == 0.0) return {gap, -gap, Vector::Zero(), 0.0};
    return {gap, -gap, r / L, D == 1 ? 0.0 : 1.0 / L};
  }
  int face(const Vector&) const { return 0; }
  double thickness() const { return 2.0 * radius; }
};

}  // namespace muelle::engine
