#pragma once
#include "harness/state.h"

namespace muelle {

/// The problem M a = F(t, x, v; z): what is simulated. What advances it by a step is a Step (march.h).
/// (Slide "Formulación Multidimensional".)
class DynamicalSystem {
 public:
  virtual ~DynamicalSystem() = default;

  /// Number of degrees of freedom.
  virtual int size() const = 0;
  /// Masses [kg], one per degree of freedom, all positive.
  virtual std::span<const double> mass() const = 0;
  /// Overwrites f with the forces [N] at time t, positions x, velocities v, internal variables z.
  virtual void force(double t, In x, In v, In z, Out f) const = 0;
};

}  // namespace muelle
