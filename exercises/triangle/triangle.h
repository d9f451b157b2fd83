#pragma once
/// \file
/// Exercise triangle: mass matrix, elastic energy and elastic force of three nodes joined by three springs, in the
/// multidimensional formulation M a = -grad E + F. (Slide "Formulación Multidimensional".)
///
/// One vector groups all positions: x = (x0, x1, x2) in R^9; node i has the components 3i, 3i+1, 3i+2.
/// The springs come in this order, and so do their stiffnesses k and their rest lengths L0:
///
///     spring 0 joins nodes 0 and 1,   spring 1 joins nodes 1 and 2,   spring 2 joins nodes 2 and 0.
///
/// SI units throughout: positions [m], masses [kg], stiffness [N/m], rest length [m], energy [J], force [N].
///
/// What holds for every function below:
///  - masses are from 1e-6 to 1e6 kg, stiffnesses from 1e-3 to 1e9 N/m, rest lengths from 0 to 1000 m, a
///    coordinate is at most 1000 m in size. Nothing else is passed, so nothing else needs a check.
///  - Numbers are double, and derivatives are formulas: exact to round-off.
///  - Near rest the energy keeps its digits: where a spring is stretched by a millionth or a thousand-millionth of its
///    length, too. Subtract the lengths before you square.
///  - Where two nodes coincide their spring (L = 0) has no direction: it contributes no force, never NaN, and the two
///    other springs act as usual. Its energy is not zero: it is that of a spring compressed to nothing.
///  - Every L > 0 has a direction, however small: 1e-9 m has one, and so has 1e-100 m, the shortest that is passed.

#include "harness/exercise.h"

MUELLE_RANGE(m, 1e-6, 1e6)
MUELLE_RANGE(k, 1e-3, 1e9)
MUELLE_RANGE(L0, 0, 1000)

using muelle::Mat3;
using muelle::Vec3;
using muelle::Vec9;
using Mat9 = Eigen::Matrix<double, 9, 9>;  ///< a matrix that acts on the stacked nodes

/// Mass matrix M [kg], 9 x 9, of M a = F with a and F stacked as x is.
/// \param m  masses of the nodes 0, 1, 2 [kg]; they may differ
Mat9 massMatrix(const Vec3& m);

/// Elastic energy [J] of the triangle: the sum over its springs, E: R^9 -> R.
/// \param x   (x0, x1, x2) stacked [m]
/// \param k   stiffnesses of the springs 01, 12, 20 [N/m]
/// \param L0  rest lengths of the springs 01, 12, 20 [m]
double triangleEnergy(const Vec9& x, const Vec3& k, const Vec3& L0);

/// Elastic force [N] on all nodes, stacked as x is: minus the gradient of triangleEnergy with respect to x.
/// \param x   (x0, x1, x2) stacked [m]
/// \param k   stiffnesses of the springs 01, 12, 20 [N/m]
/// \param L0  rest lengths of the springs 01, 12, 20 [m]
Vec9 triangleForce(const Vec9& x, const Vec3& k, const Vec3& L0);

MUELLE_FUNCTIONS(massMatrix, triangleEnergy, triangleForce)
