#pragma once
#include "engine/forces/configuration.h"
#include "engine/forces/constraint_piece.h"
#include "engine/forces/friction_piece.h"
#include "engine/forces/layout.h"
#include "engine/forces/low_rank_piece.h"
#include "engine/forces/stiffness_piece.h"
#include "engine/forces/switching_piece.h"

#include <algorithm>
#include <cstddef>

namespace muelle::engine {

/// All the forces of one kind: force and energy, and the pieces that the kind has, as a DynamicalSystem has
/// capabilities. Functions named add... add to arrays of lanes; what falls on nodes that are not free is ignored by the
/// system.
class ForceBatch {
 public:
  virtual ~ForceBatch() = default;

  /// Where nodes stand in the arrays. Before anything else.
  void setLayout(const Layout& layout) { layout_ = layout; }

  /// Whether the whole force derives from the energy.
  virtual bool isConservative() const { return true; }
  virtual bool usesVelocity() const { return false; }
  /// Whether its force is the same everywhere: gravity, whose energy has no zero of its own.
  virtual bool isUniformField() const { return false; }

  /// All of the force [N].
  virtual void addForce(const Configuration& at, double* f) const = 0;
  /// The same over whatever f holds in its `lanes`: the first batch of a system writes, the others add.
  virtual void writeForce(const Configuration& at, double* f, std::size_t lanes) const {
    std::fill_n(f, lanes, 0.0);
    addForce(at, f);
  }
  /// Potential energy [J].
  virtual double energy(const Configuration& at) const = 0;
  /// -grad of the energy [N].
  virtual void addConservativeForce(const Configuration& at, double* f) const { addForce(at, f); }
  /// A discrete gradient force between two configurations: f . (xb - xa) = E(xa) - E(xb), element by element.
  virtual void addDiscreteGradientForce(const Configuration& a, const Configuration& b, double* f) const = 0;

  // What a kind offers besides; null where it has none. The pieces live as long as the batch.

  /// Without: the force is the same at any x and v, as far as an implicit method looks.
  virtual StiffnessPiece* stiffnessPiece() { return nullptr; }
  virtual LowRankPiece* lowRankPiece() { return nullptr; }
  /// Without: the whole force is an external one for methods that take constraints.
  virtual ConstraintPiece* constraintPiece() { return nullptr; }
  /// Without: the force is smooth.
  virtual SwitchingPiece* switchingPiece() { return nullptr; }
  virtual FrictionPiece* frictionPiece() { return nullptr; }

 protected:
  Layout layout_;
};

}  // namespace muelle::engine
