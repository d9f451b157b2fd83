#pragma once
#include <cmath>
#include <Eigen/Core>

namespace muelle::engine {

/// Euclidean length of d, right wherever the result is a double: squares that overflow or underflow are scaled first,
/// so that (3e200, 4e200) has length 5e200 and (3e-200, 4e-200) has 5e-200.
template <int D>
inline double length(const Eigen::Matrix<double, D, 1>& d) {
  if constexpr (D == 1) {
    return std::abs(d[0]);
  } else {
    const double square = d.squaredNorm();
    if (square > 1e-280 && square < 1e280) return std::sqrt(square);
    const double largest = d.cwiseAbs().maxCoeff();
    if (largest == 0.0 || !std::isfinite(largest)) return largest;
    int exponent = 0;
    std::frexp(largest, &exponent);
    Eigen::Matrix<double, D, 1> scaled;
    for (int i = 0; i < D; ++i) scaled[i] = std::ldexp(d[i], -exponent);
    return std::ldexp(scaled.norm(), exponent);
  }
}

}  // namespace muelle::engine
