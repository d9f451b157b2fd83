#include "engine/statics/at_rest.h"

#include "engine/forces/segment.h"
#include "engine/model/axes.h"

namespace muelle::engine {

std::vector<double> externalForces(const ModelSystem& system, double t) {
  const Model& model = system.model();
  const std::vector<int> axes = axesOf(model);
  std::vector<double> loads(static_cast<std::size_t>(system.storage()), 0.0);
  for (const ModelExternalForce& external : model.externalForces) {
    const Vec3 F = external.force(t, segmentAt(external.times, t));
    for (const int node : external.nodes) {
      for (const int axis : axes) {
        if (system.unknown(node, axis) >= 0) loads[static_cast<std::size_t>(system.lane(node, axis))] += F[axis];
      }
    }
  }
  return loads;
}

AtRest::AtRest(const ModelSystem& system, double t) : system_(system), loads_(externalForces(system, t)) {}

double AtRest::energy(double t, In x, In z) const {
  double sum = system_.potential()->energy(t, x, z);
  for (std::size_t i = 0; i < loads_.size(); ++i) sum -= loads_[i] * x[i];
  return sum;
}

void AtRest::conservativeForce(double t, In x, In z, Out f) const {
  system_.potential()->conservativeForce(t, x, z, f);
  for (std::size_t i = 0; i < loads_.size(); ++i) f[i] += loads_[i];
}

void AtRest::discreteGradientForce(double t, In xa, In xb, In z, Out f) const {
  system_.potential()->discreteGradientForce(t, xa, xb, z, f);
  for (std::size_t i = 0; i < loads_.size(); ++i) f[i] += loads_[i];
}

}  // namespace muelle::engine
