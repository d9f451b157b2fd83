#pragma once
#include "engine/dynamical_system.h"
#include "engine/work.h"

#include <vector>

namespace muelle::engine {

/// A bound of the spectral radius [1/s] of the first-order form x' = v, v' = F/m, from a power iteration on each of
/// M^-1 K and M^-1 D by differences of forces.
///
/// With kappa and delta the largest eigenvalues, an eigenvalue lambda of the first-order form satisfies
/// lambda^2 + d lambda + k = 0 with |k| <= kappa, 0 <= d <= delta (Rayleigh quotients of its eigenvector; K and D
/// symmetric, D positive semidefinite), hence |lambda| <= (delta + sqrt(delta^2 + 4 kappa)) / 2: no iteration on the
/// first-order matrix, which has complex pairs and does not converge, is needed.
class SpectralBound {
 public:
  void prepare(const DynamicalSystem& system);
  /// Forgets how near the iteration was, keeping its vectors.
  void restart() { settled_ = false; }
  /// The bound, with a margin for an iteration that comes from below. acceleration: F/m at `state`. The first call
  /// iterates until two estimates agree within 2 %, later ones once every few calls.
  double update(const DynamicalSystem& system, const State& state, In acceleration, Work& work);
  /// The next update() iterates until it agrees, as the first.
  void doubt() { settled_ = false; }

 private:
  struct Iteration {
    std::vector<double> direction;  ///< of unit mass-weighted length
    double eigenvalue = 0.0;        ///< absolute, of the last iteration
  };
  /// One iteration; `ofVelocity`: on D instead of K. The relative change of the eigenvalue.
  double iterate(const DynamicalSystem& system, const State& state, In acceleration, bool ofVelocity, Work& work);

  static constexpr int callsBetween = 10;
  static constexpr int mostIterations = 60;
  Iteration stiffness_, damping_;
  std::vector<double> perturbed_, changed_;
  bool settled_ = false;
  int calls_ = 0;
};

}  // namespace muelle::engine
