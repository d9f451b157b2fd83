#pragma once
#include "engine/elements/element_batch.h"

namespace muelle::engine {

/// Signed volume of a tetrahedron: E = k (V - V0)^2 / 2, V = u . (w x y) / 6 with u = b - a, w = c - a, y = d - a. An
/// inverted tetrahedron has V < 0 and is driven back through 0; nothing is degenerate, V is a polynomial.
struct Volume {
  static constexpr int nodeCount = 4;
  using Positions = Eigen::Matrix<double, 3, 4>;
  using Vector = Eigen::Matrix<double, 12, 1>;
  using Matrix = Eigen::Matrix<double, 12, 12>;

  std::array<int, 4> nodes{};
  double k = 0.0;   ///< [N/m^5]
  double V0 = 0.0;  ///< [m^3]

  double energy(const Positions& X) const;
  Vector gradient(const Positions& X) const;
  Matrix hessian(const Positions& X) const;
  /// The volume is cubic: Simpson's rule over its gradient gives its difference exactly.
  Vector discreteGradient(const Positions& Xa, const Positions& Xb) const;
  bool constraint(const Positions& X, double& C, double& stiffness, Vector& dC) const;
};

extern template class ElementBatch<3, Volume>;

}  // namespace muelle::engine
