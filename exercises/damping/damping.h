#pragma once
/// \file
/// Exercise `damping`: three ways to damp a spring (slide "Amortiguamiento").
///
/// A spring joins node a to node b. Each function returns a damping force in newtons: the one on node a. The force on
/// node b is what the same function gives with the two nodes exchanged.
///
/// All of this is computed with double, to round-off. No number here is too small to count: a speed may be 1e-100 m/s
/// and a spring 1e-100 m long.
///
/// Not passed: numbers outside the range below, and numbers that are not finite.

#include "harness/exercise.h"

using muelle::Vec3;

MUELLE_RANGE(d, 0, 1e6)  // damping coefficient [N s/m]

/// Damping of a node: it opposes the node's own velocity.
/// \param va velocity of the node [m/s]
/// \param d damping coefficient [N s/m], d >= 0
/// \return force on the node [N]
Vec3 nodeDamping(const Vec3& va, double d);

/// Damping of a spring by the relative velocity of its ends.
/// \param va, vb velocities of the ends [m/s]
/// \param d damping coefficient [N s/m], d >= 0
/// \return force on a [N]
Vec3 relativeDamping(const Vec3& va, const Vec3& vb, double d);

/// Damping of a spring by the relative velocity projected on the spring: only the rate at which its length changes.
/// \param xa, xb positions of the ends [m]
/// \param va, vb velocities of the ends [m/s]
/// \param d damping coefficient [N s/m], d >= 0
/// \return force on a [N]. With L = |xa - xb| = 0 the spring has no direction: the force is zero. Any L > 0 has one,
///         1e-9 m included, and 1e-100 m.
Vec3 projectedDamping(const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d);

MUELLE_FUNCTIONS(nodeDamping, relativeDamping, projectedDamping)
