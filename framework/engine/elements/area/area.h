#pragma once
#include "engine/elements/element_batch.h"

namespace muelle::engine {

/// Signed area of a triangle: E = k (A - A0)^2 / 2. In 2D A > 0 when a, b, c go anticlockwise; in 3D A is the area of
/// the projection along a unit vector. An inverted triangle has A < 0 and is driven back through 0; nothing is
/// degenerate: A = u^T S w / 2, u = b - a, w = c - a, is a polynomial, S the quarter turn (2D) or [normal]x (3D).
template <int D>
struct Area {
  static constexpr int nodeCount = 3;
  using Positions = Eigen::Matrix<double, D, 3>;
  using Vector = Eigen::Matrix<double, 3 * D, 1>;
  using Matrix = Eigen::Matrix<double, 3 * D, 3 * D>;
  using Turn = Eigen::Matrix<double, D, D>;

  std::array<int, 3> nodes{};
  double k = 0.0;   ///< [N/m^3]
  double A0 = 0.0;  ///< [m^2]
  Turn S;           ///< antisymmetric

  double energy(const Positions& X) const;
  Vector gradient(const Positions& X) const;
  Matrix hessian(const Positions& X) const;
  /// The area is quadratic: its difference is its gradient at the middle times the displacement.
  Vector discreteGradient(const Positions& Xa, const Positions& Xb) const;
  bool constraint(const Positions& X, double& C, double& stiffness, Vector& dC) const;

 private:
  double area(const Positions& X) const;
  Vector areaGradient(const Positions& X) const;
};

extern template class ElementBatch<2, Area<2>>;
extern template class ElementBatch<3, Area<3>>;

}  // namespace muelle::engine
