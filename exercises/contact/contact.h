#pragma once
/// \file
/// Exercise `contact`: obstacles as forces on the nodes (slide "Contacto Externo", questions 1 and 2).
///
/// An obstacle pushes a node that is inside it back out, like a spring with a damper that cannot pull (a penalty
/// force). The depth is how far inside the node is; n is the outward unit normal; v_n = v . n is the speed at which the
/// node leaves. All numbers are in SI units; z points up.
///
/// All of this is computed with double, to the round-off of the numbers that it is made of. No number here is too small
/// to count: a depth may be 1e-30 m below a plane through the origin, a distance from a centre 1e-100 m, and a speed
/// along a surface whose normal is an axis 1e-100 m/s.
///
/// Not passed: a normal that is not of length 1, numbers outside the ranges below, and numbers that are not finite.

#include "harness/exercise.h"

using muelle::Vec3;

MUELLE_RANGE(k, 1e-3, 1e9)       // stiffness of an obstacle and of a spring [N/m]
MUELLE_RANGE(kPlane, 1e-3, 1e9)  // stiffness of the plane under a column [N/m]
MUELLE_RANGE(d, 0, 1e6)          // contact damping [N s/m]
MUELLE_RANGE(R, 1e-3, 1e3)       // radius of a sphere [m]
MUELLE_RANGE(m, 1, 40)           // how many nodes a column has; each mass is from 1e-3 to 1e3 kg
MUELLE_RANGE(L0, 0, 100)         // rest length of a column's springs [m]
MUELLE_RANGE(g, 0, 30)           // gravity [m/s^2]
MUELLE_RANGE(N, 0, 1e6)          // normal force [N]
MUELLE_RANGE(mu, 0, 10)          // friction coefficient
MUELLE_RANGE(c, 0, 1e6)          // slope of friction at rest [N s/m]

/// Contact of a node with a half-space of obstacle below the plane through p with normal n.
///
/// With depth = -(x - p) . n, the force is (k depth - d v_n) n while depth > 0, but never pulls the node in: where
/// k depth - d v_n is negative, the force is zero. It is zero with depth <= 0, whatever the velocity: outside and
/// exactly on the surface.
/// \param x, v position [m] and velocity [m/s] of the node
/// \param p a point of the plane [m]   \param n its unit normal, out of the obstacle
/// \param k contact stiffness [N/m], k > 0   \param d contact damping [N s/m], d >= 0
/// \return force on the node [N]
Vec3 planeContact(const Vec3& x, const Vec3& v, const Vec3& p, const Vec3& n, double k, double d);

/// Contact of a node with a solid sphere.
///
/// With depth = R - |x - c| and n from the centre to the node, the force is as for the plane: zero with depth <= 0, and
/// never pulling. At the very centre the force has no direction: it is zero. Any distance > 0 from the centre has one,
/// 1e-9 m included, and 1e-100 m.
/// \param x, v position [m] and velocity [m/s] of the node
/// \param c centre [m]   \param R radius [m], R > 0
/// \param k contact stiffness [N/m], k > 0   \param d contact damping [N s/m], d >= 0
/// \return force on the node [N]
Vec3 sphereContact(const Vec3& x, const Vec3& v, const Vec3& c, double R, double k, double d);

/// A column of nodes at rest on the plane z = 0: where is each node?
///
/// Node 0 is the lowest and the only one that touches the plane, which pushes it as planeContact does. A spring of
/// stiffness k and rest length L0 joins each node to the next one above. Gravity g pulls every node down. At rest the
/// forces on every node sum to zero. The column is so stiff that no spring is pressed to length zero; with L0 = 0 there
/// is one node, or no gravity.
/// \param m masses [kg], bottom first, at least one   \param k stiffness of each spring [N/m], k > 0
/// \param L0 rest length of each spring [m]   \param kPlane contact stiffness of the plane [N/m], kPlane > 0
/// \param g gravity [m/s^2], g >= 0
/// \return heights z of the nodes [m], bottom first, as many as masses
std::vector<double> columnAtRest(const std::vector<double>& m, double k, double L0, double kPlane, double g);

/// Optional: Coulomb friction of a node that an obstacle presses with normal force N.
///
/// With the tangential velocity v_t = v - (v . n) n, the force is -min(mu N, c |v_t|) v_t / |v_t|, and zero when v_t is
/// zero, whatever the other numbers.
/// \param v velocity of the node [m/s]   \param n unit normal of the surface   \param N normal force [N], N >= 0
/// \param mu friction coefficient, mu >= 0
/// \param c slope at rest [N s/m]: how fast the force grows with speed, c >= 0
/// \return force on the node [N]
Vec3 frictionForce(const Vec3& v, const Vec3& n, double N, double mu, double c);

MUELLE_FUNCTIONS(planeContact, sphereContact, columnAtRest, frictionForce)
