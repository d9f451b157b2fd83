#include "engine/scene/scene.h"

#include <algorithm>

namespace muelle::engine {

namespace {

/// Least (sign -1) or greatest (+1) component of the nodes.
double extreme(const ModelSystem& system, const State& state, const SceneOutput& output, double sign) {
  double best = -std::numeric_limits<double>::infinity();
  for (const int node : output.nodes) best = std::max(best, sign * system.position(state, node)[output.axis]);
  return sign * best;
}

double mean(const ModelSystem& system, const State& state, const SceneOutput& output) {
  double sum = 0.0;
  for (const int node : output.nodes) sum += system.position(state, node)[output.axis];
  return sum / static_cast<double>(output.nodes.size());
}

double measure(const ModelSystem& system, const State& state, const SceneOutput& output) {
  switch (output.kind) {
    case SceneOutput::Kind::Position:
      return system.position(state, output.nodes[0])[output.axis];
    case SceneOutput::Kind::Velocity:
      return system.velocity(state, output.nodes[0])[output.axis];
    case SceneOutput::Kind::MeanPosition:
      return mean(system, state, output);
    case SceneOutput::Kind::Lowest:
      return extreme(system, state, output, -1.0);
    case SceneOutput::Kind::Highest:
      return extreme(system, state, output, 1.0);
    case SceneOutput::Kind::Distance:
      return (system.position(state, output.nodes[0]) - system.position(state, output.nodes[1])).norm();
    case SceneOutput::Kind::Path:
      break;
  }
  return 0.0;
}

}  // namespace

std::vector<Probe> probesOf(const Scene& scene, const ModelSystem& system) {
  std::vector<Probe> probes = {
      {"kinetic energy", "J", [&system](const State& state) { return system.kineticEnergy(state); }},
      {"potential energy", "J",
       [&system](const State& state) { return system.totalEnergy(state) - system.kineticEnergy(state); }},
      {"total energy", "J", [&system](const State& state) { return system.totalEnergy(state); }}};
  for (const SceneOutput& output : scene.outputs) {
    if (output.kind == SceneOutput::Kind::Path) continue;
    const char* unit = output.kind == SceneOutput::Kind::Velocity ? "m/s" : "m";
    probes.push_back({output.name, unit, [&system, output](const State& s) { return measure(system, s, output); }});
  }
  return probes;
}

}  // namespace muelle::engine
