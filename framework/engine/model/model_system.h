#pragma once
#include "engine/dynamical_system.h"
#include "engine/model/model.h"

#include <memory>
#include <string>
#include <vector>

namespace muelle::engine {

/// A built model: a DynamicalSystem, and the way back to the user's numbering of nodes.
///
/// Inside, pinned and moved nodes are no unknowns, and nodes are renumbered so that neighbours lie close.
class ModelSystem : public DynamicalSystem {
 public:
  /// Positions and velocities as the model states them, at t = 0, with z set for them (live modes).
  virtual State initialState() const = 0;
  virtual int nodeCount() const = 0;
  /// Position [m] and velocity [m/s] of a node of the user's numbering, pinned and moved ones included; components that
  /// the scene does not have are 0 (1D: the first component; 2D: those of Model::plane).
  virtual Vec3 position(const State& state, int node) const = 0;
  virtual Vec3 velocity(const State& state, int node) const = 0;
  /// The index in x, v and f of a node's component `axis` (0, 1, 2 in 3D; the axes of the plane in 2D; 0 in 1D). Throws
  /// std::out_of_range for a node or axis that does not exist.
  virtual int lane(int node, int axis) const = 0;
  /// The number of that component among the unknowns, which numbers the rows of matrices; -1 when the node is pinned or
  /// moved.
  virtual int unknown(int node, int axis) const = 0;
  virtual const Model& model() const = 0;
  /// Whether springs lie on a grid of 2D or 3D, so that Model::precision decides something.
  virtual bool mayBeSingle() const = 0;

  virtual double kineticEnergy(const State& state) const = 0;  ///< [J]
  /// Kinetic and potential [J], and what friction anchors store; z may be empty (then without the anchors).
  virtual double totalEnergy(const State& state) const = 0;
  virtual double elasticEnergy(const State& state) const = 0;  ///< potential energy without that of gravity [J]
  /// Of the free nodes [kg m/s], [kg m^2/s] about the origin (3D; in 2D about the axis across the plane).
  virtual Vec3 momentum(const State& state) const = 0;
  virtual Vec3 angularMomentum(const State& state) const = 0;
};

/// Checks the model and builds it: one templated builder behind one switch on the dimension.
///
/// Throws std::invalid_argument that names the offending item and what is wrong with it: "spring 3 joins node 4 with
/// itself", "node 7: mass is nan; a mass is positive and finite".
///
/// \param without names of parts that are left out, as if the model did not have them: see withoutParts()
std::unique_ptr<ModelSystem> build(const Model& model, const std::vector<std::string>& without = {});

}  // namespace muelle::engine
