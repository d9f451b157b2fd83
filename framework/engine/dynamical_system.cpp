#include "engine/dynamical_system.h"

#include <fmt/format.h>
#include <algorithm>

namespace muelle::engine {

std::span<const double> DynamicalSystem::inverseMass() const {
  if (inverseMass_.empty()) {
    for (const double m : mass()) inverseMass_.push_back(m > 0.0 ? 1.0 / m : 0.0);
  }
  return inverseMass_;
}

void DynamicalSystem::acceleration(double t, In x, In v, In z, Out a) const {
  force(t, x, v, z, a);
  const std::span<const double> w = inverseMass();
  for (std::size_t i = 0; i < a.size(); ++i) a[i] *= w[i];
}

std::string laneName(const DynamicalSystem& system, int lane) {
  const std::span<const int> lanes = system.lanes();
  if (lanes.empty()) return system.unknownName(lane);
  const auto found = std::ranges::find(lanes, lane);
  if (found == lanes.end()) return "a node that is held or moved";
  return system.unknownName(static_cast<int>(found - lanes.begin()));
}

std::string DynamicalSystem::unknownName(int i) const { return fmt::format("unknown {}", i); }

}  // namespace muelle::engine
