#pragma once
#include "engine/capabilities.h"
#include "harness/dynamical_system.h"

#include <limits>
#include <string>

namespace muelle::engine {

/// A problem M a = F(t, x, v; z) with the capabilities that it has. The unknowns are the free degrees of freedom:
/// neither pins nor the dimension appear here. Internal variables z are frozen within a step.
///
/// A null capability is one that the system lacks; a method that needs it says so before the first step.
/// The functions are const, yet they may use scratch memory of the system: one thread a system.
class DynamicalSystem : public muelle::DynamicalSystem {
 public:
  /// Length of the internal variables z.
  virtual int internalSize() const { return 0; }
  /// Whether the force depends on the velocity anywhere (a Nystroem method needs that it does not).
  virtual bool forceUsesVelocity() const { return true; }

  /// Whether a force changes with time in a way that no declared time announces: an adaptive method could step over it,
  /// and has to be given a largest step.
  virtual bool hasUnannouncedForce() const { return false; }
  /// The shortest period [s] of what acts or moves at time t as a function of time; infinite where nothing has one. It
  /// bounds the steps of adaptive methods, whose error estimate sees a vibration only when it is sampled.
  virtual double shortestPeriod(double /*t*/) const { return std::numeric_limits<double>::infinity(); }

  virtual const Potential* potential() const { return nullptr; }
  virtual const Drag* drag() const { return nullptr; }
  virtual const Linearisation* linearisation() const { return nullptr; }
  virtual const Constraints* constraints() const { return nullptr; }
  virtual const Switching* switching() const { return nullptr; }
  /// The rods, whose forces are not in force(): only a method with MethodInfo::holdsRods may run a system that has any.
  virtual std::span<const Rod> rods() const { return {}; }

  /// Whether something ties the system to a place: a node that is held or moved, an obstacle, drag, a field that
  /// varies. Without it the motion is the same however fast all of it flies by.
  virtual bool isTied() const { return true; }
  /// Overwrites x and v with the positions and velocities of all nodes, dimension() numbers each: the unknowns in their
  /// order, then the nodes that are held or moved.
  virtual void everyNode(const State& state, std::vector<double>& x, std::vector<double>& v) const {
    x = state.x;
    v = state.v;
  }

  /// Unknown i in the user's words: "node 12, z". For messages.
  virtual std::string unknownName(int i) const;
  /// Degrees of freedom a node, to tell nodes apart in messages and constraints: 1, 2 or 3.
  virtual int dimension() const { return 1; }
};

}  // namespace muelle::engine
