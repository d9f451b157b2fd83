#include "engine/integrators/catalogue.h"
#include "tools.h"

namespace muelle::plots::tunnelling {

namespace {

/// Hard case H19: a node of 1 kg at 100 m/s against a wall 1 cm thick.
engine::Model shot() {
  engine::Model model;
  model.dimension = 1;
  model.nodes.resize(1);
  model.nodes[0].x[0] = -1.0;
  model.nodes[0].v[0] = 100.0;
  engine::Obstacle wall;
  wall.kind = engine::Obstacle::Kind::Box;
  wall.name = "wall";
  wall.centre = {0.005, 0.0, 0.0};
  wall.halfSize.x() = 0.005;
  wall.material.k = 4e8;
  model.obstacles.push_back(wall);
  return model;
}

/// With simulate(): steps are cut before the wall, and the touch is located.
Trajectory careful(const engine::ModelSystem& system, double h, double duration, double outputInterval) {
  return run(system, "runge_kutta_4", h, duration, outputInterval).trajectory;
}

/// The loop that one would write first: a step, and the next one.
Trajectory blind(const engine::ModelSystem& system, double h, double duration) {
  const auto method = engine::makeMethod("runge_kutta_4");
  method->prepare(system, {});
  Trajectory trajectory;
  const auto record = [&trajectory](const State& state) {
    trajectory.t.push_back(state.t);
    trajectory.x.push_back(state.x);
    trajectory.v.push_back(state.v);
  };
  State from = system.initialState(), to = from;
  record(from);
  while (from.t < duration - 0.5 * h) {
    method->step(system, from, h, to);
    std::swap(from, to);
    system.switching()->commit(from, false);
    record(from);
  }
  return trajectory;
}

}  // namespace

/// Slide "Contacto Externo": a penalty acts only where a step looks; a fast node is beyond a thin wall in one step.
Figure tunnelling() {
  const auto system = engine::build(shot());
  Figure figure("tunnelling", "A fast node passes a thin wall that no step looks at", "time [s]");
  figure.slide(2);
  auto panel = figure.panel("position [m]");
  panel.heading("100 m/s against a wall of 1 cm");
  const Trajectory located = careful(*system, 1.0 / 60, 0.1, 1e-3);
  const Trajectory coarse = blind(*system, 1.0 / 60, 0.1);
  const Trajectory fine = blind(*system, 2e-4, 0.1);
  panel.line("", located.t, located.position(0));
  panel.linePoints("", coarse.t, coarse.position(0));
  panel.line("", fine.t, fine.position(0));
  panel.reference("wall", {0.0, 0.1}, {0.0, 0.0}).xRange(0.0, 0.1).yRange(-45.0, 25.0);
  panel.note(0.008, 11.0, "1/60 s, blind: through").note(0.055, -13.0, "1/60 s, touch found");
  panel.note(0.02, -33.0, "0.2 ms, blind: thrown");

  auto zoom = figure.panel("position [mm]");
  zoom.heading("the touch").xLabel("time [ms]");
  const auto scaled = [](std::vector<double> values) {
    for (double& value : values) value *= 1000.0;
    return values;
  };
  const Trajectory touch = careful(*system, 1.0 / 60, 0.0104, 2e-6);
  zoom.line("", scaled(touch.t), scaled(touch.position(0)));
  zoom.linePoints("", scaled(coarse.t), scaled(coarse.position(0)));
  zoom.linePoints("", scaled(fine.t), scaled(fine.position(0)));
  zoom.reference("", {9.8, 10.4}, {0.0, 0.0}).reference("", {9.8, 10.4}, {10.0, 10.0});
  zoom.xRange(9.8, 10.4).yRange(-20.0, 20.0);
  zoom.note(9.82, 15.0, "1/60 s, blind: no step ends in here");
  return figure;
}

}  // namespace muelle::plots::tunnelling
