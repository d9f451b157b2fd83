#pragma once
/// \file
/// Exercise generalised_springs: springs that resist bending, a change of area and a change of volume: energies of
/// three or four nodes, and their forces. (Slide "Aplicaciones (Muelles con Extensiones o Generalizados)".)
///
/// The nodes are stacked: x = (x0, x1, x2) in R^9 or (x0, x1, x2, x3) in R^12; node i has the components 3i, 3i+1,
/// 3i+2. Forces are stacked in the same way.
///
/// SI units throughout: positions [m], angles [rad], areas [m^2], volumes [m^3], energies [J], forces [N]. Each kind
/// has a stiffness of its own unit: kb [J/rad^2] of bending, kA [N/m^3] of area, kV [N/m^5] of volume.
///
/// What holds for every function below:
///  - Stiffnesses are from 1e-3 to 1e9, rest angles theta0 from 0 to 3.14159 rad, rest areas A0 from 0 to 1000 m^2,
///    rest volumes V0 from -1000 to 1000 m^3; a coordinate is at most 100 m in size. Nothing else is passed, so nothing
///    else needs a check.
///  - Numbers are double, and derivatives are formulas: exact to round-off. That holds for angles near 0 and near pi,
///    too, where an arc cosine has lost half of its digits: use std::atan2.
///  - Three nodes on one line have no plane: the angle (0, or pi where the line folds back) and the area (0) have no
///    gradient there, and the force is zero, never NaN. The energy is as usual. Nodes on one line are passed so that
///    they are on it exactly: the cross product of any two sides is zero in double, too.
///  - Where two successive nodes of a bending spring coincide there is no angle either: energy and force are zero.
///  - Every other triangle has a plane, however narrow or small it is: sides down to 1e-30 m, angles down to 1e-30 rad.
///  - A volume has a sign, and its gradient is never without direction: nothing is special at V = 0.

#include "harness/exercise.h"

MUELLE_RANGE(kb, 1e-3, 1e9)
MUELLE_RANGE(kA, 1e-3, 1e9)
MUELLE_RANGE(kV, 1e-3, 1e9)
MUELLE_RANGE(theta0, 0, 3.14159)
MUELLE_RANGE(A0, 0, 1000)
MUELLE_RANGE(V0, -1000, 1000)

using muelle::Vec3;
using muelle::Vec9;
using Vec12 = Eigen::Matrix<double, 12, 1>;  ///< four nodes in 3D: (x0, x1, x2, x3)

/// Angle [rad] by which the line of three nodes bends at x1: between the segments x1 - x0 and x2 - x1. 0 where it goes
/// straight on, pi where it folds back; never negative. Where a segment has no length nobody asks for an angle.
/// \param x  (x0, x1, x2) stacked [m]
double bendingAngle(const Vec9& x);

/// Energy [J] of a bending spring: 1/2 kb (angle - theta0)^2; 0 where a segment has no length.
/// \param x       (x0, x1, x2) stacked [m]
/// \param theta0  angle at rest [rad]
/// \param kb      stiffness [J/rad^2]
double bendingEnergy(const Vec9& x, double theta0, double kb);

/// Forces [N] of a bending spring on its three nodes, stacked as x is: minus the gradient of bendingEnergy; zero where
/// the nodes lie on one line.
/// \param x       (x0, x1, x2) stacked [m]
/// \param theta0  angle at rest [rad]
/// \param kb      stiffness [J/rad^2]
Vec9 bendingForce(const Vec9& x, double theta0, double kb);

/// Area [m^2] of the triangle x0, x1, x2: never negative.
/// \param x  (x0, x1, x2) stacked [m]
double triangleArea(const Vec9& x);

/// Energy [J] of an area spring: 1/2 kA (area - A0)^2.
/// \param x   (x0, x1, x2) stacked [m]
/// \param A0  area at rest [m^2]
/// \param kA  stiffness [N/m^3]
double areaEnergy(const Vec9& x, double A0, double kA);

/// Forces [N] of an area spring on its three nodes, stacked as x is: minus the gradient of areaEnergy; zero where the
/// nodes lie on one line.
/// \param x   (x0, x1, x2) stacked [m]
/// \param A0  area at rest [m^2]
/// \param kA  stiffness [N/m^3]
Vec9 areaForce(const Vec9& x, double A0, double kA);

/// Signed volume [m^3] of the tetrahedron x0, x1, x2, x3: positive where x1 - x0, x2 - x0, x3 - x0 are turned as the
/// axes x, y, z are, negative where it is inverted.
/// \param x  (x0, x1, x2, x3) stacked [m]
double tetrahedronVolume(const Vec12& x);

/// Energy [J] of a volume spring: 1/2 kV (volume - V0)^2.
/// \param x   (x0, x1, x2, x3) stacked [m]
/// \param V0  volume at rest [m^3]
/// \param kV  stiffness [N/m^5]
double volumeEnergy(const Vec12& x, double V0, double kV);

/// Forces [N] of a volume spring on its four nodes, stacked as x is: minus the gradient of volumeEnergy.
/// \param x   (x0, x1, x2, x3) stacked [m]
/// \param V0  volume at rest [m^3]
/// \param kV  stiffness [N/m^5]
Vec12 volumeForce(const Vec12& x, double V0, double kV);

MUELLE_FUNCTIONS(bendingAngle, bendingEnergy, bendingForce, triangleArea, areaEnergy, areaForce, tetrahedronVolume,
                 volumeEnergy, volumeForce)
