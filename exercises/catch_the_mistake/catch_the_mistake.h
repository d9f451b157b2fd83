#pragma once
/// \file
/// Exercise catch_the_mistake: you write the tests. Each function below is given somebody's implementation of a
/// function of an earlier exercise, asks it what it likes, and says whether it is right.
///
/// What holds for every function below:
///  - It returns true for a right implementation and false for a wrong one.
///  - It asks at most 500 questions of one implementation (those to an energy and to its gradient count together). The
///    grader counts them, and a function that asks more earns nothing; check does not count.
///  - Right is what the contract of that exercise says, for all that may be asked here. A right implementation is exact
///    to round-off, however it is written: each component is within 1e-9 of the numbers involved, k (L + L0) [N] for a
///    force and a gradient, k (L + L0)^2 [J] for an energy, d (|va| + |vb|) [N] for a damping force; where the contract
///    says zero it is exactly 0. A wrong one is off by more than a hundredth of these numbers, or is no number, at some
///    questions: of one mistake at nearly all, of another only where nodes coincide.
///  - An implementation may throw an exception (std::runtime_error). One that throws is wrong: catch it and return
///    false. An exception that leaves your function is no verdict.
///  - The same question always has the same answer, and no implementation crashes or runs without end.
///
/// SI units throughout: positions [m], velocities [m/s], stiffness k [N/m], rest lengths L0 [m], damping coefficients d
/// [N s/m], forces and gradients [N], energies [J]. What may be asked:
///  - coordinates of positions from -1000 to 1000 m, of velocities from -1000 to 1000 m/s,
///  - k from 1e-3 to 1e9 N/m, L0 from 0 to 1000 m, d from 0 to 1e6 N s/m,
///  - nodes that coincide, and nodes that do not: then the length is 1e-100 m at least, but for round-off.

#include "harness/exercise.h"

using muelle::Vec3;
using muelle::Vec6;

/// An implementation of springForceOnA of the exercise spring_1d: the force [N] on node a of a spring on a line, 0
/// where the nodes coincide.
using SpringForce = std::function<double(double xa, double xb, double k, double L0)>;

/// An implementation of springEnergy of the exercise energy_gradient: the energy [J] of a spring in space; x holds xa
/// in its components 0 to 2 and xb in 3 to 5.
using SpringEnergy = std::function<double(const Vec6& x, double k, double L0)>;

/// An implementation of energyGradient of the exercise energy_gradient: the gradient [N] of that energy with respect to
/// x, zero where the nodes coincide.
using EnergyGradient = std::function<Vec6(const Vec6& x, double k, double L0)>;

/// An implementation of projectedDamping of the exercise damping: the force [N] on node a by the relative velocity
/// projected on the spring, zero where the nodes coincide.
using ProjectedDamping = std::function<Vec3(const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d)>;

/// Whether an implementation of springForceOnA is right. Call it: springForceOnA(xa, xb, k, L0).
/// \param springForceOnA  the implementation that is judged: a force [N]
bool isSpringForceRight(const SpringForce& springForceOnA);

/// Whether an energy and its gradient are both right. One of them may be wrong, or both, and both may be wrong in such
/// a way that the one is still the derivative of the other.
/// \param springEnergy    the first half of what is judged: an energy [J]
/// \param energyGradient  the second half: its gradient [N]
bool isGradientRight(const SpringEnergy& springEnergy, const EnergyGradient& energyGradient);

/// Whether an implementation of projectedDamping is right. Call it: projectedDamping(xa, xb, va, vb, d).
/// \param projectedDamping  the implementation that is judged: a force [N]
bool isDampingRight(const ProjectedDamping& projectedDamping);

MUELLE_FUNCTIONS(isSpringForceRight, isGradientRight, isDampingRight)
