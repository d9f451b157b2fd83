#include "tools.h"

namespace muelle::plots {

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

}  // namespace

/// Slide "Amortiguamiento": what each of the three dampings takes from a rigid motion.
Figure damping_rotating_pair() {
  Figure figure("damping_rotating_pair", "Only projected damping leaves a rigid motion alone", "time [s]");
  figure.slide(2);
  engine::Model node = pair(), relative = pair(), projected = pair();
  for (auto& n : node.nodes) n.drag = 0.6;
  relative.springs[0].dRelative = 0.3;
  projected.springs[0].dProjected = 0.3;
  auto turning = figure.panel("angular momentum [kg m²/s]");
  turning.heading("a pair on a spring turns").yRange(0.0, 4.0);
  auto drifting = figure.panel("momentum [kg m/s]");
  drifting.heading("and drifts").yRange(0.0, 4.0);
  for (const engine::Model* model : {&node, &relative, &projected}) {
    const auto system = engine::build(*model);
    const Trajectory trajectory = run(*system, "runge_kutta_4", 1e-3, 5.0, 0.01).trajectory;
    turning.line("", trajectory.t, along(trajectory, [&](const State& s) { return system->angularMomentum(s).z(); }));
    drifting.line("", trajectory.t, along(trajectory, [&](const State& s) { return system->momentum(s).x(); }));
  }
  turning.note(1.6, 2.2, "node and relative").note(2.0, 3.5, "projected");
  drifting.note(1.6, 2.0, "node").note(1.6, 3.2, "relative and projected");
  return figure;
}

}  // namespace muelle::plots
