#pragma once
/// \file
/// Exercise challenge: three scenes are simulated from start to end, and count by how exact the end is and how often
/// the force was asked. Which method, which steps: that is yours. (Slides "Receta para una Simulación".)
///
/// SI units throughout: times [s], positions [m], velocities [m/s], masses [kg], forces [N].
///
/// What holds for every function below:
///  - A scene has n nodes. Positions, velocities and forces are stacked, node i has the components 3i, 3i+1, 3i+2 (z
///    points up), and m has one mass for each of these 3n coordinates.
///  - The simulation begins at t = 0 with the positions x0 and the velocities v0. Returned are the positions [m] at the
///    end, in the same order.
///  - force(t, x, v) is the force on each coordinate. Everything that acts is in it: the statement's model, and a
///    draught of some per cent, which depends on the position alone and is known to nobody who does not ask. The
///    numbers of the model change a little from run to run as well.
///  - Every coordinate must be within the error of the scene. How often you may ask for that is counted in evaluations,
///    and each scene has three bands: the fewer, the more points. Whoever asks more often than the third allows is
///    stopped.
///  - The result follows from the arguments and the answers alone: nothing is kept from one call to the next.
///  - Numbers are double.
///
///                  error     best    good    enough
///     rabbit      1e-7 m      500    1200      3000
///     cloth       2e-4 m     1400    7000     12000    (asking the Hessian once counts 10)
///     ball        2e-3 m     1600   20000     40000

#include "harness/exercise.h"

#include <Eigen/SparseCore>

using muelle::VecX;

/// Force [N] on each coordinate at time t [s], positions x [m] and velocities v [m/s]: call it, force(t, x, v). One
/// evaluation.
using Force = std::function<VecX(double t, const VecX& x, const VecX& v)>;

/// Second derivatives of the energy [N/m] at time t [s] and positions x [m], which are minus the derivatives of the
/// force with respect to x: hessian(t, x). It is symmetric. Ten evaluations.
using Hessian = std::function<Eigen::SparseMatrix<double>(double t, const VecX& x)>;

constexpr double rabbitDuration = 0.1;  ///< [s]
constexpr double clothDuration = 0.4;   ///< [s]
constexpr double ballDuration = 3.0;    ///< [s]

/// A rabbit of 2054 nodes floats; two hands press it flat, softly, and let go again. Its force depends on the time and
/// on the positions, not on velocities.
/// \param force  the force on the coordinates [N]
/// \param m      mass of each coordinate [kg]
/// \param x0     positions at t = 0 [m]
/// \param v0     velocities at t = 0 [m/s]
/// \return positions at t = rabbitDuration [m]
VecX squeezedRabbit(const Force& force, const VecX& m, const VecX& x0, const VecX& v0);

/// A cloth of 100 nodes hangs by its upper side and swings; its threads hardly stretch. Its force depends on the
/// positions alone.
/// \param force    the force on the coordinates [N]
/// \param hessian  the second derivatives of the energy [N/m]
/// \param m        mass of each coordinate [kg]
/// \param x0       positions at t = 0 [m]
/// \param v0       velocities at t = 0 [m/s]
/// \return positions at t = clothDuration [m]
VecX stiffCloth(const Force& force, const Hessian& hessian, const VecX& m, const VecX& x0, const VecX& v0);

/// A ball, one node, is thrown and bounces on the ground z = 0 four times; the ground is hard, there is air, and
/// gravity is about 9.8 m/s^2. Its force depends on position and velocity.
/// \param force  the force on the coordinates [N]
/// \param m      mass of each coordinate [kg]
/// \param x0     position at t = 0 [m]
/// \param v0     velocity at t = 0 [m/s]
/// \return position at t = ballDuration [m]
VecX bouncingBall(const Force& force, const VecX& m, const VecX& x0, const VecX& v0);

MUELLE_FUNCTIONS(squeezedRabbit, stiffCloth, bouncingBall)
