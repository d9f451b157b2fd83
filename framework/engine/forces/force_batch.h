#pragma once
#include "engine/capabilities.h"
#include "engine/forces/layout.h"
#include "engine/forces/matrix_pattern.h"

#include <limits>
#include <string>
#include <vector>

namespace muelle::engine {

/// Where all nodes are, in the numbering and the layout of a built model. z are the internal variables of the whole
/// model.
struct Configuration {
  double t = 0.0;             ///< [s]
  const double* x = nullptr;  ///< [m]
  const double* v = nullptr;  ///< [m/s]
  const double* z = nullptr;
};

/// All the forces of one kind. Functions named add... add to arrays of lanes; what falls on nodes that are not free is
/// ignored by the system. A kind that has no part in something leaves the default, which does nothing.
class ForceBatch {
 public:
  virtual ~ForceBatch() = default;

  /// Whether the whole force derives from the energy.
  virtual bool isConservative() const { return true; }
  virtual bool usesVelocity() const { return false; }

  /// Whether its force is the same everywhere: gravity, whose energy has no zero of its own.
  virtual bool isUniformField() const { return false; }

  /// All of the force [N].
  virtual void addForce(const Configuration& at, double* f) const = 0;
  /// Potential energy [J].
  virtual double energy(const Configuration& at) const = 0;
  /// -grad of the energy [N].
  virtual void addConservativeForce(const Configuration& at, double* f) const { addForce(at, f); }
  /// A discrete gradient force between two configurations: f . (xb - xa) = E(xa) - E(xb), element by element.
  virtual void addDiscreteGradientForce(const Configuration& a, const Configuration& b, double* f) const = 0;

  /// Says which nodes share an element.
  virtual void couple(MatrixPattern&) const {}
  /// Looks up where the elements' blocks go. After MatrixPattern::finish().
  virtual void bind(const MatrixPattern&) {}
  /// Adds cD D + cK K, K = -dF/dx, D = -dF/dv, to the values of a matrix of the bound pattern.
  virtual void addDerivatives(const Configuration&, double /*cD*/, double /*cK*/, Form, double* /*values*/) const {}
  /// Whether the derivatives of Form::Exact are not symmetric.
  virtual bool isNotSymmetric() const { return false; }

  /// Columns of the low-rank part, for the unknowns alone, and their stiffness.
  virtual int lowRankColumns() const { return 0; }
  // By value: a Ref to write to, as Eigen has it.
  // NOLINTNEXTLINE(performance-unnecessary-value-param)
  virtual void writeLowRank(double /*cK*/, Eigen::Ref<Eigen::MatrixXd> /*U*/, Eigen::Ref<Eigen::VectorXd> /*s*/) const {
  }

  /// Elements that are constraints for XPBD; a kind without any is an external force there, or left out.
  virtual int constraintCount() const { return 0; }
  /// Whether these constraints are distances between nodes.
  virtual bool constraintsAreDistances() const { return false; }
  /// Evaluates constraint j; nodes that are held are in it too. False when it does not act.
  virtual bool evaluateConstraint(int /*j*/, const Configuration&, Constraint&) const { return false; }
  /// The part of the force that the constraints do not cover.
  virtual void addExternalForce(const Configuration& at, double* f) const { addForce(at, f); }
  /// What neither constraints nor external force cover; empty when nothing.
  virtual std::string leftOut() const { return {}; }

  /// Where nodes stand in the arrays. Before anything else.
  virtual void setLayout(const Layout& layout) { layout_ = layout; }

  /// Number of internal variables; they start at zOffset.
  virtual int internalSize() const { return 0; }
  void setInternalOffset(int offset) { zOffset_ = offset; }
  virtual int guardCount() const { return 0; }
  virtual void guards(const Configuration&, double* /*g*/) const {}
  virtual std::string guardName(int) const { return {}; }
  /// See Switching::eventName().
  virtual std::string eventName(int guard, const double* /*z*/) const { return guardName(guard); }
  virtual void declaredTimes(double /*from*/, double /*to*/, std::vector<double>& /*times*/) const {}
  /// Sets the internal variables for the configuration; true when the force may have changed.
  virtual bool commit(const Configuration&, bool /*frozen*/, double* /*z*/) const { return false; }
  /// Second part of a commit: `f` is the force on all nodes without friction. Only when wantsBalance() after commit().
  virtual bool wantsBalance() const { return false; }
  virtual bool balance(const Configuration&, const double* /*f*/, double* /*z*/) const { return false; }
  /// Adds the force without its friction.
  virtual void addForceWithoutFriction(const Configuration& at, double* f) const { addForce(at, f); }
  /// Sets the mode of guard i to the far side of its zero.
  virtual void cross(int /*guard*/, const Configuration&, double* /*z*/) const {}
  /// Sets the modes as if what may close were closed: see Switching::close().
  virtual void close(const Configuration&, double* /*z*/) const {}
  /// See Switching::shortestBounce().
  virtual double shortestBounce(const Configuration&) const { return std::numeric_limits<double>::infinity(); }
  /// Energy [J] that friction anchors store: no part of the potential, for friction is no gradient.
  virtual double anchorEnergy(const Configuration&) const { return 0.0; }
  /// Whether a node could pass through an obstacle of this batch.
  virtual bool isThin() const { return false; }
  /// The part of h in which nothing passes through an obstacle; `a` are accelerations.
  virtual double sweptBound(const Configuration&, const double* /*a*/, double h) const { return h; }

 protected:
  Layout layout_;
  int zOffset_ = 0;
};

}  // namespace muelle::engine
