#pragma once
#include <cmath>
#include <Eigen/Core>

namespace muelle::engine {

/// length() where squares overflow or underflow. Apart from it, so that length() is short enough to be inlined.
template <int D>
[[gnu::noinline]] double scaledLength(const Eigen::Matrix<double, D, 1>& d) {
  const double largest = d.cwiseAbs().maxCoeff();
  if (largest == 0.0 || !std::isfinite(largest)) return largest;
  int exponent = 0;
  std::frexp(largest, &exponent);
  Eigen::Matrix<double, D, 1> scaled;
  for (int i = 0; i < D; ++i) scaled[i] = std::ldexp(d[i], -exponent);
  return std::ldexp(scaled.norm(), exponent);
}

/// Euclidean length of d, right wherever the result is a double: squares that overflow or underflow are scaled first,
/// so that (3e200, 4e200) has length 5e200 and (3e-200, 4e-200) has 5e-200.
template <int D>
inline double length(const Eigen::Matrix<double, D, 1>& d) {
  if constexpr (D == 1) {
    return std::abs(d[0]);
  } else {
    const double square = d.squaredNorm();
    return square > 1e-280 && square < 1e280 ? std::sqrt(square) : scaledLength<D>(d);
  }
}

}  // namespace muelle::engine
