#include "engine/integrators/catalogue.h"
#include "tools.h"

namespace muelle::plots {

namespace {

/// Hard case H17: a ball falls from 1 m on a penalty floor of 1e5 N/m, without damping.
engine::Model ball() {
  engine::Model model;
  model.dimension = 1;
  model.gravity = {-9.81, 0.0, 0.0};
  model.nodes.resize(1);
  model.nodes[0].x[0] = 1.0;
  engine::Obstacle floor;
  floor.normal = Vec3::UnitX();
  floor.material.k = 1e5;
  model.obstacles.push_back(floor);
  return model;
}

void addBall(Figure::PanelBuilder& panel, const engine::ModelSystem& system, const char* name, double h,
             bool locateEvents) {
  engine::RunOptions options;
  options.h = h;
  options.fixedStep = true;
  options.duration = 3.0;
  options.outputInterval = locateEvents ? 5e-3 : 0.0;
  options.locateEvents = locateEvents;
  options.checkStability = options.checkNumericalDamping = false;
  const engine::RunResult result =
      engine::simulate(system, *engine::makeMethod("velocity_verlet"), system.initialState(), options);
  panel.line(name, result.trajectory.t, result.trajectory.position(0));
}

}  // namespace

/// Slide "Contacto Externo": a contact shorter than the step is a lottery, unless the step ends at the touch.
Figure bounce() {
  const auto system = engine::build(ball());
  Figure figure("bounce", "A bounce lasts 10 ms: steps that do not end at the touch throw the ball", "time [s]");
  figure.slide();
  auto panel = figure.panel("height [m]");
  addBall(panel, *system, "touch located, 1 ms", 1e-3, true);
  addBall(panel, *system, "blind steps of 1/240 s", 1.0 / 240, false);
  addBall(panel, *system, "blind steps of 1/60 s", 1.0 / 60, false);
  panel.yRange(-0.2, 4.0);
  panel.reference("floor", {0.0, 3.0}, {0.0, 0.0});
  return figure;
}

}  // namespace muelle::plots
