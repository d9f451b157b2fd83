#pragma once
#include "engine/elements/element_batch.h"

namespace muelle::engine {

/// Bending at b between the edges u = b - a and w = c - b: E = k (theta - theta0)^2 / 2.
///
/// 2D: theta in (-pi, pi] is signed, positive when the line turns anticlockwise at b; smooth wherever both edges have a
/// length and the line does not fold back on itself.
/// 3D: theta in [0, pi] has no sign. With theta0 = 0 the energy is smooth at straight; with another rest angle a
/// straight line does not know which way to bend: it has a force of size k theta0 / L but of no direction, and is left
/// without any, as is a line that is folded back (theta = pi).
/// Degenerate: an edge without length has no direction: no energy, force or stiffness.
template <int D>
struct Angle {
  static constexpr int nodeCount = 3;
  using Positions = Eigen::Matrix<double, D, 3>;
  using Vector = Eigen::Matrix<double, 3 * D, 1>;
  using Matrix = Eigen::Matrix<double, 3 * D, 3 * D>;

  std::array<int, 3> nodes{};
  double k = 0.0;  ///< [J/rad^2]
  double theta0 = 0.0;

  double energy(const Positions& X) const;
  Vector gradient(const Positions& X) const;
  Matrix hessian(const Positions& X) const;
  Vector discreteGradient(const Positions& Xa, const Positions& Xb) const;
  bool constraint(const Positions& X, double& C, double& stiffness, Vector& dC) const;
};

extern template class ElementBatch<2, Angle<2>>;
extern template class ElementBatch<3, Angle<3>>;

}  // namespace muelle::engine
