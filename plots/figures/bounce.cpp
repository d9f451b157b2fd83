#include "engine/integrators/catalogue.h"
#include "tools.h"

#include <fmt/format.h>
#include <algorithm>

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

/// Draws the height over time; returns the largest speed upwards [m/s].
double addBall(Figure::PanelBuilder& panel, const engine::ModelSystem& system, const char* name, double h,
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
  const std::vector<double> speeds = result.trajectory.velocity(0);
  return *std::max_element(speeds.begin(), speeds.end());
}

}  // namespace

/// Slide "Contacto Externo": a contact shorter than the step is a lottery, unless the step ends at the touch.
Figure bounce() {
  const auto system = engine::build(ball());
  Figure figure("bounce", "A bounce lasts 10 ms: steps that do not end at the touch throw the ball", "time [s]");
  figure.slide();
  auto panel = figure.panel("height [m]");
  addBall(panel, *system, "1 ms, touch located", 1e-3, true);
  addBall(panel, *system, "1/240 s, blind", 1.0 / 240, false);
  const double thrown = addBall(panel, *system, "1/60 s, blind", 1.0 / 60, false);
  panel.note(0.52, 1.75, fmt::format("1/60 s: thrown up at {:.0f} m/s", thrown));
  panel.yRange(-0.2, 2.0);
  panel.reference("", {0.0, 3.0}, {0.0, 0.0});
  return figure;
}

}  // namespace muelle::plots
