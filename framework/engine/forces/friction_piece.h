#pragma once
#include "engine/forces/configuration.h"

namespace muelle::engine {

/// What a force batch with friction offers beyond its switching: an anchor at rest takes what all other forces ask.
class FrictionPiece {
 public:
  virtual ~FrictionPiece() = default;

  /// Whether balance() is due, after SwitchingPiece::commit() or cross().
  virtual bool wantsBalance() const = 0;
  /// Second part of a commit: `f` is the force on all nodes without friction. True when the force may have changed.
  virtual bool balance(const Configuration& at, const double* f, double* z) const = 0;
  /// Adds the batch's force without its friction.
  virtual void addForceWithoutFriction(const Configuration& at, double* f) const = 0;
  /// Energy [J] that friction anchors store: no part of the potential, for friction is no gradient.
  virtual double anchorEnergy(const Configuration& at) const = 0;
};

}  // namespace muelle::engine
