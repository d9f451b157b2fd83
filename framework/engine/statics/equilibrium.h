#pragma once
#include "engine/dynamical_system.h"
#include "engine/work.h"

#include <string>
#include <vector>

namespace muelle::engine {

/// How an equilibrium is sought.
struct StaticOptions {
  int mostIterations = 1000;
  long long mostFactorisations = 1'000'000;
  double furthest = 0.0;  ///< [m] from the start: what goes further is held by nothing; 0: 1e8 times the nodes' extent
  /// Look at the curvature where the forces balance; otherwise the search ends there, and `converged` stays false.
  bool judge = true;
  bool leaveSaddles = true;  ///< go on along a direction of negative curvature where the forces balance on a saddle
  /// Curvature, relative to the largest entry of the stiffness matrix, that counts as zero: rigid motions and
  /// mechanisms have it.
  double flat = 1e-10;
};

/// An equilibrium, or how far the search came.
struct StaticResult {
  bool converged = false;             ///< the forces balance to round-off, and no direction lowers the energy
  bool balanced = false;              ///< the forces balance to round-off, be it on a saddle
  bool ranAway = false;               ///< some node went further than StaticOptions::furthest: nothing holds it
  State state;                        ///< with v = 0
  double energy = 0.0;                ///< potential energy [J]
  double residual = 0.0;              ///< largest sum of forces on a node [N]
  double roundOff = 0.0;              ///< what round-off of the positions alone does to the forces [N]
  std::vector<double> nodeResiduals;  ///< size of the sum of forces on each free node [N]
  double smallestEigenvalue = 0.0;    ///< of the stiffness matrix [N/m]; about 0: a mechanism or a rigid motion
  double unbalanced = 0.0;  ///< largest force without potential (friction) at rest, not part of the balance [N]
  int iterations = 0;
  int saddlesLeft = 0;
  Work work;
  std::string message;  ///< one line: what was found, or what went wrong
};

/// The equilibrium of a system at rest: a minimum of the total potential energy (elastic, gravity, contact) near
/// `start`. "They must sum to 0 at every node" (slide "Contacto Externo", question 2).
///
/// Newton's method with the exact Hessian. Where it is not positive definite (compressed springs, mechanisms, springs
/// at rest length that have no transverse stiffness) it is shifted until it is, more while steps do worse than
/// predicted, less while they do well (Levenberg-Marquardt; Nocedal, Wright: Numerical Optimization, ch. 4): each step
/// lowers the energy, and is at first at most a tenth of the scene's size, so that nodes rarely jump over each other.
/// At the end plain Newton steps go on until round-off. Where the forces balance but the Hessian has a negative
/// eigenvalue the search leaves along its eigenvector, so that no saddle is returned.
///
/// start.v is taken as 0; start.z may be empty (the system sets it, with live modes). Forces without potential are left
/// out; `unbalanced` says what friction would add.
///
/// Throws std::invalid_argument when the system has no potential or no linearisation, or when sizes do not fit.
StaticResult equilibrium(const DynamicalSystem& system, State start, const StaticOptions& options = {});

}  // namespace muelle::engine
