#pragma once
/// \file
/// Exercise spring_3d: springs in space. Implement these functions in spring_3d.cpp; README.md has the mathematics.
///
/// Units are SI. The axis z points up. All arguments are finite numbers; masses and stiffnesses are positive, rest
/// lengths and g are not negative. Between which numbers each lies is stated below; coordinates lie between -1000 m and
/// 1000 m. Numbers are double, and answers exact to its round-off.
///
/// The length of a spring between the nodes a and b is L = |xa - xb|. At L = 0 the two nodes coincide and the spring
/// has no direction: its direction and its force are zero vectors. Every L > 0 has a direction, however short (tests go
/// down to 1e-100 m).

#include "harness/exercise.h"

using muelle::Vec3;

MUELLE_RANGE(k, 1e-3, 1e9)    // N/m
MUELLE_RANGE(L0, 0, 1000)     // m
MUELLE_RANGE(m, 1e-6, 1e6)    // kg
MUELLE_RANGE(g, 0, 1000)      // m/s^2
MUELLE_RANGE(springs, 0, 40)  // so many of a node

/// A spring as seen from the node that it is attached to: where its other end is, and what it is made of.
struct Attachment {
  Vec3 x;     ///< position of the other end [m]
  double k;   ///< stiffness [N/m], positive
  double L0;  ///< rest length [m], not negative
};
MUELLE_STRUCT(Attachment, x, k, L0)

/// The lecture's "Magnitud", -k (L - L0) [N]: the force on a, counted along the direction from b to a. Negative when
/// the spring is stretched (it pulls a towards b), positive when it is compressed. At L = 0 the formula holds as it is.
///
/// \param xa position of node a [m]   \param xb position of node b [m]
/// \param k stiffness [N/m]           \param L0 rest length [m]
double springForceMagnitude(const Vec3& xa, const Vec3& xb, double k, double L0);

/// The lecture's "Dirección": the unit vector that points from b to a; the zero vector at L = 0.
Vec3 springDirection(const Vec3& xa, const Vec3& xb);

/// Elastic force [N] on node a of a spring between the nodes a and b: magnitude times direction.
///
/// \param xa position of node a [m]   \param xb position of node b [m]
/// \param k stiffness [N/m]           \param L0 rest length [m]
Vec3 springForce(const Vec3& xa, const Vec3& xb, double k, double L0);

/// Acceleration [m/s^2] of a node that hangs from any number of springs, under gravity: the slide "Todo junto".
///
/// \param x position of the node [m]   \param m its mass [kg]
/// \param springs the springs that it is attached to; with none, the node falls freely
/// \param g size of the acceleration of gravity [m/s^2], not negative: gravity pulls towards -z
Vec3 nodeAcceleration(const Vec3& x, double m, const std::vector<Attachment>& springs, double g);

MUELLE_FUNCTIONS(springForceMagnitude, springDirection, springForce, nodeAcceleration)
