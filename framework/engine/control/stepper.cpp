#include "engine/control/stepper.h"

#include "engine/control/closed_form.h"
#include "engine/integrators/explicit/engines/step_finish.h"

#include <algorithm>
#include <utility>

namespace muelle::engine {

namespace {

/// values[i] holds an increment on entry and from[i] + lowBefore[i] + increment, rounded, at the end; lowAfter[i] is
/// what the rounding lost.
void addCompensated(const std::vector<double>& from, const std::vector<double>& lowBefore, std::vector<double>& values,
                    std::vector<double>& lowAfter) {
  for (std::size_t i = 0; i < from.size(); ++i) {
    const double addend = values[i] + lowBefore[i];
    const double sum = from[i] + addend;
    const double part = sum - from[i];
    lowAfter[i] = (from[i] - (sum - part)) + (addend - part);
    values[i] = sum;
  }
}

}  // namespace

Stepper::Stepper(const DynamicalSystem& system, Integrator& method, bool compensated, bool mayUseClosedForm,
                 std::size_t size)
    : system_(system), method_(method), compensated_(compensated), mayUseClosedForm_(mayUseClosedForm) {
  if (!compensated) return;
  for (Low* low : {&low_, &nextLow_}) {
    low->x.assign(size, 0.0);
    low->v.assign(size, 0.0);
  }
}

/// The state at the end of the step; compensated: the increments to it.
StepResult Stepper::advance(const State& from, double h, State& to) {
  if (!inClosedForm_)
    return compensated_ ? method_.stepIncrement(system_, from, h, to) : method_.step(system_, from, h, to);
  (compensated_ ? closedFormIncrement : moveInClosedForm)(from, h, system_.laneMotion(from.z), to);
  const bool finite = firstNotFinite(to.x) < 0 && firstNotFinite(to.v) < 0;
  return {.done = finite, .error = 0.0, .failure = finite ? "" : "the motion leads beyond all numbers"};
}

StepResult Stepper::step(const State& from, double h, double t, State& to) {
  if (compensated_) {
    to.x = low_.x;
    to.v = low_.v;
  }
  inClosedForm_ = closedForm(from).exists();
  StepResult result = advance(from, h, to);
  if (compensated_ && result.done) {
    addCompensated(from.x, low_.x, to.x, nextLow_.x);
    addCompensated(from.v, low_.v, to.v, nextLow_.v);
    to.z = from.z;
  }
  to.t = t;
  if (result.done) system_.place(t, to.z, to.x, to.v);
  return result;
}

void Stepper::interpolate(const State& from, const State& to, double theta, State& out) {
  if (inClosedForm_) {
    moveInClosedForm(from, theta * (to.t - from.t), system_.laneMotion(from.z), out);
  } else {
    method_.interpolate(system_, from, to, theta, out);
  }
  system_.place(out.t, out.z, out.x, out.v);
}

void Stepper::sketch(const State& from, const State& to, double theta, State& out) {
  if (inClosedForm_) return interpolate(from, to, theta, out);
  method_.sketch(system_, from, to, theta, out);
  system_.place(out.t, out.z, out.x, out.v);
}

void Stepper::forget() {
  std::ranges::fill(low_.x, 0.0);
  std::ranges::fill(low_.v, 0.0);
}

void Stepper::accept() {
  std::swap(low_, nextLow_);
  if (!inClosedForm_) method_.accept();
}

}  // namespace muelle::engine
