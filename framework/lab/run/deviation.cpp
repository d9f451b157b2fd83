#include "lab/run/deviation.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace muelle::lab {

namespace {

/// Largest norm over the nodes of what `component` gives for each unknown.
template <class Component>
double largestNode(std::size_t unknowns, int dimension, Component component) {
  double largest = 0.0;
  const auto width = static_cast<std::size_t>(dimension);
  for (std::size_t node = 0; node < unknowns; node += width) {
    double square = 0.0;
    for (std::size_t i = node; i < std::min(node + width, unknowns); ++i) square += std::pow(component(i), 2);
    largest = std::max(largest, std::sqrt(square));
  }
  return largest;
}

Relative over(double distance, double scale) {
  return scale > 0.0 ? Relative{distance / scale} : Relative{distance, false};
}

void requireSameTimes(const Trajectory& run, const Trajectory& other) {
  if (run.t.size() == other.t.size()) return;
  throw std::invalid_argument(fmt::format("the runs have {} and {} outputs", run.t.size(), other.t.size()));
}

}  // namespace

bool isTied(const engine::Model& model) {
  const auto holds = [](const engine::ModelNode& node) { return node.pinned || node.motion >= 0 || node.drag != 0.0; };
  return std::ranges::any_of(model.nodes, holds) || !model.obstacles.empty() || !model.properties.empty();
}

MotionFrame frameOf(const engine::ModelSystem& system, const State& start) {
  MotionFrame frame{start, std::vector<double>(start.x.size(), 0.0), system.dimension()};
  if (isTied(system.model())) return frame;
  const auto width = static_cast<std::size_t>(frame.dimension);
  std::vector<double> momentum(width, 0.0);
  std::vector<double> mass(width, 0.0);
  for (std::size_t i = 0; i < start.v.size(); ++i) {
    momentum[i % width] += system.mass()[i] * start.v[i];
    mass[i % width] += system.mass()[i];
  }
  for (std::size_t i = 0; i < start.v.size(); ++i) frame.drift[i] = momentum[i % width] / mass[i % width];
  return frame;
}

Relative Deviation::larger() const {
  if (position.isRelative != velocity.isRelative) return position.isRelative ? position : velocity;
  return position.value >= velocity.value ? position : velocity;
}

Deviation deviation(const Trajectory& run, const Trajectory& other, const MotionFrame& frame) {
  requireSameTimes(run, other);
  const std::size_t unknowns = frame.start.x.size();
  double distance = 0.0, moved = 0.0, difference = 0.0, speed = 0.0, place = 0.0;
  for (std::size_t row = 0; row < other.t.size(); ++row) {
    const auto largest = [&](auto component) { return largestNode(unknowns, frame.dimension, component); };
    const double t = other.t[row] - frame.start.t;
    const std::vector<double>&x = other.x[row], &v = other.v[row];
    distance = std::max(distance, largest([&](std::size_t i) { return run.x[row][i] - x[i]; }));
    difference = std::max(difference, largest([&](std::size_t i) { return run.v[row][i] - v[i]; }));
    moved = std::max(moved, largest([&](std::size_t i) { return x[i] - frame.start.x[i] - frame.drift[i] * t; }));
    speed = std::max(speed, largest([&](std::size_t i) { return v[i] - frame.drift[i]; }));
    place = std::max(place, largest([&](std::size_t i) { return x[i]; }));
  }
  const double unit = std::numeric_limits<double>::epsilon() * place;
  // A motion within the rounding of positions is none that could be told from rest.
  const double scale = moved > 4.0 * unit ? moved : 0.0;
  return {over(distance, scale), over(difference, speed), over(unit, scale).value};
}

Relative deviation(const Trajectory& run, const Trajectory& other, std::size_t track, double rate) {
  requireSameTimes(run, other);
  const std::vector<double>& values = other.tracks[track].values;
  double difference = 0.0, moved = 0.0;
  for (std::size_t row = 0; row < values.size(); ++row) {
    difference = std::max(difference, std::abs(run.tracks[track].values[row] - values[row]));
    moved = std::max(moved, std::abs(values[row] - values.front() - rate * (other.t[row] - other.t.front())));
  }
  return over(difference, moved);
}

}  // namespace muelle::lab
