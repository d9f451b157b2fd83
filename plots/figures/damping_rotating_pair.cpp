#include "tools.h"

namespace muelle::plots::damping_rotating_pair {

namespace {

/// Hard case H07 with equal masses: two nodes of 1.5 kg on a spring, turning at 4 /s in equilibrium, and drifting.
engine::Model pair() {
  engine::Model model;
  model.dimension = 2;
  model.plane = {0, 1};
  model.nodes.resize(2);
  for (const int side : {0, 1}) {
    const double sign = side == 0 ? 1.0 : -1.0;
    engine::ModelNode& node = model.nodes[static_cast<std::size_t>(side)];
    node.m = 1.5;
    node.x = {0.525 * sign, 0.0, 0.0};
    node.v = {1.0, 2.1 * sign, 0.0};
  }
  model.springs.push_back({.a = 0, .b = 1, .k = 252.0, .L0 = 1.0});
  return model;
}

/// A measure of each output [% of the first].
std::vector<double> percent(const Trajectory& path, const std::function<double(const State&)>& measure) {
  std::vector<double> values = along(path, measure);
  const double first = values.front();
  for (double& value : values) value *= 100.0 / first;
  return values;
}

}  // namespace

/// Slide "Amortiguamiento": what each of the three dampings takes from a rigid motion, with the same d.
Figure damping_rotating_pair() {
  constexpr double d = 0.3, duration = 5.0;
  Figure figure("damping_rotating_pair",
                "Only projected damping takes nothing from a rigid motion: the pair turns and drifts on", "time [s]");
  figure.slide(2);
  engine::Model node = pair(), relative = pair(), projected = pair();
  for (auto& n : node.nodes) n.drag = d;
  relative.springs[0].dRelative = d;
  projected.springs[0].dProjected = d;
  auto turning = figure.panel("angular momentum [%]");
  turning.heading("a pair turns: m = 1.5 kg, d = 0.3 kg/s").yRange(0, 110);
  auto drifting = figure.panel("momentum [%]");
  drifting.heading("and drifts").yRange(0, 110);
  const auto add = [&](const engine::Model& model) {
    const auto system = engine::build(model);
    const Trajectory path = run(*system, "runge_kutta_4", 1e-3, duration, 0.01).trajectory;
    turning.line("", path.t, percent(path, [&](const State& s) { return system->angularMomentum(s).z(); }));
    drifting.line("", path.t, percent(path, [&](const State& s) { return system->momentum(s).x(); }));
  };
  add(node);
  turning.nameAt(1.9, 74, "at the nodes: exp(−dt/m)");
  drifting.nameAt(1.9, 74, "at the nodes: exp(−dt/m)");
  add(relative);
  turning.nameAt(0.3, 25, "relative: exp(−2dt/m)");
  add(projected);
  turning.nameAt(1.5, 105, "projected");
  drifting.note(1.5, 105, "relative and projected");
  return figure;
}

}  // namespace muelle::plots::damping_rotating_pair
