#include "harness/symplectic_euler.h"

#include <algorithm>

namespace muelle {

void SymplecticEuler::prepare(const DynamicalSystem& system) {
  force_.assign(static_cast<std::size_t>(system.size()), 0.0);
}

void SymplecticEuler::step(const DynamicalSystem& system, const State& from, double h, State& to) {
  system.force(from.t, from.x, from.v, from.z, force_);
  const std::span<const double> mass = system.mass();
  for (std::size_t i = 0; i < force_.size(); ++i) {
    to.v[i] = from.v[i] + h * force_[i] / mass[i];
    to.x[i] = from.x[i] + h * to.v[i];
  }
  std::copy(from.z.begin(), from.z.end(), to.z.begin());
  to.t = from.t + h;
}

}  // namespace muelle
