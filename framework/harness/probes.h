#pragma once
#include "harness/dynamical_system.h"
#include "harness/types.h"

#include <functional>
#include <string>
#include <vector>

namespace muelle {

/// Something to measure along a run. The function is the caller's: the harness knows no elastic energy.
struct Probe {
  std::string name;  ///< "elastic energy"
  std::string unit;  ///< "J"
  std::function<double(const State&)> measure;
};

/// Sum of m v^2 / 2 [J]. Follows from the masses alone, so it stands here.
Probe kineticEnergy(const DynamicalSystem& system);
/// Component `axis` (0, 1, 2) of the linear momentum sum m v of a 3D system [kg m/s].
Probe linearMomentum(const DynamicalSystem& system, int axis);
/// Component `axis` of the angular momentum sum x cross m v about the origin of a 3D system [kg m^2/s].
Probe angularMomentum(const DynamicalSystem& system, int axis);
/// The sum of other probes, which share a unit.
Probe sum(std::string name, std::vector<Probe> terms);

}  // namespace muelle
