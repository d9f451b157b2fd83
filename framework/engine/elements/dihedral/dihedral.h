#pragma once
#include "engine/elements/element_batch.h"

namespace muelle::engine {

/// Bending between the triangles (a, b, c) and (b, a, d) about their edge ab: E = k (theta - theta0)^2 / 2, theta in
/// (-pi, pi] the angle from the normal (b - a) x (c - a) to the normal (a - b) x (d - b) about the direction of b - a;
/// 0 when flat.
///
/// With e = b - a, p = c - a, q = d - a, A(r) = |e| (e x r) / |e x r|^2 (the rate at which r turns about e):
/// dtheta/dp = -A(p), dtheta/dq = A(q), dtheta/de = (p . e) / e^2 A(p) - (q . e) / e^2 A(q).
/// Degenerate: a triangle or an edge without extent has no normal; there the element has no force, energy or stiffness.
struct Dihedral {
  static constexpr int nodeCount = 4;
  using Positions = Eigen::Matrix<double, 3, 4>;
  using Vector = Eigen::Matrix<double, 12, 1>;
  using Matrix = Eigen::Matrix<double, 12, 12>;

  std::array<int, 4> nodes{};
  double k = 0.0;  ///< [J/rad^2]
  double theta0 = 0.0;

  double energy(const Positions& X) const;
  Vector gradient(const Positions& X) const;
  Matrix hessian(const Positions& X) const;
  Vector discreteGradient(const Positions& Xa, const Positions& Xb) const;
  bool constraint(const Positions& X, double& C, double& stiffness, Vector& dC) const;
};

extern template class ElementBatch<3, Dihedral>;

}  // namespace muelle::engine
