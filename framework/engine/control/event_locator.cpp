#include "engine/control/event_locator.h"

#include "engine/control/step_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace muelle::engine {

namespace {

constexpr int samples = 8;

int signOf(double value) { return value > 0.0 ? 1 : value < 0.0 ? -1 : 0; }

void moveAlong(const State& state, double dt, const std::vector<double>& acceleration, State& out) {
  out = state;
  out.t += dt;
  for (std::size_t i = 0; i < state.x.size(); ++i) {
    out.x[i] += dt * (state.v[i] + 0.5 * dt * acceleration[i]);
    out.v[i] += dt * acceleration[i];
  }
}

}  // namespace

EventLocator::EventLocator(const DynamicalSystem& system, Integrator& method, Stepper& stepper)
    : system_(system), switching_(*system.switching()), method_(method), stepper_(stepper) {
  const auto count = static_cast<std::size_t>(switching_.guardCount());
  side_.assign(count, 0);
  for (std::vector<double>* numbers : {&values_, &atFrom_, &atTo_, &slopeFrom_, &slopeTo_}) numbers->assign(count, 0.0);
}

/// The state inside the step from `from` to `to`, in inside_.
void EventLocator::look(const State& from, const State& to, double theta) {
  method_.interpolate(system_, from, to, theta, inside_);
  system_.place(inside_.t, inside_.z, inside_.x, inside_.v);
}

const std::vector<double>& EventLocator::guards(const State& state) {
  switching_.guards(state.t, state.x, state.v, state.z, values_);
  return values_;
}

double EventLocator::guard(int i, const State& state) { return guards(state)[static_cast<std::size_t>(i)]; }

bool EventLocator::isBeyond(int i, double value) const {
  const int side = side_[static_cast<std::size_t>(i)];
  return side != 0 && signOf(value) == -side;
}

bool EventLocator::anyBeyond(const std::vector<double>& values) const {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (isBeyond(static_cast<int>(i), values[i])) return true;
  }
  return false;
}

void EventLocator::start(State& state, double h) {
  if (side_.empty()) return;
  std::vector<double> acceleration(state.x.size());
  system_.acceleration(state.t, state.x, state.v, state.z, acceleration);
  const auto isZero = [](double value) { return value == 0.0; };
  guards(state);
  for (const double fraction : {1e-9, 1e-6, 1e-3}) {
    if (std::none_of(values_.begin(), values_.end(), isZero)) break;
    moveAlong(state, fraction * h, acceleration, inside_);
    system_.place(inside_.t, inside_.z, inside_.x, inside_.v);
    switching_.commit(inside_, false);  // live, so that the modes are decided anew
    switching_.commit(inside_, true);
    guards(inside_);
    if (std::none_of(values_.begin(), values_.end(), isZero)) state.z = inside_.z;
  }
  for (std::size_t i = 0; i < side_.size(); ++i) side_[i] = signOf(values_[i]);
  crossed_.clear();
}

void EventLocator::settle(const State& state) {
  if (side_.empty()) return;
  atTo_ = guards(state);
  if (!crossed_.empty()) {
    beyond_.z = state.z;
    guards(beyond_);
  }
  for (std::size_t i = 0; i < side_.size(); ++i) {
    const bool crossedNow = std::find(crossed_.begin(), crossed_.end(), static_cast<int>(i)) != crossed_.end();
    // Right after its event a guard is 0 but for rounding, unless the event has redefined it.
    const bool isRounding = crossedNow && std::abs(atTo_[i]) <= 1e-6 * std::abs(values_[i]);
    const int side = signOf(isRounding ? values_[i] : atTo_[i]);
    if (side != 0) side_[i] = side;
  }
  crossed_.clear();
}

/// The rate of the guards at one end of the step, looking into the step (sign +1 at its begin, -1 at its end).
void EventLocator::slopes(const State& state, const State& from, const State& to, double sign,
                          std::vector<double>& out) {
  const double h = to.t - from.t;
  const double dt = sign * 1e-4 * h;
  inside_ = state;
  inside_.t += dt;
  for (std::size_t i = 0; i < state.x.size(); ++i) {
    const double a = (to.v[i] - from.v[i]) / h;
    inside_.x[i] += dt * (state.v[i] + 0.5 * dt * a);
    inside_.v[i] += dt * a;
  }
  const std::vector<double> here = guards(state);
  guards(inside_);
  for (std::size_t i = 0; i < here.size(); ++i) out[i] = (values_[i] - here[i]) / dt;
}

/// Whether a guard with the same sign at both ends could be 0 in between: the cubic through values and slopes stays
/// within (|slope0| + |slope1|) h / 4 of its ends; twice that, to be safe.
bool EventLocator::mayCrossTwice(const State& from, const State& to) {
  const double h = to.t - from.t;
  atFrom_ = guards(from);
  slopes(from, from, to, 1.0, slopeFrom_);
  slopes(to, from, to, -1.0, slopeTo_);
  for (std::size_t i = 0; i < side_.size(); ++i) {
    const double nearest = std::min(std::abs(atFrom_[i]), std::abs(atTo_[i]));
    const bool towards = side_[i] * slopeFrom_[i] < 0.0 && side_[i] * slopeTo_[i] > 0.0;
    if (towards && nearest <= 0.5 * h * (std::abs(slopeFrom_[i]) + std::abs(slopeTo_[i]))) return true;
  }
  return false;
}

