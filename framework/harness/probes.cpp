#include "harness/probes.h"

#include "harness/function_system.h"

#include <fmt/format.h>
#include <stdexcept>
#include <utility>

namespace muelle {

namespace {

void requireSpace(const DynamicalSystem& system, int axis, const char* probe) {
  if (axis < 0 || axis > 2) throw std::invalid_argument(fmt::format("{}: axis {} is not 0, 1 or 2", probe, axis));
  if (system.size() % 3 != 0) {
    throw std::invalid_argument(
        fmt::format("{}: needs a 3D system, three degrees of freedom a node; this one has {}", probe, system.size()));
  }
}

std::string withAxis(const char* quantity, int axis) { return fmt::format("{} {}", quantity, "xyz"[axis]); }

/// Momentum m v of node i; the three masses of a node are equal.
Vec3 nodeMomentum(std::span<const double> mass, const State& state, int i) {
  return mass[static_cast<std::size_t>(3 * i)] * node3(In(state.v), i);
}

}  // namespace

Probe kineticEnergy(const DynamicalSystem& system) {
  return {"kinetic energy", "J", [&system](const State& state) {
            const std::span<const double> mass = system.mass();
            double energy = 0.0;
            for (std::size_t i = 0; i < mass.size(); ++i) energy += 0.5 * mass[i] * state.v[i] * state.v[i];
            return energy;
          }};
}

Probe linearMomentum(const DynamicalSystem& system, int axis) {
  requireSpace(system, axis, "linearMomentum");
  return {withAxis("linear momentum", axis), "kg m/s", [&system, axis](const State& state) {
            double momentum = 0.0;
            for (int i = 0; i < system.size() / 3; ++i) momentum += nodeMomentum(system.mass(), state, i)[axis];
            return momentum;
          }};
}

Probe angularMomentum(const DynamicalSystem& system, int axis) {
  requireSpace(system, axis, "angularMomentum");
  return {withAxis("angular momentum", axis), "kg m^2/s", [&system, axis](const State& state) {
            // Components of the cross product written out: the other two axes in cyclic order.
            const int j = (axis + 1) % 3;
            const int k = (axis + 2) % 3;
            double momentum = 0.0;
            for (int i = 0; i < system.size() / 3; ++i) {
              const Vec3 x = node3(In(state.x), i);
              const Vec3 p = nodeMomentum(system.mass(), state, i);
              momentum += x[j] * p[k] - x[k] * p[j];
            }
            return momentum;
          }};
}

Probe sum(std::string name, std::vector<Probe> terms) {
  if (terms.empty()) throw std::invalid_argument("sum: no probes to add for '" + name + "'");
  const std::string unit = terms.front().unit;
  for (const Probe& term : terms) {
    if (term.unit == unit) continue;
    throw std::invalid_argument(
        fmt::format("sum '{}': '{}' is in {} but '{}' is in {}", name, terms.front().name, unit, term.name, term.unit));
  }
  return {std::move(name), unit, [terms = std::move(terms)](const State& state) {
            double total = 0.0;
            for (const Probe& term : terms) total += term.measure(state);
            return total;
          }};
}

}  // namespace muelle
