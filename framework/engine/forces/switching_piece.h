#pragma once
#include "engine/forces/configuration.h"
#include "engine/lane_motion.h"

#include <limits>
#include <string>
#include <vector>

namespace muelle::engine {

/// A force batch's share of Switching: its internal variables, and where its force is not smooth. A kind without
/// guards, declared times or obstacles leaves the defaults.
class SwitchingPiece {
 public:
  virtual ~SwitchingPiece() = default;

  /// Number of internal variables; they start at zOffset_.
  virtual int internalSize() const = 0;
  void setInternalOffset(int offset) { zOffset_ = offset; }
  /// Adds what acts until the next event, as the internal variables, frozen, say; false where that couples lanes, is
  /// not linear, or changes with time.
  virtual bool addLaneForces(const double* /*z*/, const LaneForces& /*lanes*/) const { return false; }
  /// Sets the internal variables for the configuration; true when the force may have changed.
  virtual bool commit(const Configuration& at, bool frozen, double* z) const = 0;
  virtual void declaredTimes(double /*from*/, double /*to*/, std::vector<double>& /*times*/) const {}

  virtual int guardCount() const { return 0; }
  virtual void guards(const Configuration&, double* /*g*/) const {}
  virtual std::string guardName(int) const { return {}; }
  /// See Switching::eventName().
  virtual std::string eventName(int guard, const double* /*z*/) const { return guardName(guard); }
  /// Sets the mode of guard i to the far side of its zero.
  virtual void cross(int /*guard*/, const Configuration&, double* /*z*/) const {}
  /// Sets the modes as if what may close were closed: see Switching::close().
  virtual void close(const Configuration&, double* /*z*/) const {}

  /// See Switching::shortestBounce().
  virtual double shortestBounce(const Configuration&) const { return std::numeric_limits<double>::infinity(); }
  /// Whether a node could pass through an obstacle of this batch.
  virtual bool isThin() const { return false; }
  /// The part of h in which nothing passes through an obstacle; `a` are accelerations.
  virtual double sweptBound(const Configuration&, const double* /*a*/, double h) const { return h; }

 protected:
  int zOffset_ = 0;
};

}  // namespace muelle::engine
