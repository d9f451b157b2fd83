#include "engine/integrators/explicit/engines/stage_integrator.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace muelle::engine {

Coefficients squared(const Coefficients& w, const std::vector<Coefficients>& a) {
  Coefficients sum(w.size(), 0.0L), size(w.size(), 0.0L);
  for (std::size_t i = 0; i < w.size() && i < a.size(); ++i) {
    for (std::size_t j = 0; j < a[i].size(); ++j) {
      sum[j] += w[i] * a[i][j];
      size[j] += std::abs(w[i] * a[i][j]);
    }
  }
  for (std::size_t j = 0; j < sum.size(); ++j) {
    if (std::abs(sum[j]) < 1e-15L * size[j]) sum[j] = 0.0L;
  }
  return sum;
}

AccelerationTableau accelerationTableau(const NystromTableau& tableau) {
  return {.c = tableau.c,
          .ax = tableau.a,
          .av = {},
          .bx = tableau.b,
          .bv = tableau.bv,
          .ex = {tableau.error},
          .ev = {tableau.errorv},
          .firstSameAsLast = tableau.firstSameAsLast};
}

AccelerationTableau accelerationTableau(const ButcherTableau& tableau, const Coefficients& more) {
  AccelerationTableau result{.c = tableau.c,
                             .ax = {},
                             .av = tableau.a,
                             .bx = squared(tableau.b, tableau.a),
                             .bv = tableau.b,
                             .ex = {},
                             .ev = {},
                             .firstSameAsLast = tableau.firstSameAsLast};
  for (const Coefficients& row : tableau.a) result.ax.push_back(squared(row, tableau.a));
  for (const Coefficients* weights : {&tableau.error, &more}) {
    if (weights->empty()) continue;
    result.ex.push_back(squared(*weights, tableau.a));
    result.ev.push_back(*weights);
  }
  return result;
}

StagePlan::StagePlan(MethodInfo facts, const AccelerationTableau& tableau)
    : info(std::move(facts)), c(rounded(tableau.c)), firstSameAsLast(tableau.firstSameAsLast) {
  sums.reserve(c.size() + 1);
  for (std::size_t i = 0; i < c.size(); ++i) {
    sums.emplace_back(tableau.ax[i], tableau.av.empty() ? Coefficients{} : tableau.av[i]);
  }
  sums.emplace_back(tableau.bx, tableau.bv, tableau.ex, tableau.ev);
}

void StageIntegrator::prepare(const DynamicalSystem& system, const Tolerance& tolerance) {
  tolerance_ = tolerance;
  size_ = static_cast<std::size_t>(system.storage());
  kernels_ = &stageKernels(size_);
  velocities_ = system.forceUsesVelocity();
  places_ = system.movesNodes();
  accelerations_.assign(stages() + extra_, size_);
  stage_.assign(2, size_);
  zeros_.assign(size_, 0.0);
  moved_ = true;
  restart();
}

void StageIntegrator::restart() {
  startMark_.clear();
  endMark_.clear();
  accepted_ = endKnown_ = false;
}

/// Puts a step's length and the place of accelerations that have changed theirs into the sums of all stages.
void StageIntegrator::bind(double h) {
  for (StageSum& sum : sums_) {
    if (h != h_) sum.scale(h);
    if (moved_) sum.readFrom(accelerations_.begins());
  }
  h_ = h;
  moved_ = false;
}

void StageIntegrator::evaluate(const DynamicalSystem& system, double t, Out x, Out v, In z, std::size_t j) {
  system.place(t, z, x, v);
  system.acceleration(t, x, v, z, acceleration(j));
  ++work_.forceEvaluations;
}

void StageIntegrator::provideFirst(const DynamicalSystem& system, const State& from) {
  const bool goesOn = accepted_ && endKnown_ && endMark_.matches(from);
  const bool again = !accepted_ && startMark_.matches(from);
  accepted_ = endKnown_ = false;
  if (goesOn) {
    const std::size_t last = plan_.firstSameAsLast ? stages() - 1 : stages();
    constexpr std::size_t few = 64;  // lanes, which are copied sooner than all sums are told
    if (size_ > few) {
      swapAccelerations(0, last);
    } else {
      std::ranges::copy(acceleration(last), acceleration(0).begin());
    }
  } else if (!again) {
    system.acceleration(from.t, from.x, from.v, from.z, acceleration(0));
    ++work_.forceEvaluations;
  }
  startMark_.set(from);
}

