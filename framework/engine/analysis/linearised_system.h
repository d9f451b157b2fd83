#pragma once
#include "engine/compact_system.h"

#include <memory>
#include <vector>

namespace muelle::engine {

/// A system linearised about a state: M y'' + D y' + K y = 0 with K = -dF/dx, D = -dF/dv. The matrices come from the
/// system's linearisation (sparse, with the low-rank part applied as such); without one, products come from central
/// differences of the force, two evaluations each. All vectors are of unknowns alone.
class LinearisedSystem {
 public:
  LinearisedSystem(const DynamicalSystem& system, const State& state);
  ~LinearisedSystem();
  LinearisedSystem(const LinearisedSystem&) = delete;
  LinearisedSystem& operator=(const LinearisedSystem&) = delete;

  int size() const;
  const CompactSystem& system() const { return system_; }
  /// Overwrites out with K y; with D y, drag included; and with the drag's part of D y.
  void stiffness(In y, Out out) const;
  void damping(In y, Out out) const;
  void drag(In y, Out out) const;
  /// Whether D vanishes.
  bool isUndamped() const { return !system_.forceUsesVelocity(); }
  /// The matrices; null where products come from differences, and D's where it vanishes.
  const SystemMatrix* stiffnessMatrix() const;
  const SystemMatrix* dampingMatrix() const;

 private:
  struct Matrices;
  void difference(In y, bool ofVelocity, Out out) const;

  CompactSystem system_;
  State state_;                         ///< compact
  std::unique_ptr<Matrices> matrices_;  // null: by differences
};

}  // namespace muelle::engine
