#include "tools.h"

namespace muelle::plots {

namespace {

/// Hard case H07 with equal masses: two nodes of 1.5 kg on a spring, turning at 4 /s in equilibrium.
engine::Model pair() {
  engine::Model model;
  model.nodes.resize(2);
  for (const int side : {0, 1}) {
    const double sign = side == 0 ? 1.0 : -1.0;
    engine::ModelNode& node = model.nodes[static_cast<std::size_t>(side)];
    node.m = 1.5;
    node.x = {0.525 * sign, 0.0, 0.0};
    node.v = {0.0, 2.1 * sign, 0.0};
  }
  model.springs.push_back({.a = 0, .b = 1, .k = 252.0, .L0 = 1.0});
  return model;
}

}  // namespace

/// Slide "Amortiguamiento": which damping leaves a rigid motion alone.
Figure damping_rotating_pair() {
  Figure figure("damping_rotating_pair", "Only projected damping lets a turning pair turn", "time [s]");
  figure.slide(2);
  engine::Model node = pair(), relative = pair(), projected = pair();
  for (auto& n : node.nodes) n.drag = 0.6;
  relative.springs[0].dRelative = 0.3;
  projected.springs[0].dProjected = 0.3;
  auto turning = figure.panel("angular momentum [kg m^2/s]");
  turning.heading("how much it still turns");
  auto paths = figure.panel("y [m]");
  paths.heading("path of one node").xLabel("x [m]").equalAxes();
  const struct {
    const engine::Model& model;
    const char* name;
  } variants[] = {{node, "node"}, {relative, "relative"}, {projected, "projected"}};
  for (const auto& [model, name] : variants) {
    const auto system = engine::build(model);
    const engine::RunResult result = run(*system, "runge_kutta_4", 1e-3, 5.0, 0.01);
    const Trajectory& trajectory = result.trajectory;
    turning.line(name, trajectory.t, along(trajectory, [&](const State& s) { return system->angularMomentum(s).z(); }));
    paths.line("", along(trajectory, [&](const State& s) { return system->position(s, 0).x(); }),
               along(trajectory, [&](const State& s) { return system->position(s, 0).y(); }));
  }
  turning.yRange(0.0, 3.6);
  turning.note(1.35, 2.7, "node and relative: the same decay");
  return figure;
}

}  // namespace muelle::plots
