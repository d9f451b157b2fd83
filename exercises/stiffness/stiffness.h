#pragma once
/// \file
/// Exercise stiffness: the Hessian of a spring, its assembly into the sparse matrix of a whole net, and one step of
/// linearised backward Euler, which solves with that matrix. (Slides "Energía Elástica" and "Formulación
/// Multidimensional".)
///
/// One vector groups all positions: node i has the components 3i, 3i+1, 3i+2 of x, and so have velocities and forces.
///
/// SI units throughout: positions [m], velocities [m/s], masses [kg], stiffness k [N/m], rest length L0 [m], force [N],
/// Hessians [N/m], step h [s].
///
/// What holds for every function below:
///  - There are from 1 to 30 nodes and from 0 to 40 springs. A spring joins two different nodes; two springs may join
///    the same ones, and a node may have no spring at all.
///  - Stiffnesses are from 1e-3 to 1e9 N/m, rest lengths from 0 to 1000 m, masses from 1e-6 to 1e6 kg, steps from 0 to
///    10 s, a coordinate is at most 1000 m in size. Nothing else is passed, so nothing else needs a check.
///  - Signs: E is the energy, the sum of 1/2 k (L - L0)^2 with L = |xa - xb|. The force is minus its gradient, the
///    Hessian K is plus its matrix of second derivatives: the force changes by -K dx when the nodes move by dx.
///  - Where two nodes coincide (L = 0) their spring has no direction: it contributes no force, and its Hessian is taken
///    to be that of a spring without rest length, whose A is k times the identity. Never NaN. Other springs act as
///    usual.
///  - Every L > 0 has a direction, however small: down to 1e-100 m.
///  - Numbers are double, and derivatives are formulas: exact to round-off.

#include "harness/exercise.h"

#include <Eigen/SparseCore>

MUELLE_RANGE(k, 1e-3, 1e9)    // stiffness [N/m]
MUELLE_RANGE(L0, 0, 1000)     // rest length [m]
MUELLE_RANGE(springs, 0, 40)  // so many
MUELLE_RANGE(m, 1e-6, 1e6)    // mass [kg]
MUELLE_RANGE(h, 0, 10)        // step [s]

using muelle::Mat3;
using muelle::Vec3;
using muelle::VecX;
using Mat6 = Eigen::Matrix<double, 6, 6>;          ///< a matrix that acts on two nodes (a, b) stacked
using SparseMatrix = Eigen::SparseMatrix<double>;  ///< a matrix that stores only what is not zero

/// A spring of a net.
struct Spring {
  int a;      ///< the node at one end
  int b;      ///< the node at the other end
  double k;   ///< stiffness [N/m]
  double L0;  ///< rest length [m]
};
MUELLE_STRUCT(Spring, a, b, k, L0)

/// Where a net is, and how it moves.
struct State {
  VecX x;  ///< positions [m], three for each node
  VecX v;  ///< velocities [m/s], as many
};
MUELLE_STRUCT(State, x, v)

/// Hessian [N/m] of the energy of a spring in the order (xa, xb): its four blocks of 3 x 3 are A, -A, -A, A.
/// \param xa  position of node a [m]
/// \param xb  position of node b [m]
/// \param k   stiffness [N/m]
/// \param L0  rest length [m]
Mat6 springHessian(const Vec3& xa, const Vec3& xb, double k, double L0);

/// Hessian [N/m] of the energy of a net, 3n x 3n for n nodes: the sum over its springs. Nothing is stored but the 3 x 3
/// blocks of the nodes that have a spring, on the diagonal, and of the pairs that one joins, beside it; of a block's
/// entries those that are zero may be left out.
/// \param x        positions of the nodes, stacked [m]
/// \param springs  the springs
SparseMatrix assembleHessian(const VecX& x, const std::vector<Spring>& springs);

/// Force [N] of all springs on all nodes, stacked as x is: minus the gradient of the energy.
/// \param x        positions of the nodes, stacked [m]
/// \param springs  the springs
VecX elasticForce(const VecX& x, const std::vector<Spring>& springs);

/// The state after one step of linearised backward Euler:
///
///     (M + h^2 K) dv = h (F_total - h K v),   v1 = v + dv,   x1 = x + h v1,
///
/// with M the masses on the diagonal, K the Hessian at x, and F_total the force of the springs at x plus F. The matrix
/// is symmetric but not always positive definite, for compressed springs make K indefinite: the equation is solved as
/// it is. No step is passed whose matrix is singular, or nearly so.
/// \param now      the state at the beginning of the step
/// \param m        masses of the nodes [kg], one for each node
/// \param springs  the springs
/// \param F        other forces (gravity, ...), stacked as x is, constant over the step [N]
/// \param h        length of the step [s]
State backwardEulerStep(const State& now, const VecX& m, const std::vector<Spring>& springs, const VecX& F, double h);

MUELLE_FUNCTIONS(springHessian, assembleHessian, elasticForce, backwardEulerStep)
