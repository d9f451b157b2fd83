#pragma once
/// \file
/// The vectors and matrices of the course: Eigen types under the lecture's names, in double precision.

#include "harness/eigen_assertion.h"

#ifdef EIGEN_INITIALIZE_MATRICES_BY_NAN  // what a student's file is compiled with
#define EIGEN_DENSEBASE_PLUGIN "harness/eigen_fill.h"
#define EIGEN_ARRAY_PLUGIN "harness/eigen_fill.h"
#endif

#include <Eigen/Core>

namespace muelle {

using Vec2 = Eigen::Vector2d;              ///< a point or a force in the plane
using Vec3 = Eigen::Vector3d;              ///< a point [m], velocity [m/s] or force [N]; z points up
using VecX = Eigen::VectorXd;              ///< a vector of run-time length, such as the 3n positions of n nodes
using Mat2 = Eigen::Matrix2d;              ///< a 2 x 2 matrix
using Mat3 = Eigen::Matrix3d;              ///< a 3 x 3 matrix
using MatX = Eigen::MatrixXd;              ///< a matrix of run-time size
using Vec6 = Eigen::Matrix<double, 6, 1>;  ///< two nodes in 3D: (xa, xb)
using Vec9 = Eigen::Matrix<double, 9, 1>;  ///< three nodes in 3D: (x0, x1, x2)

}  // namespace muelle
