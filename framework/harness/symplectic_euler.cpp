#include "harness/symplectic_euler.h"

#include <algorithm>

namespace muelle {

void symplecticEulerStep(const DynamicalSystem& system, const State& from, double h, State& to) {
  system.force(from.t, from.x, from.v, from.z, to.v);
  const std::span<const double> mass = system.mass();
  for (std::size_t i = 0; i < mass.size(); ++i) {
    const double force = to.v[i];
    to.v[i] = from.v[i] + h * force / mass[i];
    to.x[i] = from.x[i] + h * to.v[i];
  }
  std::copy(from.z.begin(), from.z.end(), to.z.begin());
  to.t = from.t + h;
}

}  // namespace muelle
