#pragma once
#include "engine/capabilities.h"
#include "engine/lane_motion.h"
#include "harness/dynamical_system.h"

#include <limits>
#include <string>

namespace muelle::engine {

/// A problem M a = F(t, x, v; z) with the capabilities that it has. The unknowns are the free degrees of freedom.
/// Internal variables z are frozen within a step.
///
/// The layout of x, v, f and a belongs to the system: arrays of storage() lanes, of which size() are unknowns. The
/// others are nodes that are held or moved, and padding: mass() and inverseMass() are 0 there, and so is a. A method
/// treats all lanes alike, so that nothing is gathered or copied; linear algebra numbers the unknowns by lanes().
///
/// A null capability is one that the system lacks; a method that needs it says so before the first step.
/// The functions are const, yet they may use scratch memory of the system: one thread a system.
class DynamicalSystem : public muelle::DynamicalSystem {
 public:
  /// Length of x, v, f, a and of mass() and inverseMass().
  virtual int storage() const { return size(); }
  /// The lane of each unknown; empty where unknown i is lane i.
  virtual std::span<const int> lanes() const { return {}; }
  /// 1/m [1/kg] of each lane; 0 where a lane is no unknown.
  virtual std::span<const double> inverseMass() const;
  /// Overwrites a with F/m [m/s^2], 0 in lanes that are no unknowns.
  virtual void acceleration(double t, In x, In v, In z, Out a) const;
  /// What an acceleration is rounded to, in parts of the largest: for who takes differences of two.
  virtual double accelerationRounding() const { return std::numeric_limits<double>::epsilon(); }
  /// Whether place() writes anything.
  virtual bool movesNodes() const { return true; }
  /// Writes the lanes of moved nodes, which are functions of t. Whoever makes an x or v for a time (a stage, the end of
  /// a step) places them before it goes into a force; a state that was committed is placed.
  virtual void place(double /*t*/, In /*z*/, Out /*x*/, Out /*v*/) const {}

  /// The motion where the internal variables say that, until one of them changes, nothing acts but what leaves each
  /// lane to itself: a uniform field, a contact across a lane. None where anything else does, or may.
  virtual LaneMotion laneMotion(In /*z*/) const { return {}; }

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
  /// Overwrites x and v with the positions and velocities of all nodes, dimension() numbers each, in the system's
  /// order: the held ones too.
  virtual void everyNode(const State& state, std::vector<double>& x, std::vector<double>& v) const {
    x = state.x;
    v = state.v;
  }

  /// Unknown i in the user's words: "node 12, z". For messages.
  virtual std::string unknownName(int i) const;
  /// Degrees of freedom a node, to tell nodes apart in messages and constraints: 1, 2 or 3.
  virtual int dimension() const { return 1; }

 private:
  mutable std::vector<double> inverseMass_;  ///< of a system that has none of its own, made when first asked for
};

/// The lane of an unknown.
inline std::size_t laneOf(const DynamicalSystem& system, int unknown) {
  const std::span<const int> lanes = system.lanes();
  return static_cast<std::size_t>(lanes.empty() ? unknown : lanes[static_cast<std::size_t>(unknown)]);
}
/// A lane in the user's words: the unknown's name, or that it is none.
std::string laneName(const DynamicalSystem& system, int lane);

}  // namespace muelle::engine
