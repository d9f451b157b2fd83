#include "engine/control/motion_frame.h"

#include <algorithm>
#include <cmath>

namespace muelle::engine {

namespace {

/// The mean velocity by mass, a component for each dimension.
std::vector<double> meanVelocity(const DynamicalSystem& system, const State& state) {
  const auto dimension = static_cast<std::size_t>(system.dimension());
  std::vector<double> momentum(dimension, 0.0), mass(dimension, 0.0);
  for (int i = 0; i < system.size(); ++i) {
    const std::size_t lane = laneOf(system, i), c = static_cast<std::size_t>(i) % dimension;
    momentum[c] += system.mass()[lane] * state.v[lane];
    mass[c] += system.mass()[lane];
  }
  for (std::size_t c = 0; c < dimension; ++c) momentum[c] /= mass[c];
  return momentum;
}

/// The longest side of the box around points of `dimension` numbers each.
double longestSide(const std::vector<double>& x, std::size_t dimension) {
  double longest = 0.0;
  for (std::size_t c = 0; c < dimension; ++c) {
    double least = x[c], greatest = x[c];
    for (std::size_t i = c; i < x.size(); i += dimension) {
      least = std::min(least, x[i]);
      greatest = std::max(greatest, x[i]);
    }
    longest = std::max(longest, greatest - least);
  }
  return longest;
}

/// The largest acceleration of an unknown [m/s^2]; 0 where it is not finite.
double largestAcceleration(const DynamicalSystem& system, const State& state) {
  std::vector<double> acceleration(state.x.size());
  system.acceleration(state.t, state.x, state.v, state.z, acceleration);
  double largest = 0.0;
  for (const double a : acceleration) largest = std::max(largest, std::abs(a));
  return std::isfinite(largest) ? largest : 0.0;
}

}  // namespace

MotionFrame::MotionFrame(const DynamicalSystem& system, const State& start)
    : dimension_(static_cast<std::size_t>(system.dimension())), startTime_(start.t), drift_(dimension_, 0.0) {
  system.everyNode(start, start_, v_);
  if (!system.isTied()) drift_ = meanVelocity(system, start);
  extent_ = longestSide(start_, dimension_);
}

ErrorScale MotionFrame::sizeAt(const DynamicalSystem& system, const State& state) {
  system.everyNode(state, x_, v_);
  const double passed = state.t - startTime_;
  double position = 0.0, velocity = 0.0;
  for (std::size_t node = 0; node < x_.size(); node += dimension_) {
    double y2 = 0.0, w2 = 0.0;
    for (std::size_t c = 0; c < dimension_; ++c) {
      const double y = x_[node + c] - start_[node + c] - drift_[c] * passed;
      const double w = v_[node + c] - drift_[c];
      y2 += y * y;
      w2 += w * w;
    }
    position = std::max(position, y2);
    velocity = std::max(velocity, w2);
  }
  return {std::sqrt(position), std::sqrt(velocity)};
}

MotionScale::MotionScale(const DynamicalSystem& system, const State& start, double duration)
    : frame_(system, start), duration_(duration), leastPosition_(1e-3 * frame_.extent()) {
  follow(system, start);
  if (leastPosition_ > 0.0 || largest_.velocity > 0.0) return;
  leastPosition_ = 1e-3 * largestAcceleration(system, start) * duration * duration;
  if (leastPosition_ == 0.0) leastPosition_ = 1.0;
}

void MotionScale::follow(const DynamicalSystem& system, const State& state) {
  const ErrorScale size = frame_.sizeAt(system, state);
  largest_.position = std::max(largest_.position, size.position);
  largest_.velocity = std::max(largest_.velocity, size.velocity);
}

ErrorScale MotionScale::scale() const {
  // One node in flight has no extent: it begins with a thousandth of the way that its speed would take it.
  const double floor = std::max(leastPosition_, leastPosition_ == 0.0 ? 1e-3 * largest_.velocity * duration_ : 0.0);
  const double position = std::max(largest_.position, floor);
  return {position, std::max(largest_.velocity, position / duration_)};
}

}  // namespace muelle::engine
