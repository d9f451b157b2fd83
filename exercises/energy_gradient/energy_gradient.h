#pragma once
/// \file
/// Exercise energy_gradient: the elastic energy of a spring, its gradient, and the force as the negative of that.
/// (Slides "Energía Elástica", "Fuerzas y Energías".)
///
/// One spring joins the nodes a and b. SI units throughout: positions [m], stiffness k [N/m], rest length L0 [m],
/// energy [J], forces and gradients of the energy [N].
///
/// What holds for every function below:
///  - k is from 1e-3 to 1e9 N/m, L0 from 0 to 1000 m, a coordinate at most 1000 m in size. Nothing else is passed, so
///    nothing else needs a check.
///  - Numbers are double, and derivatives are formulas: exact to round-off.
///  - Near rest the energy keeps its digits: where the spring is stretched by a millionth or a thousand-millionth of
///  its
///    length, too. Subtract the lengths before you square.
///  - L = |xa - xb| is a length: never negative, also where the nodes have crossed.
///  - Where L = 0 the spring has no direction: gradients and forces are zero there, never NaN. Its energy is not zero:
///    it is that of a spring compressed to nothing.
///  - Every L > 0 has a direction, however small: 1e-9 m has one, and so has 1e-100 m, the shortest that is passed.

#include "harness/exercise.h"

MUELLE_RANGE(k, 1e-3, 1e9)
MUELLE_RANGE(L0, 0, 1000)

using muelle::Vec2;
using muelle::Vec3;
using muelle::Vec6;

/// Elastic energy [J] of a spring in 1D, E: R^2 -> R.
/// \param x   coordinates of both nodes on the line, (xa, xb) [m], in either order along the line
/// \param k   stiffness [N/m]
/// \param L0  rest length [m]
double springEnergy1d(const Vec2& x, double k, double L0);

/// Elastic energy [J] of a spring in 3D, E: R^6 -> R.
/// \param x   positions of both nodes, stacked: components 0..2 are xa, components 3..5 are xb [m]
/// \param k   stiffness [N/m]
/// \param L0  rest length [m]
double springEnergy(const Vec6& x, double k, double L0);

/// Gradient of the length L = |xa - xb| with respect to the position of node a, dimensionless; zero where L = 0.
Vec3 lengthGradient(const Vec3& xa, const Vec3& xb);

/// Gradient [N] of springEnergy with respect to x, in R^6: components 0..2 are its derivatives with respect to xa,
/// components 3..5 those with respect to xb; zero where L = 0.
/// \param x   (xa, xb) stacked, as in springEnergy [m]
Vec6 energyGradient(const Vec6& x, double k, double L0);

/// Elastic forces [N] on both nodes, stacked as x is: components 0..2 act on a, components 3..5 on b; zero where L = 0.
/// A stretched spring pulls its nodes together.
/// \param x   (xa, xb) stacked, as in springEnergy [m]
Vec6 springForces(const Vec6& x, double k, double L0);

MUELLE_FUNCTIONS(springEnergy1d, springEnergy, lengthGradient, energyGradient, springForces)
