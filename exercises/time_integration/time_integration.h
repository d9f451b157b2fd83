#pragma once
/// \file
/// Exercise time_integration: one step of four methods that solve m a = F(t, x, v) in time. The force is a function
/// that is given to the method, which asks it. (Slide "Receta para una Simulación": discretizar las ecuaciones,
/// integración de ODEs.)
///
/// SI units throughout: times and steps [s], positions [m], velocities [m/s], masses [kg], forces [N].
///
/// What holds for every function below:
///  - x, v, m and what the force returns have one number for each of n coordinates, n from 1 to 30: a node in space has
///    three of them, with the same mass. The force on one coordinate may depend on all of them.
///  - now is the state at the beginning of the step and stays as it is. What is returned is the state at its end: x, v,
///    and t = now.t + h.
///  - Masses are from 1e-6 to 1e6 kg, times at the beginning of a step from 0 to 1000 s, steps from 0 to 10 s. Nothing
///    else is passed, so nothing else needs a check.
///  - Asking for the force is what a simulation spends its time with: each function says how often it asks, and never
///    asks more often. The same question always has the same answer.
///  - Nothing is kept from one step to the next: the result follows from the arguments alone.
///  - Numbers are double.

#include "harness/exercise.h"

MUELLE_RANGE(h, 0, 10)
MUELLE_RANGE(t, 0, 1000)

using muelle::VecX;

/// Where a system of n coordinates is.
struct State {
  double t = 0.0;  ///< time [s]
  VecX x;          ///< positions [m]
  VecX v;          ///< velocities [m/s], as many as positions
};
MUELLE_STRUCT(State, t, x, v)

/// Force [N] on each coordinate at time t [s], positions x [m] and velocities v [m/s]: call it, force(t, x, v).
using Force = std::function<VecX(double t, const VecX& x, const VecX& v)>;

/// A force that does not depend on velocities, as those of springs and gravity: force(t, x).
using PositionForce = std::function<VecX(double t, const VecX& x)>;

/// One step of explicit Euler. Asks for the force once.
/// \param force  the force on the coordinates [N]
/// \param m      mass of each coordinate [kg]
/// \param now    the state at the beginning of the step
/// \param h      length of the step [s]
State explicitEulerStep(const Force& force, const VecX& m, const State& now, double h);

/// One step of the explicit midpoint method. Asks for the force twice.
/// \param force  the force on the coordinates [N]
/// \param m      mass of each coordinate [kg]
/// \param now    the state at the beginning of the step
/// \param h      length of the step [s]
State midpointStep(const Force& force, const VecX& m, const State& now, double h);

/// One step of velocity Verlet. Asks for the force twice: at the beginning and at the end of the step.
/// \param force  the force on the coordinates [N], without velocities
/// \param m      mass of each coordinate [kg]
/// \param now    the state at the beginning of the step
/// \param h      length of the step [s]
State verletStep(const PositionForce& force, const VecX& m, const State& now, double h);

/// One step of the classical Runge-Kutta method of fourth order. Asks for the force four times.
/// \param force  the force on the coordinates [N]
/// \param m      mass of each coordinate [kg]
/// \param now    the state at the beginning of the step
/// \param h      length of the step [s]
State rungeKuttaStep(const Force& force, const VecX& m, const State& now, double h);

MUELLE_FUNCTIONS(explicitEulerStep, midpointStep, verletStep, rungeKuttaStep)
