#pragma once
#include "engine/contact/touch.h"

namespace muelle::engine {

/// One node against an obstacle, at one configuration.
template <int D>
struct Meeting {
  using Vector = Eigen::Matrix<double, D, 1>;

  Touch<D> touch;
  Vector r = Vector::Zero();  ///< position relative to the obstacle's centre [m]
  Vector w = Vector::Zero();  ///< velocity relative to the obstacle [m/s]
  double N = 0.0;             ///< normal force as if closed [N]
  bool acts = false;          ///< whether there is contact, by the mode or, live, by the position

  Vector alongSurface(const Vector& u) const { return u - touch.normal * touch.normal.dot(u); }
};

}  // namespace muelle::engine
