#include "engine/control/event_locator.h"

#include "engine/control/closed_form.h"
#include "engine/control/step_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace muelle::engine {

namespace {

constexpr int samples = 8;
constexpr std::size_t mostSamples = 32;
constexpr int mostReorderings = 8;
constexpr double lookAhead = 1e-4;  // of a step, over which slopes are differences

int signOf(double value) { return value > 0.0 ? 1 : value < 0.0 ? -1 : 0; }

}  // namespace

EventLocator::EventLocator(const DynamicalSystem& system, Stepper& stepper)
    : system_(system), switching_(*system.switching()), stepper_(stepper) {
  const auto count = static_cast<std::size_t>(switching_.guardCount());
  side_.assign(count, 0);
  for (std::vector<double>* numbers : {&values_, &atFrom_, &atTo_, &slopeFrom_, &slopeTo_}) numbers->assign(count, 0.0);
  acceleration_.assign(static_cast<std::size_t>(system.storage()), 0.0);
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
    moveInClosedForm(state, fraction * h, uniformMotion(acceleration), inside_);
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

/// The rate of the guards at one end of the step, where they are `here`, looking into the step for a time of dt.
void EventLocator::slopes(const State& state, const std::vector<double>& here, double dt, std::vector<double>& out) {
  if (stepper_.wasInClosedForm()) {
    const LaneMotion motion = system_.laneMotion(state.z);
    for (std::size_t i = 0; i < acceleration_.size(); ++i) acceleration_[i] = motion.acceleration(state, i);
  }
  moveInClosedForm(state, dt, uniformMotion(acceleration_), inside_);
  guards(inside_);
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = (values_[i] - here[i]) / dt;
}

/// Whether guard i goes towards its zero at the step's begin and away from it at its end.
bool EventLocator::turnsBack(std::size_t i) const {
  return side_[i] * slopeFrom_[i] < 0.0 && side_[i] * slopeTo_[i] > 0.0;
}

/// Whether a guard with the same sign at both ends could be 0 in between: the cubic through values and slopes stays
/// within (|slope0| + |slope1|) h / 4 of its ends; twice that, to be safe.
bool EventLocator::mayCrossTwice(const State& from, const State& to) {
  const double h = stepLength_ = to.t - from.t;
  for (std::size_t i = 0; i < acceleration_.size(); ++i) acceleration_[i] = (to.v[i] - from.v[i]) / h;
  atFrom_ = guards(from);
  slopes(from, atFrom_, lookAhead * h, slopeFrom_);
  slopes(to, atTo_, -lookAhead * h, slopeTo_);
  for (std::size_t i = 0; i < side_.size(); ++i) {
    const double nearest = std::min(std::abs(atFrom_[i]), std::abs(atTo_[i]));
    const double reach = 0.5 * h * (std::abs(slopeFrom_[i]) + std::abs(slopeTo_[i]));
    if (turnsBack(i) && nearest <= reach) return true;
  }
  return false;
}

/// Keeps what is beyond at the end of a part of the step.
void EventLocator::seeBeyond(const State& state, const std::vector<double>& values, double low, double high) {
  scanLow_ = low;
  scanHigh_ = high;
  scanChanged_.clear();
  for (std::size_t i = 0; i < side_.size(); ++i) {
    if (isBeyond(static_cast<int>(i), values[i])) scanChanged_.push_back(static_cast<int>(i));
  }
  beyond_ = state;
}

/// When to look: evenly, and where a guard that turns back inside the step is farthest out, if it may be beyond there:
/// by the parabola through its values and slopes, which in free flight is exact for a plane.
void EventLocator::takeScanTimes() {
  scanTimes_.clear();
  for (int k = 1; k <= samples; ++k) scanTimes_.push_back(static_cast<double>(k) / samples);
  for (std::size_t i = 0; i < side_.size() && scanTimes_.size() < mostSamples; ++i) {
    if (!turnsBack(i)) continue;
    const double theta = slopeFrom_[i] / (slopeFrom_[i] - slopeTo_[i]);
    const double farthest = atFrom_[i] + 0.5 * theta * stepLength_ * slopeFrom_[i];
    if (side_[i] * farthest < 0.0) scanTimes_.push_back(theta);
  }
  std::ranges::sort(scanTimes_);
}

/// Looks for the first time at which any guard is beyond; the part of the step before it is (scanLow_, scanHigh_].
bool EventLocator::scan(const State& from, const State& to, Look look) {
  takeScanTimes();
  scanLow_ = 0.0;
  for (const double theta : scanTimes_) {
    scanHigh_ = theta;
    if (theta < 1.0) (stepper_.*look)(from, to, theta, inside_);
    const State& state = theta < 1.0 ? inside_ : to;
    guards(state);
    if (anyBeyond(values_)) {
      seeBeyond(state, values_, scanLow_, scanHigh_);
      return true;
    }
    scanLow_ = theta;
  }
  return false;
}

/// Where in (scanLow_, scanHigh_] guard i changes sign on the dense output, and how fast it goes there: regula falsi,
/// by halves where one end stays (Illinois), as a first guess needs no more.
EventLocator::Root EventLocator::denseRoot(int i, const State& from, const State& to, Look look) {
  const double side = side_[static_cast<std::size_t>(i)];
  const auto depth = [&](double theta) {  // > 0 beyond the guard
    if (theta >= 1.0) return -side * atTo_[static_cast<std::size_t>(i)];
    if (theta <= 0.0) return -side * atFrom_[static_cast<std::size_t>(i)];
    (stepper_.*look)(from, to, theta, inside_);
    return -side * guard(i, inside_);
  };
  double low = scanLow_, high = scanHigh_, depthLow = depth(low), depthHigh = depth(high);
  double slope = (depthHigh - depthLow) / (high - low), root = high, last = depthHigh;
  const double size = std::max(std::abs(depthLow), std::abs(depthHigh));
  int stays = 0;  // the end that has moved, 1 the high one
  for (int n = 0; n < 12; ++n) {
    // Where a guard begins at 0 but for rounding, as after its last event, that is not the zero that is looked for.
    const bool clear = depthLow < -1e-6 * size;
    const double next = clear ? high - depthHigh * (high - low) / (depthHigh - depthLow) : 0.5 * (low + high);
    if (!(next > low && next < high)) break;
    const double value = depth(next), moved = next - root;
    root = next;
    slope = (value - last) / moved;
    last = value;
    const int end = value > 0.0 ? 1 : -1;
    (end > 0 ? high : low) = next;
    (end > 0 ? depthHigh : depthLow) = value;
    if (end == stays) (end > 0 ? depthLow : depthHigh) *= 0.5;
    stays = end;
    if (std::abs(moved) < 1e-6) break;
  }
  return {root, slope};
}

/// Where in the step guard i, beyond at its end, is 0, by the parabola through its values and slopes, and how fast it
/// goes there: exact in free flight towards a plane.
EventLocator::Root EventLocator::parabolaRoot(std::size_t i) const {
  const double h = stepLength_, dt = lookAhead * h;
  // Slopes are differences over dt, so each is that of dt / 2 inside.
  const double curvature = (slopeTo_[i] - slopeFrom_[i]) / (h - dt);
  const double start = h * (slopeFrom_[i] - 0.5 * dt * curvature);
  const double bend = atTo_[i] - atFrom_[i] - start;  // g(theta) = at from + start theta + bend theta^2
  const double inside = start * start - 4.0 * bend * atFrom_[i];
  const double slope = side_[i] * std::sqrt(std::max(0.0, inside));  // against the side
  // Of the two forms of the root the one without cancellation: the guard first goes away from its zero, or towards it.
  const double theta = side_[i] * start > 0.0 ? -0.5 * (start + slope) / bend : 2.0 * atFrom_[i] / (slope - start);
  return {theta > 0.0 && theta < 1.0 ? theta : 0.5, std::abs(slope)};
}

/// Its first guess, in parts of the step.
EventLocator::Root EventLocator::guessOf(int i, const State& from, const State& to, Look look) {
  if (stepper_.wasInClosedForm() && scanHigh_ == 1.0) return parabolaRoot(static_cast<std::size_t>(i));
  return denseRoot(i, from, to, look);
}

EventLocator::Found EventLocator::locate(const State& from, State& to) {
  if (side_.empty()) return {};
  atTo_ = guards(to);
  const bool beyond = anyBeyond(atTo_), turns = mayCrossTwice(from, to);
  if (!beyond && !turns) return {};
  // That something is beyond at the end is sure, and a sketch tells well enough when it came there. Whether something
  // was, and came back, is for the method to say.
  const Look look = beyond ? &Stepper::sketch : &Stepper::interpolate;
  if (turns) {
    if (!scan(from, to, look)) return {};
  } else {
    seeBeyond(to, atTo_, 0.0, 1.0);
  }
  int first = scanChanged_.front();
  Root earliest{.theta = 2.0};
  for (const int i : scanChanged_) {
    const Root root = guessOf(i, from, to, look);
    if (root.theta >= earliest.theta) continue;
    earliest = root;
    first = i;
  }
  Found found = refine(first, earliest, from, to);
  // The dense output may have told their order wrongly: what is well beyond at the event was there before.
  for (int tries = 0; tries < mostReorderings && found.event; ++tries) {
    const int earlier = wellBeyond(first);
    if (earlier < 0) break;
    first = earlier;
    const auto i = static_cast<std::size_t>(earlier);
    atTo_ = values_;
    const double slope = side_[i] * (atFrom_[i] - atTo_[i]);
    found = refine(earlier, {side_[i] * atFrom_[i] / slope, slope}, from, to);
  }
  return found;
}

/// A guard but for one that is beyond at the event by more than rounding; -1: none is.
int EventLocator::wellBeyond(int but) const {
  for (const int i : crossed_) {
    const auto at = static_cast<std::size_t>(i);
    const double size = std::abs(atFrom_[at]) + std::abs(atTo_[at]);
    if (i != but && isBeyond(i, values_[at]) && std::abs(values_[at]) > 1e-9 * size) return i;
  }
  return -1;
}

/// Root of guard i over the length of a step from `from`: secant steps inside a bracket, bisection where their
/// corrections do not fall, until the length is known to rounding of the time; the result is on the far side.
EventLocator::Found EventLocator::refine(int i, const Root& guess, const State& from, State& to) {
  const double full = to.t - from.t;
  const double resolution = 0.25 * timeRounding(from.t, to.t);
  const double end = to.t;
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

  // Beyond at the end of the whole step is beyond enough; else a step to where the dense output was.
  double high = full, depthHigh = -side * atTo_[static_cast<std::size_t>(i)];
  if (!(depthHigh > 0.0)) {
    high = rounded(scanHigh_ * full);
    depthHigh = depth(high);
  }
  if (!failure.done) return {false, 0.0, failure};
  if (!(depthHigh > 0.0)) {  // seen by the dense output alone: the method itself does not reach the guard
    stepper_.step(from, full, end, to);
    return {};
  }
  double low = 0.0;
  double last = 0.0, depthLast = 0.0;  // the latest length tried, for the secant
  double correction = guess.theta * full;
  double next = rounded(correction);
  for (int n = 0; n < 100 && high - low > resolution; ++n) {
    if (!(next > low && next < high)) next = rounded(0.5 * (low + high));
    if (!(next > low && next < high)) break;
    const double value = depth(next);
    if (!failure.done) return {false, 0.0, failure};
    const double slope = n == 0 ? guess.slope / full : (value - depthLast) / (next - last);
    const double root = next - value / slope;
    last = next;
    depthLast = value;
    (value > 0.0 ? high : low) = next;
    // The next length overshoots the root by about its error, towards the end that has not moved, so that both ends
    // close in: a secant's error falls with its last correction, as that did.
    const double previous = std::exchange(correction, std::abs(root - next));
    if (value > 0.0 && correction <= 4.0 * resolution) break;
    const double overshoot = std::max(resolution, correction * std::min(0.01, 2.0 * correction / previous));
    const bool converges = correction <= 0.5 * previous;
    next = rounded(converges ? root + (value > 0.0 ? -overshoot : overshoot) : 0.5 * (low + high));
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