bool EventLocator::scan(const State& from, const State& to) {
  scanLow_ = 0.0;
  for (int k = 1; k <= samples; ++k) {
    scanHigh_ = static_cast<double>(k) / samples;
    if (k < samples) look(from, to, scanHigh_);
    const State& state = k < samples ? inside_ : to;
    guards(state);
    if (anyBeyond(values_)) {
      scanChanged_.clear();
      for (std::size_t i = 0; i < side_.size(); ++i) {
        if (isBeyond(static_cast<int>(i), values_[i])) scanChanged_.push_back(static_cast<int>(i));
      }
      beyond_ = state;
      return true;
    }
    scanLow_ = scanHigh_;
  }
  return false;
}

/// Where in (low, high] guard i changes sign on the dense output: bisection, as a first guess needs no more.
double EventLocator::denseRoot(int i, const State& from, const State& to, double low, double high) {
  for (int n = 0; n < 20; ++n) {
    const double middle = 0.5 * (low + high);
    look(from, to, middle);
    (isBeyond(i, guard(i, inside_)) ? high : low) = middle;
  }
  return high;
}

EventLocator::Found EventLocator::locate(const State& from, State& to) {
  if (side_.empty()) return {};
  atTo_ = guards(to);
  if (!anyBeyond(atTo_) && !mayCrossTwice(from, to)) return {};
  if (!scan(from, to)) return {};
  int first = scanChanged_.front();
  double theta = 2.0;
  for (const int i : scanChanged_) {
    const double root = denseRoot(i, from, to, scanLow_, scanHigh_);
    if (root >= theta) continue;
    theta = root;
    first = i;
  }
  return refine(first, theta, from, to);
}

/// Root of guard i over the length of a step from `from`: secant steps inside a bracket, bisection where they do not
/// shrink it, until the length is known to rounding; the result is the end of the bracket on the far side.
EventLocator::Found EventLocator::refine(int i, double guess, const State& from, State& to) {
  const double full = to.t - from.t;
  const double resolution = 0.25 * timeRounding(from.t, to.t);
  const State whole = to;
  const double side = side_[static_cast<std::size_t>(i)];
  StepResult failure;
  double taken = full;                     // length of the stepper's last step
  const auto depth = [&](double length) {  // > 0 beyond the guard
    const StepResult result = stepper_.step(from, length, from.t + length, to);
    if (!result.done) failure = result;
    taken = length;
    return result.done ? -side * guard(i, to) : std::numeric_limits<double>::quiet_NaN();
  };
  const auto rounded = [&](double length) { return (from.t + length) - from.t; };

  double high = rounded(scanHigh_ * full);
  double depthHigh = high < full ? depth(high) : -side * atTo_[static_cast<std::size_t>(i)];
  if (high < full && !(depthHigh > 0.0) && isBeyond(i, atTo_[static_cast<std::size_t>(i)])) {
    high = full;
    depthHigh = -side * atTo_[static_cast<std::size_t>(i)];
  }
  if (!failure.done) return {false, 0.0, failure};
  if (!(depthHigh > 0.0)) {  // seen by the dense output alone: the method itself does not reach the guard
    stepper_.step(from, full, whole.t, to);
    return {};
  }
  double low = 0.0;
  double last = high;  // the latest length tried, for the secant
  double depthLast = depthHigh;
  double next = rounded(guess * full);
  for (int n = 0; n < 100 && high - low > resolution; ++n) {
    if (!(next > low && next < high)) next = rounded(0.5 * (low + high));
    if (!(next > low && next < high)) break;
    const double before = high - low;
    const double value = depth(next);
    if (!failure.done) return {false, 0.0, failure};
    const double root = next - value * (next - last) / (value - depthLast);
    last = next;
    depthLast = value;
    (value > 0.0 ? high : low) = next;
    // The next length overshoots the root by a little, towards the end that has not moved, so that both ends close in.
    const double overshoot = std::max(resolution, 0.01 * std::abs(root - next));
    const bool shrinks = n < 2 || high - low <= 0.5 * before;
    next = rounded(shrinks ? root + (value > 0.0 ? -overshoot : overshoot) : 0.5 * (low + high));
  }
  if (high <= resolution) {
    to = from;
    high = 0.0;
  } else if (taken != high) {
    depth(high);
    if (!failure.done) return {false, 0.0, failure};
  }
  guards(to);
  crossed_.clear();
  for (std::size_t j = 0; j < side_.size(); ++j) {
    if (static_cast<int>(j) == i || isBeyond(static_cast<int>(j), values_[j])) crossed_.push_back(static_cast<int>(j));
  }
  return {true, high, {}};
}

}  // namespace muelle::engine
