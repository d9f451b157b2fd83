#pragma once
#include <Eigen/Core>

namespace muelle::engine {

/// [r]x, the matrix of the cross product: [r]x p = r x p.
inline Eigen::Matrix3d crossMatrix(const Eigen::Vector3d& r) {
  Eigen::Matrix3d C;
  C << 0.0, -r[2], r[1], r[2], 0.0, -r[0], -r[1], r[0], 0.0;
  return C;
}

/// Hessian in the positions of nodes 0 .. E from the one in the edges node i - node 0, i = 1 .. E: node 0 has minus the
/// sums, so that a translation does nothing.
template <int E>
inline Eigen::Matrix<double, 3 * (E + 1), 3 * (E + 1)> fromEdges(const Eigen::Matrix<double, 3 * E, 3 * E>& edges) {
  Eigen::Matrix<double, 3 * (E + 1), 3 * (E + 1)> H;
  H.setZero();
  H.template bottomRightCorner<3 * E, 3 * E>() = edges;
  for (int i = 0; i < E; ++i) H.template block<3, 3 * E>(0, 3) -= edges.template middleRows<3>(3 * i);
  for (int i = 0; i < E; ++i) {
    H.template block<3 * (E + 1), 3>(0, 0) -= H.template block<3 * (E + 1), 3>(0, 3 * (i + 1));
  }
  return H;
}

}  // namespace muelle::engine
