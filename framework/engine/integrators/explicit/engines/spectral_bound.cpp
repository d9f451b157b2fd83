#include "engine/integrators/explicit/engines/spectral_bound.h"

#include <algorithm>
#include <cmath>

namespace muelle::engine {

namespace {

double massNorm(In vector, std::span<const double> mass) {
  double sum = 0.0;
  for (std::size_t i = 0; i < vector.size(); ++i) sum += mass[i] * vector[i] * vector[i];
  return std::sqrt(sum);
}

}  // namespace

void SpectralBound::prepare(const DynamicalSystem& system) {
  const auto n = static_cast<std::size_t>(system.storage());
  perturbed_.resize(n);
  changed_.resize(n);
  for (Iteration* iteration : {&stiffness_, &damping_}) {
    iteration->direction.resize(n);
    // Any vector with a part in every mode: the golden ratio's multiples are spread evenly, and the same in every run.
    for (std::size_t i = 0; i < n; ++i) {
      const double spread = 0.6180339887498949 * static_cast<double>(i + 1);
      iteration->direction[i] = system.inverseMass()[i] > 0.0 ? spread - std::floor(spread) - 0.4 : 0.0;
    }
    const double norm = massNorm(iteration->direction, system.mass());
    for (double& entry : iteration->direction) entry /= norm;
    iteration->eigenvalue = 0.0;
  }
  settled_ = false;
  calls_ = 0;
}

double SpectralBound::iterate(const DynamicalSystem& system, const State& state, In acceleration, bool ofVelocity,
                              Work& work) {
  Iteration& iteration = ofVelocity ? damping_ : stiffness_;
  const std::vector<double>& base = ofVelocity ? state.v : state.x;
  const std::span<const double> mass = system.mass();
  double size = 0.0, reach = 0.0;
  for (std::size_t i = 0; i < base.size(); ++i) {
    size = std::max(size, std::abs(base[i]));
    reach = std::max(reach, std::abs(iteration.direction[i]));
  }
  if (reach == 0.0) return 0.0;
  // Half of the digits for the difference, half for what is not linear.
  const double epsilon = std::sqrt(system.accelerationRounding()) * std::max(size, 1e-3) / reach;
  for (std::size_t i = 0; i < base.size(); ++i) perturbed_[i] = base[i] + epsilon * iteration.direction[i];
  system.acceleration(state.t, ofVelocity ? In(state.x) : In(perturbed_), ofVelocity ? In(perturbed_) : In(state.v),
                      state.z, changed_);
  ++work.forceEvaluations;
  for (std::size_t i = 0; i < base.size(); ++i) changed_[i] = (changed_[i] - acceleration[i]) / epsilon;
  const double found = massNorm(changed_, mass);
  const double change = std::abs(found - iteration.eigenvalue) / std::max(found, 1e-300);
  iteration.eigenvalue = found;
  if (found > 0.0 && std::isfinite(found)) {
    for (std::size_t i = 0; i < base.size(); ++i) iteration.direction[i] = changed_[i] / found;
  }
  return found > 0.0 ? change : 0.0;
}

double SpectralBound::update(const DynamicalSystem& system, const State& state, In acceleration, Work& work) {
  if (!settled_) {
    for (const bool ofVelocity : {false, true}) {
      if (ofVelocity && !system.forceUsesVelocity()) continue;
      for (int i = 0; i < mostIterations && iterate(system, state, acceleration, ofVelocity, work) > 0.02; ++i)
        continue;
    }
    settled_ = true;
    calls_ = 0;
  } else if (++calls_ % callsBetween == 0) {
    iterate(system, state, acceleration, false, work);
    if (system.forceUsesVelocity()) iterate(system, state, acceleration, true, work);
  }
  const double delta = damping_.eigenvalue, kappa = stiffness_.eigenvalue;
  constexpr double margin = 1.2;
  return margin * 0.5 * (delta + std::sqrt(delta * delta + 4.0 * kappa));
}

}  // namespace muelle::engine
