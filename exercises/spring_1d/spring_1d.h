#pragma once
/// \file
/// Exercise spring_1d: a spring on a line. Implement these functions in spring_1d.cpp; README.md has the mathematics.
///
/// Units are SI. The axis x points up; a positive force or acceleration points up, a negative one down.
/// All arguments are finite numbers; masses and stiffnesses are positive, rest lengths and g are not negative. Between
/// which numbers each lies is stated below. Numbers are double, and answers exact to its round-off.

#include "harness/exercise.h"

MUELLE_RANGE(M, 1e-3, 1e6)     // kg
MUELLE_RANGE(n, 1, 1000)       // nodes
MUELLE_RANGE(x, -1000, 1000)   // m
MUELLE_RANGE(xa, -1000, 1000)  // m
MUELLE_RANGE(xb, -1000, 1000)  // m
MUELLE_RANGE(k, 1e-3, 1e9)     // N/m
MUELLE_RANGE(L0, 0, 1000)      // m
MUELLE_RANGE(m, 1e-6, 1e6)     // kg
MUELLE_RANGE(g, 0, 1000)       // m/s^2

/// A spring as seen from the node that it is attached to: where its other end is, and what it is made of.
struct Attachment {
  double x;   ///< position of the other end [m]
  double k;   ///< stiffness [N/m], positive
  double L0;  ///< rest length [m], not negative
};
MUELLE_STRUCT(Attachment, x, k, L0)

/// Mass [kg] of one node when an object of total mass M [kg] is shared out equally among n nodes (n >= 1).
double lumpedMass(double M, int n);

/// Elastic force [N] on node a of a spring between the nodes a and b.
///
/// Its length is L = |xa - xb|. Stretched (L > L0), the spring pulls a towards b; compressed (L < L0), it pushes a away
/// from b. Either node may be the upper one: when the nodes have crossed, the force follows their order now.
///
/// L = 0: the two nodes coincide and there is no direction; the force is 0, whatever L0. Every L > 0 has a direction,
/// however short (tests go down to 1e-100 m): the force then is not 0, unless L = L0.
///
/// \param xa position of node a [m]   \param xb position of node b [m]
/// \param k stiffness [N/m]           \param L0 rest length [m]
double springForceOnA(double xa, double xb, double k, double L0);

/// Elastic force [N] on node b of the same spring, with the same arguments in the same order.
double springForceOnB(double xa, double xb, double k, double L0);

/// Acceleration [m/s^2] of a node that hangs from one spring, under gravity.
///
/// The usual place of the node is below top.x, but nothing depends on it. On top.x exactly, the spring exerts no force.
///
/// \param x position of the node [m]   \param m its mass [kg]
/// \param top the spring that it hangs from
/// \param g size of the acceleration of gravity [m/s^2], not negative: gravity pulls towards -x
double hangingAcceleration(double x, double m, const Attachment& top, double g);

/// Acceleration [m/s^2] of a node between two springs, under gravity.
///
/// The usual place of the node is between lower.x and upper.x, but nothing depends on it. A spring whose other end is
/// exactly at x exerts no force.
///
/// \param x position of the node [m]   \param m its mass [kg]
/// \param lower the spring to the end below   \param upper the spring to the end above
/// \param g size of the acceleration of gravity [m/s^2], not negative: gravity pulls towards -x
double accelerationBetween(double x, double m, const Attachment& lower, const Attachment& upper, double g);

MUELLE_FUNCTIONS(lumpedMass, springForceOnA, springForceOnB, hangingAcceleration, accelerationBetween)
