#include "engine/integrators/explicit/engines/explicit_runge_kutta.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace muelle::engine {

ExplicitRungeKutta::ExplicitRungeKutta(MethodInfo info, const ButcherTableau& tableau)
    : info_(std::move(info)),
      c_(rounded(tableau.c)),
      b_(rounded(tableau.b)),
      errorWeights_(rounded(tableau.error)),
      firstSameAsLast_(tableau.firstSameAsLast) {
  for (const Coefficients& row : tableau.a) a_.push_back(rounded(row));
}

void ExplicitRungeKutta::prepare(const DynamicalSystem& system, const Tolerance& tolerance) {
  tolerance_ = tolerance;
  size_ = static_cast<std::size_t>(system.storage());
  const std::size_t slopes = stages() + extraSlopes_;
  memory_.assign(slopes * 2 * size_, 0.0);
  slopes_.resize(slopes);
  for (std::size_t j = 0; j < slopes; ++j) slopes_[j] = memory_.data() + 2 * size_ * j;
  stage_.resize(size_);
  restart();
}

void ExplicitRungeKutta::restart() {
  start_.clear();
  end_.clear();
  accepted_ = endKnown_ = false;
}

void ExplicitRungeKutta::accept() { accepted_ = true; }

void ExplicitRungeKutta::evaluate(const DynamicalSystem& system, double t, In x, In z, std::size_t j) {
  const Out a = acceleration(j);
  system.acceleration(t, x, velocity(j), z, a);
  ++work_.forceEvaluations;
}

void ExplicitRungeKutta::provideFirstSlope(const DynamicalSystem& system, const State& from) {
  const bool goesOn = accepted_ && endKnown_ && end_.matches(from);
  const bool again = start_.matches(from);
  accepted_ = endKnown_ = false;
  end_.clear();
  if (goesOn) {
    std::swap(slopes_[0], slopes_[endSlope()]);
  } else if (!again) {
    std::copy(from.v.begin(), from.v.end(), velocity(0).begin());
    evaluate(system, from.t, from.x, from.z, 0);
  }
  start_.set(from);
}

StepResult ExplicitRungeKutta::step(const DynamicalSystem& system, const State& from, double h, State& to) {
  provideFirstSlope(system, from);
  for (std::size_t i = 1; i < stages(); ++i) {
    combine(a_[i], from, h, stage_, velocity(i));
    system.place(from.t + c_[i] * h, from.z, stage_, velocity(i));
    evaluate(system, from.t + c_[i] * h, stage_, from.z, i);
  }
  prepareResult(from, h, to);
  combine(b_, from, h, to.x, to.v);
  end_.set(to);
  endKnown_ = firstSameAsLast_;
  return finiteOrFailure(system, from, to, error(from, to, h));
}

StepResult ExplicitRungeKutta::stepIncrement(const DynamicalSystem& system, const State& from, double h,
                                             State& increment) {
  StepResult result = step(system, from, h, increment);
  Combination positions, velocities;
  for (std::size_t j = 0; j < stages(); ++j) {
    positions.add(b_[j], slopes_[j]);
    velocities.add(b_[j], slopes_[j] + size_);
  }
  positions.assignTo(h, increment.x);
  velocities.assignTo(h, increment.v);
  return result;
}

void ExplicitRungeKutta::ensureEndSlope(const DynamicalSystem& system, const State& from, const State& to) {
  if (endKnown_) return;
  std::copy(to.v.begin(), to.v.end(), velocity(endSlope()).begin());
  // With the internal variables of the step: those of `to` may already be the next one's.
  evaluate(system, to.t, to.x, from.z, endSlope());
  endKnown_ = true;
}

void ExplicitRungeKutta::combine(std::span<const double> weights, const State& from, double h, Out x, Out v) const {
  Combination positions, velocities;
  for (std::size_t j = 0; j < weights.size(); ++j) {
    positions.add(weights[j], slopes_[j]);
    velocities.add(weights[j], slopes_[j] + size_);
  }
  positions.addTo(from.x, h, x);
  velocities.addTo(from.v, h, v);
}

double ExplicitRungeKutta::error(const State& from, const State& to, double h) const {
  return errorWeights_.empty() ? 0.0 : largestError(errorWeights_, from, to, h);
}

double ExplicitRungeKutta::largestError(std::span<const double> weights, const State& from, const State& to,
                                        double h) const {
  Combination positions, velocities;
  for (std::size_t j = 0; j < weights.size(); ++j) {
    positions.add(weights[j], slopes_[j]);
    velocities.add(weights[j], slopes_[j] + size_);
  }
  return larger(positions.largestError(h, from.x, to.x, tolerance_.relative * errorScale_.position),
                velocities.largestError(h, from.v, to.v, tolerance_.relative * errorScale_.velocity));
}

}  // namespace muelle::engine
