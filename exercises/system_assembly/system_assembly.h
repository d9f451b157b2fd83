#pragma once
/// \file
/// Exercise system_assembly: mass matrix, energy, gradient and accelerations of a system of n nodes and any springs
/// between them, in the multidimensional formulation M x'' = -grad E + F. (Slide "Formulación Multidimensional".)
///
/// One vector groups all positions, x in R^{3n}; node i has the components 3i, 3i+1, 3i+2. So has every other vector of
/// the system: gradients, forces, accelerations.
///
/// What one spring does is not the assembly's business: its energy and its gradient are functions that are given to
/// yours. They may be those of Hooke's law, or others.
///
/// SI units throughout: positions [m], masses [kg], energies [J], gradients and forces [N], accelerations [m/s^2].
///
/// What holds for every function below:
///  - x has 3n numbers and m has n, for 1 to 200 nodes. There are 0 to 600 springs; several may join the same two
///  nodes,
///    and a node may have any number of them, or none.
///  - A spring joins two different nodes, a and b, from 0 to n - 1; either may be the larger. Its k and L0 are handed
///    on: k is from 1e-3 to 1e9 N/m, L0 from 0 to 1000 m. Masses are from 1e-6 to 1e6 kg. Nothing else is passed, so
///    nothing else needs a check.
///  - The function of a spring is asked once for each spring. What it answers has no need to be symmetric: xa is where
///    node a is, xb where node b is.
///  - The result follows from the arguments alone. Numbers are double, and sums are exact to its round-off, however
///    small they are.

#include "harness/exercise.h"

#include <Eigen/SparseCore>

MUELLE_RANGE(springs, 0, 600)  // number of springs
MUELLE_RANGE(k, 1e-3, 1e9)     // stiffness [N/m]
MUELLE_RANGE(L0, 0, 1000)      // rest length [m]
MUELLE_RANGE(m, 1e-6, 1e6)     // masses [kg]

using muelle::Vec3;
using muelle::Vec6;
using muelle::VecX;
using SparseMatrix = Eigen::SparseMatrix<double>;  ///< stores the entries that have been written, and no other

/// A spring between two nodes.
struct Spring {
  int a = 0;        ///< number of its first node
  int b = 1;        ///< number of its second node
  double k = 1.0;   ///< stiffness [N/m]
  double L0 = 1.0;  ///< rest length [m]
};
MUELLE_STRUCT(Spring, a, b, k, L0)

/// Energy [J] of one spring between its first node at xa and its second at xb [m]: call it, energy(xa, xb, k, L0).
using SpringEnergy = std::function<double(const Vec3& xa, const Vec3& xb, double k, double L0)>;

/// Gradient [N] of the energy of one spring: its derivatives with respect to the three components of xa, then to those
/// of xb.
using SpringGradient = std::function<Vec6(const Vec3& xa, const Vec3& xb, double k, double L0)>;

/// Mass matrix M [kg], 3n x 3n, of M a = F. It stores 3n entries.
/// \param m  masses of the nodes [kg]
SparseMatrix systemMassMatrix(const VecX& m);

/// Elastic energy [J] of the system: the sum over its springs, 0 without springs.
/// \param x        positions of all nodes, stacked [m]
/// \param springs  the springs
/// \param energy   the energy [J] of one spring; asked once for each
double systemEnergy(const VecX& x, const std::vector<Spring>& springs, const SpringEnergy& energy);

/// Gradient [N] of systemEnergy with respect to x, stacked as x is.
/// \param x         positions of all nodes, stacked [m]
/// \param springs   the springs
/// \param gradient  the gradient [N] of one spring; asked once for each
VecX systemGradient(const VecX& x, const std::vector<Spring>& springs, const SpringGradient& gradient);

/// Accelerations [m/s^2] of all nodes, stacked as x is, from M a = -grad E + F.
/// \param x         positions of all nodes, stacked [m]
/// \param m         masses of the nodes [kg]
/// \param springs   the springs
/// \param gradient  the gradient [N] of one spring; asked once for each
/// \param F         the other forces on all nodes, gravity and so on, stacked as x is [N]
VecX systemAccelerations(const VecX& x, const VecX& m, const std::vector<Spring>& springs,
                         const SpringGradient& gradient, const VecX& F);

MUELLE_FUNCTIONS(systemMassMatrix, systemEnergy, systemGradient, systemAccelerations)
