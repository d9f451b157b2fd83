#pragma once
#include "engine/constraint_sweep.h"
#include "engine/forces/configuration.h"

#include <string>

namespace muelle::engine {

/// A force batch's share of the Constraints: its elastic energies as constraints, one virtual call for all of them.
/// Nodes that are held are in them, too.
class ConstraintPiece {
 public:
  virtual ~ConstraintPiece() = default;

  virtual int constraintCount() const = 0;
  /// Whether these constraints are distances between nodes.
  virtual bool constraintsAreDistances() const { return false; }
  /// Projects those that act, in order; at.x is the projection's x, which changes on the way.
  virtual void project(const Configuration& at, const ConstraintProjection& projection) const = 0;
  /// Hands those that act to `blocks`, in order; the first has the number `first`.
  virtual void evaluateConstraints(const Configuration& at, int first, ConstraintBlocks& blocks) const = 0;
  /// The part of the force that the constraints do not cover.
  virtual void addExternalForce(const Configuration&, double* /*f*/) const {}
  /// What neither constraints nor external force cover; empty when nothing.
  virtual std::string leftOut() const { return {}; }
};

}  // namespace muelle::engine
