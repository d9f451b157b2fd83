#include "engine/integrators/explicit/engines/nystrom.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace muelle::engine {

MethodInfo nystromInfo() {
  MethodInfo info;
  info.adaptive = true;
  info.conservesMomentum = true;
  info.needs.velocityFreeForce = true;
  info.realLimit = 0.0;  // no damping can act on it
  info.formula =
      "x'' = A(t, x): stages of the positions alone; x+ = x + h v + h^2 sum b_i A_i, v+ = v + h sum bv_i A_i";
  info.source = "Dormand, El-Mikkawy and Prince, IMA J. Numer. Anal. 7 (1987) 423-430";
  return info;
}

Nystrom::Nystrom(MethodInfo info, const NystromTableau& tableau)
    : info_(std::move(info)),
      c_(rounded(tableau.c)),
      b_(rounded(tableau.b)),
      bv_(rounded(tableau.bv)),
      errorWeights_(rounded(tableau.error)),
      errorWeightsV_(rounded(tableau.errorv)),
      firstSameAsLast_(tableau.firstSameAsLast) {
  for (const Coefficients& row : tableau.a) a_.push_back(rounded(row));
}

void Nystrom::prepare(const DynamicalSystem& system, const Tolerance& tolerance) {
  if (system.forceUsesVelocity()) {
    throw std::invalid_argument(
        fmt::format("{} needs a force that does not depend on the velocity: remove damping, drag and friction, or use "
                    "dop853",
                    info_.name));
  }
  tolerance_ = tolerance;
  size_ = static_cast<std::size_t>(system.storage());
  memory_.assign((stages() + 1) * size_, 0.0);
  accelerations_.resize(stages() + 1);
  for (std::size_t j = 0; j <= stages(); ++j) accelerations_[j] = memory_.data() + size_ * j;
  stage_.resize(size_);
  stageVelocity_.resize(size_);
  restart();
}

void Nystrom::restart() {
  accepted_ = false;
  start_.clear();
  end_.clear();
}

void Nystrom::evaluate(const DynamicalSystem& system, double t, In x, In v, In z, std::size_t j) {
  const Out a(accelerations_[j], size_);
  system.acceleration(t, x, v, z, a);
  ++work_.forceEvaluations;
}

void Nystrom::provideFirst(const DynamicalSystem& system, const State& from) {
  if (start_.matches(from)) return;
  if (accepted_ && end_.matches(from)) {
    std::swap(accelerations_[0], accelerations_[stages() - 1]);
  } else {
    evaluate(system, from.t, from.x, from.v, from.z, 0);
  }
  start_.set(from);
}

void Nystrom::advance(const DynamicalSystem& system, const State& from, double h, State& to) {
  for (std::size_t i = 1; i < stages(); ++i) {
    Combination stage;
    stage.add(c_[i], from.v.data());
    for (std::size_t j = 0; j < i; ++j) stage.add(h * a_[i][j], accelerations_[j]);
    stage.addTo(from.x, h, stage_);
    system.place(from.t + c_[i] * h, from.z, stage_, stageVelocity_);
    evaluate(system, from.t + c_[i] * h, stage_, from.v, from.z, i);
  }
  prepareResult(from, h, to);
  Combination positions, velocities;
  positions.add(1.0, from.v.data());
  for (std::size_t j = 0; j < stages(); ++j) {
    positions.add(h * b_[j], accelerations_[j]);
    velocities.add(bv_[j], accelerations_[j]);
  }
  positions.addTo(from.x, h, to.x);
  velocities.addTo(from.v, h, to.v);
}

StepResult Nystrom::step(const DynamicalSystem& system, const State& from, double h, State& to) {
  provideFirst(system, from);
  accepted_ = false;
  end_.clear();
  advance(system, from, h, to);
  if (firstSameAsLast_) end_.set(to);
  return finiteOrFailure(system, from, to, error(from, to, h));
}

StepResult Nystrom::stepIncrement(const DynamicalSystem& system, const State& from, double h, State& increment) {
  StepResult result = step(system, from, h, increment);
  Combination positions, velocities;
  positions.add(1.0, from.v.data());
  for (std::size_t j = 0; j < stages(); ++j) {
    positions.add(h * b_[j], accelerations_[j]);
    velocities.add(bv_[j], accelerations_[j]);
  }
  positions.assignTo(h, increment.x);
  velocities.assignTo(h, increment.v);
  return result;
}

void Nystrom::interpolate(const DynamicalSystem& system, const State& from, const State& to, double theta, State& out) {
  // The first acceleration and the last, which the next step may begin with, are kept.
  provideFirst(system, from);
  std::swap(accelerations_[stages() - 1], accelerations_[stages()]);
  advance(system, from, theta * (to.t - from.t), out);
  std::swap(accelerations_[stages() - 1], accelerations_[stages()]);
}

double Nystrom::error(const State& from, const State& to, double h) const {
  Combination positions, velocities;
  for (std::size_t j = 0; j < stages(); ++j) {
    positions.add(errorWeights_[j], accelerations_[j]);
    velocities.add(errorWeightsV_[j], accelerations_[j]);
  }
  return larger(positions.largestError(h * h, from.x, to.x, tolerance_.relative * errorScale_.position),
                velocities.largestError(h, from.v, to.v, tolerance_.relative * errorScale_.velocity));
}

}  // namespace muelle::engine
