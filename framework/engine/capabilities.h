#pragma once
/// \file
/// What a system can offer a method beyond its force. Students never see this header.

#include "engine/constraint_sweep.h"
#include "harness/state.h"
#include "harness/types.h"

#include <array>
#include <Eigen/SparseCore>
#include <limits>
#include <vector>

namespace muelle::engine {

/// The energy from which the conservative part of the force derives.
class Potential {
 public:
  virtual ~Potential() = default;

  /// Whether every force of the system derives from the energy: no damping, no friction, no explicit time.
  virtual bool isComplete() const = 0;
  /// Potential energy [J]: elastic, gravity, contact, properties.
  virtual double energy(double t, In x, In z) const = 0;
  /// Overwrites f with -grad energy [N].
  virtual void conservativeForce(double t, In x, In z, Out f) const = 0;
  /// Overwrites f with a discrete gradient force between two positions: f . (xb - xa) = E(xa) - E(xb) to round-off,
  /// symmetric in xa and xb, and -grad E(x) when both are x. (Gonzalez 1996; for a spring the exact quotient
  /// f = -k (1 - 2 L0 / (La + Lb)) (da + db) / 2.)
  virtual void discreteGradientForce(double t, In xa, In xb, In z, Out f) const = 0;
};

/// A linear drag -d_i v_i that acts on each unknown alone, so that it can be integrated exactly.
class Drag {
 public:
  virtual ~Drag() = default;

  /// Coefficients d_i [kg/s], one per lane, not negative; 0 where a lane is no unknown.
  virtual std::span<const double> coefficients() const = 0;
  /// Overwrites a with all forces but this drag over the masses [m/s^2].
  virtual void accelerationWithoutDrag(double t, In x, In v, In z, Out a) const = 0;
  /// Whether the forces without the drag still depend on the velocity (a method then evaluates them twice a step).
  virtual bool remainderUsesVelocity() const { return true; }
};

/// A symmetric matrix U diag(s) U^T of few columns: the stiffness of a property of all nodes, never assembled.
struct LowRank {
  Eigen::MatrixXd U;  ///< size() x r
  Eigen::VectorXd s;  ///< r values
  bool empty() const { return s.size() == 0; }
};

/// A sparse matrix and a low-rank addition.
struct SystemMatrix {
  Eigen::SparseMatrix<double> sparse;  ///< all entries (both triangles), column major, compressed
  LowRank lowRank;
  bool symmetric = true;  ///< whether the sparse part is symmetric by construction
};

/// Which derivative: the true one, or one that is safe to step along.
enum class Form {
  Exact,      ///< the true derivatives, possibly indefinite and not symmetric
  Symmetric,  ///< the energy's exact Hessian; the damping force is taken as constant in x
  Projected,  ///< each element's block made positive semidefinite, damping as in Symmetric: a direction, nothing more
};

/// Derivatives of the force, in the form in which implicit methods need them.
class Linearisation {
 public:
  virtual ~Linearisation() = default;

  /// Overwrites J = cM M + cD D + cK K, with K = -dF/dx and D = -dF/dv at the given state. The pattern of the sparse
  /// part does not change between calls, so that a factorisation's analysis may be kept.
  virtual void assemble(double cM, double cD, double cK, double t, In x, In v, In z, Form form,
                        SystemMatrix& J) const = 0;
};

/// The elastic energies as constraints; what is no constraint is an external force.
class Constraints {
 public:
  virtual ~Constraints() = default;

  virtual int count() const = 0;
  /// Whether all of them are distances, those that do not act included.
  virtual bool onlyDistances() const { return true; }
  /// Hands those that act at x (an open contact does not) to `take`, in order, some at a time.
  virtual void evaluate(double t, In x, In z, const ConstraintBlocks::Take& take) const = 0;
  /// Projects those that act, in order, each at the x that those before it have left.
  virtual void project(double t, In z, const ConstraintProjection& projection) const = 0;
  /// Overwrites f with the forces that no constraint covers: gravity, drag, external forces.
  virtual void externalForce(double t, In x, In v, In z, Out f) const = 0;
  /// Empty when the constraints and externalForce() together are all the forces; else what is left out, for a message.
  virtual std::string leftOut() const = 0;
};

/// A rod: two nodes whose distance never changes.
struct Rod {
  std::array<int, 3> a{}, b{};  ///< lanes of the ends' components, as many as the system has dimensions
  double length = 1.0;          ///< [m]
};

/// Where the force is not smooth. Modes are kept in z: live (as the positions say) as long as events are not located,
/// frozen between events otherwise, so that every step sees a smooth force.
class Switching {
 public:
  virtual ~Switching() = default;

  /// Number of guards: functions of the state that change sign where the force switches.
  virtual int guardCount() const = 0;
  virtual void guards(double t, In x, In v, In z, Out g) const = 0;
  /// Guard i in the user's words, whichever way it is passed: "node 3 touches or leaves 'ground'".
  virtual std::string guardName(int i) const = 0;
  /// What a zero of guard i has done, z being what cross() has made of it: "node 3 touches 'ground'".
  virtual std::string eventName(int i, const State& /*after*/) const { return guardName(i); }
  /// Appends the declared times in (from, to] at which the force jumps, ascending.
  virtual void declaredTimes(double from, double to, std::vector<double>& times) const = 0;
  /// Sets z for the state, at the start of a run and after each accepted step. `frozen`: fix the modes (events are
  /// located); otherwise leave them live. Friction anchors move here in either case. True when the force may have
  /// changed: a method with memory starts afresh.
  virtual bool commit(State& state, bool frozen) const = 0;
  /// Called with a located event: sets the mode of guard i to the far side of the crossing.
  virtual void cross(int guard, State& state) const = 0;
  /// Sets z as if what may close were closed: every one-sided spring, and each obstacle on a node that it would shake
  /// fastest, the lightest, the nearest of these. For a look at the stiffest that the force may become.
  virtual void close(State& /*state*/) const {}
  /// The shortest time [s] that a node would take to bounce off something that it does not touch in this state, half a
  /// period of its contact; infinite where there is nothing such.
  virtual double shortestBounce(const State& /*state*/) const { return std::numeric_limits<double>::infinity(); }
  /// The largest part of h in which no node can pass through an obstacle from this state (swept test, with the
  /// present acceleration); h when nothing is near.
  virtual double sweptBound(double t, In x, In v, In z, double h) const = 0;
};

}  // namespace muelle::engine