void StageIntegrator::recallFirst(const DynamicalSystem& system, const State& from) {
  if (startMark_.matches(from)) return;
  system.acceleration(from.t, from.x, from.v, from.z, acceleration(0));
  ++work_.forceEvaluations;
  startMark_.set(from);
}

void StageIntegrator::sum(StageSum& weights, double c, const State& from, double h, Out x, Out v) {
  weights.scale(h);
  weights.readFrom(accelerations_.begins());
  kernels_->stage({size_, from.x.data(), from.v.data(), h}, weights.terms(), c, x.data(), v.data());
}

StageEnd StageIntegrator::advance(const DynamicalSystem& system, const State& from, double h, State& to) {
  prepareResult(from, h, to);
  if (h != h_ || moved_) bind(h);
  const StageBase base{size_, from.x.data(), from.v.data(), h};
  const In z = from.z;
  const std::size_t count = stages(), atEnd = plan_.firstSameAsLast ? count - 1 : count;
  const bool velocities = velocities_;
  Out x = stage_[0], v = stage_[1];
  for (std::size_t i = 1; i < count; ++i) {
    if (i == atEnd) {
      x = to.x;
      v = to.v;
    }
    // A force that does not use velocities is given some all the same.
    kernels_->stage(base, sums_[i].terms(), plan_.c[i], x.data(), velocities ? v.data() : nullptr);
    const double t = from.t + plan_.c[i] * h;
    if (places_) system.place(t, z, x, v);
    system.acceleration(t, x, v, z, acceleration(i));
  }
  work_.forceEvaluations += static_cast<long long>(count) - 1;
  StageEnd end;
  const StageSum& sum = sums_.back();
  kernels_->end(base, sum.terms(), sum.estimateWeights(), sum.estimates(), tolerance_.relative * errorScale_.position,
                tolerance_.relative * errorScale_.velocity, to.x.data(), to.v.data(), end);
  system.place(to.t, z, to.x, to.v);
  return end;
}

StepResult StageIntegrator::step(const DynamicalSystem& system, const State& from, double h, State& to) {
  provideFirst(system, from);
  const StageEnd end = advance(system, from, h, to);
  endKnown_ = plan_.firstSameAsLast;
  if (endKnown_) endMark_.set(to);
  if (isFinite(end.sum)) return {.done = true, .error = combined(end), .failure = {}};
  return finiteOrFailure(system, from, to, sums_.back().estimates() > 0 ? std::nan("") : 0.0);
}

void StageIntegrator::increments(const State& from, double h, State& increment) {
  const StageTerms& terms = sums_.back().terms();
  kernels_->stage({size_, zeros_.data(), zeros_.data(), h}, terms, 0.0, stage_.data(0), increment.v.data());
  kernels_->stage({size_, zeros_.data(), from.v.data(), h}, terms, 1.0, increment.x.data(), nullptr);
}

StepResult StageIntegrator::stepIncrement(const DynamicalSystem& system, const State& from, double h,
                                          State& increment) {
  StepResult result = step(system, from, h, increment);
  increments(from, h, increment);
  return result;
}

void StageIntegrator::ensureEnd(const DynamicalSystem& system, const State& from, const State& to) {
  if (endKnown_) return;
  // With the internal variables of the step: those of `to`, and with them its moved nodes, may be the next one's.
  std::copy(to.x.begin(), to.x.end(), stage_.data(0));
  std::copy(to.v.begin(), to.v.end(), stage_.data(1));
  evaluate(system, to.t, stage_[0], stage_[1], from.z, plan_.firstSameAsLast ? stages() - 1 : stages());
  endKnown_ = true;
  endMark_.set(to);
}

}  // namespace muelle::engine
