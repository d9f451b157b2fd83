#pragma once
#include <string>
#include <vector>

namespace muelle::engine {

/// What a system must have for a method to run on it.
struct Needs {
  bool potential = false;            ///< an energy from which all forces derive
  bool linearisation = false;        ///< derivatives of the force
  bool constraints = false;          ///< the elastic energies as constraints
  bool distanceConstraints = false;  ///< constraints, all of them distances
  bool velocityFreeForce = false;    ///< a force that does not depend on the velocity
  bool dragAside = false;            ///< but for a linear drag of each unknown alone (Drag), which may act
};

/// How a method behaves under a step that is too large for a mode.
enum class Stability {
  Never,    ///< unstable on an undamped oscillator for every step
  Limited,  ///< stable up to a limit of h omega and of h d / m
  AStable,  ///< stable for every step
  LStable,  ///< stable for every step, and fast modes die at once
};

/// What is known about a method: the one source of its documentation, of the adviser and of the predictions for the
/// hard cases.
struct MethodInfo {
  std::string id;    ///< "velocity_verlet": as scenes and the command line name it
  std::string name;  ///< "velocity Verlet"
  int order = 1;     ///< in positions and velocities, on smooth problems
  int stages = 1;    ///< force evaluations a step of an explicit method; 0 for an implicit one
  bool implicit = false;
  bool adaptive = false;  ///< has an error estimate
  bool symplectic = false;
  bool reversible = false;         ///< a step back undoes a step
  bool conservesEnergy = false;    ///< to round-off, on conservative systems
  bool conservesMomentum = false;  ///< linear momentum, to round-off
  bool conservesAngularMomentum = false;
  bool iterative = false;  ///< stops iterating before it converges (XPBD, projective dynamics): an error of its own
  bool processed = false;  ///< another map runs inside, whose limit is the one stated: what comes out does not tell it
  bool holdsRods = false;  ///< keeps the length of rods (DynamicalSystem::rods)
  Stability stability = Stability::Limited;
  double imaginaryLimit = 0.0;  ///< largest h omega on an undamped oscillator; infinite when A-stable
  double realLimit = 0.0;       ///< largest h lambda on x' = -lambda x; infinite when A-stable
  Needs needs;
  std::string formula;  ///< one line, in the notation of the lecture
  std::string source;   ///< paper or book
  std::string remark;   ///< when to use it, and what it gets wrong
};

}  // namespace muelle::engine
