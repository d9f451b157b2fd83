#pragma once
#include "harness/dynamical_system.h"
#include "harness/node.h"

#include <functional>
#include <vector>

namespace muelle {

/// Forces of all nodes: reads time, positions and velocities, overwrites f. Flat arrays; see node3().
using ForceFunction = std::function<void(double t, In x, In v, Out f)>;

/// A system whose force is a function of the caller: how demos and tests run on a student's functions.
///
///     FunctionSystem system({m}, [&](double, In x, In, Out f) { f[0] = submission::springForce(x[0], 0.0, k, L0); });
class FunctionSystem : public DynamicalSystem {
 public:
  /// \param mass one per degree of freedom [kg]; throws std::invalid_argument when one is not positive and finite.
  FunctionSystem(std::vector<double> mass, ForceFunction force);

  int size() const override { return static_cast<int>(mass_.size()); }
  std::span<const double> mass() const override { return mass_; }
  void force(double t, In x, In v, In z, Out f) const override;

 private:
  std::vector<double> mass_;
  ForceFunction force_;
};

/// Node i of a flat array of 3D vectors.
inline Eigen::Map<const Vec3> node3(In values, int i) { return Eigen::Map<const Vec3>(values.data() + 3 * i); }
inline Eigen::Map<Vec3> node3(Out values, int i) { return Eigen::Map<Vec3>(values.data() + 3 * i); }

/// The state and the masses (three equal entries a node) of free nodes in 3D; the forces come from the caller.
/// Throws std::invalid_argument when a node is pinned: keep fixed points out of the state, as constants of the force.
State stateOf(const std::vector<Node>& nodes);
std::vector<double> massesOf(const std::vector<Node>& nodes);

}  // namespace muelle
