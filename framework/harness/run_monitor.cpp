#include "harness/run_monitor.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <utility>

namespace muelle {

namespace {

/// First entry that is not finite, or the size.
std::size_t firstNotFinite(const std::vector<double>& values) {
  const auto bad = std::find_if_not(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
  return static_cast<std::size_t>(bad - values.begin());
}

/// [J], by eight sums side by side: in one, each addition would wait for the last.
double kineticEnergyOf(std::span<const double> mass, const std::vector<double>& v) {
  constexpr std::size_t width = 8;
  double sums[width] = {};
  std::size_t i = 0;
  for (; i + width <= mass.size(); i += width) {
    for (std::size_t k = 0; k < width; ++k) sums[k] += mass[i + k] * (v[i + k] * v[i + k]);
  }
  double sum = 0.0;
  for (const double part : sums) sum += part;
  for (; i < mass.size(); ++i) sum += mass[i] * (v[i] * v[i]);
  return 0.5 * sum;
}

/// 3 when the masses come in triples of equal numbers: the three coordinates of a node share its mass.
int guessDimension(std::span<const double> mass) {
  if (mass.size() % 3 != 0) return 1;
  for (std::size_t i = 0; i < mass.size(); i += 3) {
    if (mass[i] != mass[i + 1] || mass[i] != mass[i + 2]) return 1;
  }
  return 3;
}

std::string nodeName(std::size_t unknown, std::size_t dimension) {
  if (dimension == 1) return fmt::format("node {}", unknown);
  return fmt::format("node {} ({})", unknown / dimension, "xyz"[unknown % dimension]);
}

}  // namespace

RunMonitor::RunMonitor(const DynamicalSystem& system, double explosion, double duration, int dimension)
    : RunMonitor(system, explosion, duration,
                 [d = static_cast<std::size_t>(dimension > 0 ? dimension : guessDimension(system.mass()))](
                     std::size_t unknown) { return nodeName(unknown, d); }) {}

RunMonitor::RunMonitor(const DynamicalSystem& system, double explosion, double duration,
                       std::function<std::string(std::size_t unknown)> name,
                       std::function<double(const State&)> potentialEnergy)
    : system_(system),
      potentialEnergy_(std::move(potentialEnergy)),
      explosion_(explosion),
      duration_(duration),
      name_(std::move(name)),
      force_(system.mass().size(), 0.0) {}

StopReport RunMonitor::checkStart(const State& start) {
  const std::size_t badVelocity = firstNotFinite(start.v);
  if (badVelocity < start.v.size()) return notFinite(start.t, badVelocity, "velocity");
  const std::size_t badPosition = firstNotFinite(start.x);
  if (badPosition < start.x.size()) return notFinite(start.t, badPosition, "position");
  const StopReport report = checkForce(start);
  if (report.stopped) return report;

  const std::span<const double> mass = system_.mass();
  double totalMass = 0.0;
  double reachable = 0.0;
  for (std::size_t i = 0; i < force_.size(); ++i) {
    if (mass[i] == 0.0) continue;  // held
    const double speed = std::abs(start.v[i]) + std::abs(force_[i]) * duration_ / mass[i];
    totalMass += mass[i];
    reachable += 0.5 * mass[i] * speed * speed;
  }
  constexpr double walkingPace = 1.0;  // [m/s]
  energyScale_ = std::max(0.5 * totalMass * walkingPace * walkingPace, reachable);
  return {};
}

StopReport RunMonitor::checkStep(const State& before, const State& after) {
  const StopReport report = checkFinite(before, after);
  return report.stopped ? report : checkEnergy(before, after);
}

StopReport RunMonitor::checkEnergy(const State& before, const State& after) {
  double energy = kineticEnergyOf(system_.mass(), after.v);
  if (!std::isfinite(energy)) {
    const StopReport report = checkFinite(before, after);
    if (report.stopped) return report;
  }
  // Just beyond its limit velocity Verlet carries nearly all in the springs; asked for only when the rest is large,
  // too.
  constexpr double suspicious = 1e-3;
  if (potentialEnergy_ && energy > suspicious * explosion_ * energyScale_) energy += std::abs(potentialEnergy_(after));
  if (energy > explosion_ * energyScale_) return exploded(after, energy);
  return {};
}

StopReport RunMonitor::checkFinite(const State& before, const State& after) {
  const std::size_t badPosition = firstNotFinite(after.x);
  const std::size_t badVelocity = firstNotFinite(after.v);
  if (badPosition == after.x.size() && badVelocity == after.v.size()) return {};
  // A force that is not finite spoils velocity and position within the step: name the cause, not the effect.
  const StopReport cause = checkForce(before);
  if (cause.stopped) return cause;
  if (badPosition < after.x.size()) return notFinite(after.t, badPosition, "position");
  return notFinite(after.t, badVelocity, "velocity");
}

StopReport RunMonitor::checkForce(const State& state) {
  std::fill(force_.begin(), force_.end(), 0.0);
  system_.force(state.t, state.x, state.v, state.z, force_);
  const std::size_t bad = firstNotFinite(force_);
  if (bad < force_.size()) return notFinite(state.t, bad, "force");
  return {};
}

StopReport RunMonitor::notFinite(double t, std::size_t unknown, const char* what) const {
  return {true, t, static_cast<int>(unknown),
          fmt::format("t = {:.6g} s, {}: the {} is not finite", t, name_(unknown), what)};
}

StopReport RunMonitor::exploded(const State& state, double energy) const {
  std::size_t unknown = 0;
  for (std::size_t i = 0; i < state.v.size(); ++i) {
    if (system_.mass()[i] > 0.0 && std::abs(state.v[i]) > std::abs(state.v[unknown])) unknown = i;
  }
  return {true, state.t, static_cast<int>(unknown),
          fmt::format("t = {:.6g} s, {}: the energy explodes (velocity {:.3g} m/s, {} energy {:.3g} J, more than "
                      "{:.3g} times its natural scale of {:.3g} J); look for a force with the wrong sign or a step too "
                      "long for the stiffness",
                      state.t, name_(unknown), state.v[unknown], potentialEnergy_ ? "kinetic and potential" : "kinetic",
                      energy, explosion_, energyScale_)};
}

}  // namespace muelle
