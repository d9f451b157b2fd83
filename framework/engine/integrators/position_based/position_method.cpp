#include "engine/integrators/position_based/position_method.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace muelle::engine {

void PositionMethod::prepare(const DynamicalSystem& system, const Tolerance&) {
  const Constraints* constraints = system.constraints();
  if (constraints == nullptr) {
    throw std::invalid_argument(
        fmt::format("{} needs the elastic energies as constraints, which this system lacks", info_.id));
  }
  const std::string missing = constraints->leftOut();
  if (!missing.empty()) {
    throw std::invalid_argument(fmt::format("{} takes forces as constraints, which leave out: {}", info_.id, missing));
  }
  if (info_.needs.distanceConstraints && !constraints->onlyDistances()) {
    throw std::invalid_argument(
        fmt::format("{} takes springs only; this system has constraints that are no distances", info_.id));
  }
  external_.assign(static_cast<std::size_t>(system.storage()), 0.0);
  mass_ = inverseMass_ = external_;
  restart();
}

void PositionMethod::accelerate(const DynamicalSystem& system, double t, double h, State& state) {
  system.constraints()->externalForce(t, state.x, state.v, state.z, external_);
  ++work_.forceEvaluations;
  const std::span<const double> mass = system.mass();
  const std::span<const double> drag =
      system.drag() != nullptr ? system.drag()->coefficients() : std::span<const double>{};
  for (std::size_t i = 0; i < state.v.size(); ++i) {
    mass_[i] = mass[i] + (drag.empty() ? 0.0 : h * drag[i]);
    inverseMass_[i] = mass_[i] > 0.0 ? 1.0 / mass_[i] : 0.0;
    state.v[i] += h * external_[i] * inverseMass_[i];
  }
}

StepResult PositionMethod::finish(const State& from, double h, State& to) const {
  to.t = from.t + h;
  StepResult result;
  const auto finite = [](double value) { return std::isfinite(value); };
  result.done = std::ranges::all_of(to.x, finite) && std::ranges::all_of(to.v, finite);
  if (!result.done) result.failure = fmt::format("{} with h = {:.6g} s: the new state is not finite", info_.id, h);
  return result;
}

MethodInfo positionBasedInfo(std::string id, std::string name) {
  MethodInfo info;
  info.id = std::move(id);
  info.name = std::move(name);
  info.order = 1;
  info.stages = 0;
  info.implicit = true;
  info.iterative = true;
  info.conservesMomentum = true;
  info.stability = Stability::LStable;
  info.imaginaryLimit = info.realLimit = std::numeric_limits<double>::infinity();
  info.needs.constraints = true;
  return info;
}

}  // namespace muelle::engine
