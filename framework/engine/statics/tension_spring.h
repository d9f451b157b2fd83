#pragma once
#include "harness/types.h"

#include <cstddef>

namespace muelle::engine {

/// A spring with at least one free node, as TensionForm has it: its tension by the length, or an unknown of its own.
/// Positions have the components of the scene, first ones first.
struct TensionSpring {
  std::size_t spring = 0;                             ///< in the model
  int a = -1, b = -1;                                 ///< first unknown of the node; -1: fixed, at
  Vec3 fixedA = Vec3::Zero(), fixedB = Vec3::Zero();  ///< [m]
  double k = 0.0, L0 = 0.0;                           ///< [N/m], [m]
  bool onlyPushes = false;
  bool mixed = false;     ///< whether S is an unknown
  double rho = 0.0;       ///< [N/m] left to the positions
  double S = 0.0;         ///< unknown part of the tension [N]
  double L = 0.0;         ///< length [m]
  Vec3 n = Vec3::Zero();  ///< from b to a, of length 1; 0 at length 0

  bool acts() const { return k > 0.0 && L > 0.0 && (!onlyPushes || L < L0); }
  /// [N]; positive pulls.
  double tension() const {
    if (!acts()) return 0.0;
    return mixed ? S + rho * (L - L0) : k * (L - L0);
  }
  /// What the force along the spring changes by with its length, tensions that are unknowns aside [N/m].
  double stiffness() const { return mixed ? rho : k; }
  /// L - L0 - T/k of a spring whose tension is an unknown [m].
  double lengthError() const { return mixed ? (L - L0) - S / (k - rho) : 0.0; }
};

}  // namespace muelle::engine
