#include "engine/integrators/explicit/engines/composition.h"

#include "engine/integrators/explicit/engines/step_finish.h"

#include <algorithm>
#include <utility>

namespace muelle::engine {

Composition::Composition(MethodInfo info, const Coefficients& fractions)
    : info_(std::move(info)), fractions_(rounded(fractions)), factors_((fractions_.size() + 1) / 2) {}

void Composition::prepare(const DynamicalSystem& system, const Tolerance&) {
  for (Kick* kick : {&kick_, &aside_}) kick->prepare(system);
  for (std::vector<double>* array : {&predicted_, &dx_, &dv_})
    array->assign(static_cast<std::size_t>(system.storage()), 0.0);
  for (DragFactors& factors : factors_) {
    factors.forget();
    if (system.drag() != nullptr) factors.update(system, 0.0);
  }
}

void Composition::kick(const State& from, double h, State& to) {
  const double* a = kick_.acceleration();
  for (std::size_t i = 0; i < dv_.size(); ++i) {
    dv_[i] += h * a[i];
    to.v[i] = from.v[i] + dv_[i];
  }
}

void Composition::kickAndDrift(const DynamicalSystem& system, const State& from, double kick, double h,
                               DragFactors& factors, State& to) {
  const double* a = kick_.acceleration();
  const std::size_t n = dx_.size();
  if (system.drag() != nullptr) {
    factors.update(system, h);
    for (std::size_t i = 0; i < n; ++i) {
      dv_[i] += kick * a[i];
      const double v = from.v[i] + dv_[i];
      dx_[i] += h * (factors.phi1(i) * v) + h * (factors.phi1(i) * lostIn(v, from.v[i], dv_[i]));
      dv_[i] += factors.loss(i) * v;
      to.x[i] = from.x[i] + dx_[i];
      to.v[i] = from.v[i] + dv_[i];
    }
  } else {
    for (std::size_t i = 0; i < n; ++i) {
      dv_[i] += kick * a[i];
      to.v[i] = from.v[i] + dv_[i];
      dx_[i] += h * to.v[i] + h * lostIn(to.v[i], from.v[i], dv_[i]);
      to.x[i] = from.x[i] + dx_[i];
    }
  }
  if (!kick_.usesVelocity()) return;
  for (std::size_t i = 0; i < n; ++i) predicted_[i] = to.v[i] + 0.5 * h * a[i];
}

StepResult Composition::step(const DynamicalSystem& system, const State& from, double h, State& to) {
  kick_.start(system, from, work_);
  prepareResult(from, h, to);
  std::fill(dx_.begin(), dx_.end(), 0.0);
  std::fill(dv_.begin(), dv_.end(), 0.0);
  const std::size_t substeps = fractions_.size();
  double t = from.t;
  double pending = 0.0;  // end of the substep before: one pass does both kicks of a velocity-free force
  for (std::size_t j = 0; j < substeps; ++j) {
    const double part = fractions_[j] * h;
    kickAndDrift(system, from, pending + 0.5 * part, part, factors_[std::min(j, substeps - 1 - j)], to);
    t += part;
    system.place(t, from.z, to.x, to.v);
    kick_.evaluate(system, t, to.x, kick_.usesVelocity() ? In(predicted_) : In(to.v), from.z, work_);
    pending = 0.5 * part;
    if (kick_.usesVelocity() && j + 1 < substeps) {
      kick(from, pending, to);
      pending = 0.0;
      kick_.evaluate(system, t, to.x, to.v, from.z, work_);
    }
  }
  kick(from, pending, to);
  system.place(to.t, from.z, to.x, to.v);
  // A force at a predicted velocity is not that of the end state: it is not kept.
  if (!kick_.usesVelocity()) kick_.finish(to);
  return finiteOrFailure(system, from, to, 0.0);
}

StepResult Composition::stepIncrement(const DynamicalSystem& system, const State& from, double h, State& increment) {
  StepResult result = step(system, from, h, increment);
  increment.x = dx_;
  increment.v = dv_;
  return result;
}

void Composition::interpolate(const DynamicalSystem& system, const State& from, const State& to, double theta,
                              State& out) {
  if (info_.order <= 4) return Integrator::interpolate(system, from, to, theta, out);
  std::swap(kick_, aside_);  // the force at the end of the step, which the next may begin with, is kept
  kick_.restart();
  step(system, from, theta * (to.t - from.t), out);
  std::swap(kick_, aside_);
}

}  // namespace muelle::engine
