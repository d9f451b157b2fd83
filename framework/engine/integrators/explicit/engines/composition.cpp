#include "engine/integrators/explicit/engines/composition.h"

#include "engine/integrators/explicit/engines/combination.h"

#include <utility>

namespace muelle::engine {

Composition::Composition(MethodInfo info, const Coefficients& fractions)
    : info_(std::move(info)), fractions_(rounded(fractions)), factors_((fractions_.size() + 1) / 2) {}

void Composition::prepare(const System& system, const Tolerance&) {
  kick_.prepare(system);
  predicted_.resize(static_cast<std::size_t>(system.size()));
  for (DragFactors& factors : factors_) {
    factors.forget();
    if (const Drag* drag = system.drag()) factors.update(*drag, system.mass(), 0.0);
  }
}

void Composition::kickAndDrift(const System& system, double kick, double h, DragFactors& factors, State& to) {
  const double* a = kick_.acceleration();
  const std::size_t n = to.x.size();
  const Drag* drag = system.drag();
  if (drag == nullptr) {
    for (std::size_t i = 0; i < n; ++i) {
      to.v[i] += kick * a[i];
      to.x[i] += h * to.v[i];
    }
  } else {
    factors.update(*drag, system.mass(), h);
    for (std::size_t i = 0; i < n; ++i) {
      const double v = to.v[i] + kick * a[i];
      to.x[i] += h * (factors.phi1(i) * v);
      to.v[i] = factors.decay(i) * v;
    }
  }
  if (!kick_.usesVelocity()) return;
  for (std::size_t i = 0; i < n; ++i) predicted_[i] = to.v[i] + 0.5 * h * a[i];
}

StepResult Composition::step(const System& system, const State& from, double h, State& to) {
  kick_.start(system, from, work_);
  prepareResult(from, h, to);
  to.x = from.x;
  to.v = from.v;
  double t = from.t;
  double pending = 0.0;  // end of the substep before: one pass does both kicks of a velocity-free force
  for (std::size_t j = 0; j < fractions_.size(); ++j) {
    const double part = fractions_[j] * h;
    kickAndDrift(system, pending + 0.5 * part, part, factors_[std::min(j, fractions_.size() - 1 - j)], to);
    t += part;
    kick_.evaluate(system, t, to.x, kick_.usesVelocity() ? In(predicted_) : In(to.v), from.z, work_);
    pending = 0.5 * part;
    if (kick_.usesVelocity()) {
      for (std::size_t i = 0; i < to.v.size(); ++i) to.v[i] += pending * kick_.acceleration()[i];
      pending = 0.0;
      if (j + 1 < fractions_.size()) kick_.evaluate(system, t, to.x, to.v, from.z, work_);
    }
  }
  for (std::size_t i = 0; i < to.v.size(); ++i) to.v[i] += pending * kick_.acceleration()[i];
  kick_.finish(to);
  return finiteOrFailure(system, from, to, 0.0);
}

}  // namespace muelle::engine
