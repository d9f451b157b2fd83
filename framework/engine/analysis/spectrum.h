#pragma once
#include "engine/analysis/linearised_system.h"

#include <vector>

namespace muelle::engine {

/// A vibration of a linearised system: a Ritz pair of M y'' + D y' + K y = 0, as the three numbers by which it acts on
/// a method: its Rayleigh quotients over y* M y.
struct Mode {
  double stiffness = 0.0;  ///< y* K y, the squared angular frequency [1/s^2]; negative on a saddle
  double damping = 0.0;    ///< y* D y without the drag [1/s]
  double drag = 0.0;       ///< the drag's part of y* D y [1/s]
  int unknown = -1;        ///< where y is largest
  double energy = 0.0;     ///< share of the energy, where it is known

  double frequency() const;  ///< angular frequency [1/s], 0 on a saddle
  /// The rate at which the exact mode decays (negative: grows) [1/s]: of its slower part when overdamped.
  double decay() const;
  /// The larger of frequency() and the damping rates: 1/rate() is the mode's time scale [1/s].
  double rate() const;
};

/// Krylov subspaces, deterministic (one fixed seed), with full reorthogonalisation in the M-inner product.
/// \param dimension of the subspace: the extreme frequencies are then known to better than 1 %

/// Modes at the rim of the spectrum of the coupled first-order problem: of K alone, of D alone, and of both (Arnoldi on
/// [0 I; -K -D]). For small systems (2 size() <= dimension) all modes.
std::vector<Mode> extremeModes(const LinearisedSystem& system, int dimension = 40);

/// The modes of K in which `y` has its energy y* M y / 2, with their shares (Lanczos from y: the Gauss quadrature of
/// its spectral measure). Empty when y vanishes.
std::vector<Mode> modesOf(const LinearisedSystem& system, In y, int dimension = 24);

/// What they cost, in the worth of force evaluations: products, and what it takes to make bases orthogonal. Of large
/// systems: the dense eigenproblems, milliseconds, are not counted, nor is assembling the matrices (assemblyCost()).
double extremeModesCost(const LinearisedSystem& system, int dimension = 40);
double modesOfCost(const LinearisedSystem& system, int dimension = 24);
/// Of a LinearisedSystem itself.
double assemblyCost(const DynamicalSystem& system);

}  // namespace muelle::engine
