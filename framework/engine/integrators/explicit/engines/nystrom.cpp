#include "engine/integrators/explicit/engines/nystrom.h"

#include <fmt/format.h>
#include <stdexcept>

namespace muelle::engine {

MethodInfo nystromInfo() {
  MethodInfo info;
  info.adaptive = true;
  info.conservesMomentum = true;
  info.needs.velocityFreeForce = true;
  info.needs.dragAside = true;
  info.realLimit = 0.0;  // no damping but drag can act on it
  info.formula =
      "x'' = A(t, x): stages of the positions alone; x+ = x + h v + h^2 sum b_i A_i, v+ = v + h sum bv_i A_i";
  info.source = "Dormand, El-Mikkawy and Prince, IMA J. Numer. Anal. 7 (1987) 423-430";
  return info;
}

void Nystrom::prepare(const DynamicalSystem& system, const Tolerance& tolerance) {
  const bool hasDrag = system.drag() != nullptr && !system.drag()->remainderUsesVelocity();
  if (system.forceUsesVelocity() && !hasDrag) {
    throw std::invalid_argument(fmt::format(
        "{} needs a force that does not depend on the velocity, drag aside: remove damping and friction, or "
        "use dop853",
        info().name));
  }
  StageIntegrator::prepare(system, tolerance);
  drag_.reset();
  if (hasDrag) drag_.emplace(tableau_()).prepare(system, tolerance);
}

void Nystrom::restart() {
  StageIntegrator::restart();
  if (drag_) drag_->restart();
}

void Nystrom::accept() {
  StageIntegrator::accept();
  if (drag_) drag_->accept();
}

StepResult Nystrom::step(const DynamicalSystem& system, const State& from, double h, State& to) {
  return drag_ ? drag_->step(system, from, h, errorScale_, to, work_) : StageIntegrator::step(system, from, h, to);
}

StepResult Nystrom::stepIncrement(const DynamicalSystem& system, const State& from, double h, State& increment) {
  if (!drag_) return StageIntegrator::stepIncrement(system, from, h, increment);
  StepResult result = drag_->step(system, from, h, errorScale_, increment, work_);
  drag_->increments(increment);
  return result;
}

void Nystrom::interpolate(const DynamicalSystem& system, const State& from, const State& to, double theta, State& out) {
  const double part = theta * (to.t - from.t);
  if (drag_) return drag_->inside(system, from, part, errorScale_, out, work_);
  // The first acceleration and the last, which the next step may begin with, are kept.
  recallFirst(system, from);
  swapAccelerations(stages() - 1, stages());
  advance(system, from, part, out);
  swapAccelerations(stages() - 1, stages());
}

}  // namespace muelle::engine
