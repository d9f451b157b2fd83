#pragma once
/// \file
/// Exercise property_forces: forces that lead a simulation towards a property, such as "the mean height of the class is
/// 2 m". (Slide "Fuerzas y Energías".)
///
/// One vector groups the positions of all n nodes: x = (x0, x1, ...) in R^{3n}; node i has the components 3i, 3i+1,
/// 3i+2, the last of which is its height (z points up). Forces and gradients are stacked in the same way. The masses
/// of the nodes are m in R^n, one a node.
///
/// SI units throughout: positions, heights and spreads [m], masses [kg], stiffness k [N/m], energies [J], forces [N].
///
/// What holds for every function below:
///  - There are 1 to 40 nodes, masses are from 1e-6 to 1e6 kg, stiffnesses from 1e-3 to 1e9 N/m, target heights h0 from
///    -1000 to 1000 m, target spreads R0 from 0 to 1000 m; a coordinate is at most 1000 m in size. Nothing else is
///    passed, so nothing else needs a check.
///  - Numbers are double, and derivatives are formulas: exact to round-off.
///  - Where all nodes are at one point (also: where there is one node) the spread is 0 and has no gradient: gradient
///    and force are zero there, never NaN. The energy is not zero: it is that of a class squeezed to nothing. Such
///    nodes are at points like (0.5, -1.25, 2), with masses like 2 or 0.25 kg that add up to a power of two: every way
///    to compute their centre is exact.
///  - Every spread above zero has a gradient, however small: 1e-9 m has one, and so has 1e-100 m, the smallest.

#include "harness/exercise.h"

MUELLE_RANGE(m, 1e-6, 1e6)
MUELLE_RANGE(k, 1e-3, 1e9)
MUELLE_RANGE(h0, -1000, 1000)
MUELLE_RANGE(R0, 0, 1000)

using muelle::Vec3;
using muelle::VecX;

/// Mean height [m] of the nodes: the sum of their heights over their number. The masses have no part in it.
/// \param x  positions, stacked [m]
double meanHeight(const VecX& x);

/// Energy [J] of the property "the mean height is h0": 1/2 k (mean height - h0)^2.
/// \param x   positions, stacked [m]
/// \param h0  target of the mean height [m]
/// \param k   stiffness of the property [N/m]
double meanHeightEnergy(const VecX& x, double h0, double k);

/// Force [N] on all nodes, stacked as x is: minus the gradient of meanHeightEnergy with respect to x.
/// \param x   positions, stacked [m]
/// \param h0  target of the mean height [m]
/// \param k   stiffness of the property [N/m]
VecX meanHeightForce(const VecX& x, double h0, double k);

/// Spread R [m] of the nodes about their centre of mass c: the root of the mean of the squared distances |xi - c|^2,
/// each node counted by its mass (physicists call it the radius of gyration).
/// \param x  positions, stacked [m]
/// \param m  masses of the nodes [kg]
double spread(const VecX& x, const VecX& m);

/// Gradient of the spread with respect to x, stacked as x is, dimensionless; zero where the spread is 0.
/// \param x  positions, stacked [m]
/// \param m  masses of the nodes [kg]
VecX spreadGradient(const VecX& x, const VecX& m);

/// Energy [J] of the property "the spread is R0": 1/2 k (spread - R0)^2.
/// \param x   positions, stacked [m]
/// \param m   masses of the nodes [kg]
/// \param R0  target of the spread [m]
/// \param k   stiffness of the property [N/m]
double spreadEnergy(const VecX& x, const VecX& m, double R0, double k);

/// Force [N] on all nodes, stacked as x is: minus the gradient of spreadEnergy with respect to x; zero where the spread
/// is 0.
/// \param x   positions, stacked [m]
/// \param m   masses of the nodes [kg]
/// \param R0  target of the spread [m]
/// \param k   stiffness of the property [N/m]
VecX spreadForce(const VecX& x, const VecX& m, double R0, double k);

MUELLE_FUNCTIONS(meanHeight, meanHeightEnergy, meanHeightForce, spread, spreadGradient, spreadEnergy, spreadForce)
