#pragma once
#include <Eigen/Core>

namespace muelle::engine {

/// Discrete gradient of Gonzalez (1996): the gradient at the middle, corrected along the displacement so that
/// G . (xb - xa) = Cb - Ca. The quotient is guarded: where the displacement is below 1e-5 of `scale`, the correction,
/// which is of third order in it, is below rounding and is left out.
///
/// \param middle gradient of C at the middle   \param delta xb - xa   \param difference C(xb) - C(xa)
/// \param scale a length over which C is smooth
template <class Vector>
inline Vector gonzalez(const Vector& middle, const Vector& delta, double difference, double scale) {
  const double square = delta.squaredNorm();
  if (!(square > 1e-10 * scale * scale)) return middle;
  return middle + ((difference - middle.dot(delta)) / square) * delta;
}

}  // namespace muelle::engine
