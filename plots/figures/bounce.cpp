#include "engine/integrators/catalogue.h"
#include "tools.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

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

/// Slide "Contacto Externo": beyond the limit of its contact, 2 / omega, a step throws the ball.
Figure bounce() {
  const auto system = engine::build(ball());
  const double omega = std::sqrt(system->model().obstacles[0].material.k / system->model().nodes[0].m);
  const std::string title = fmt::format("A bounce of {:.0f} ms bounds the step to {:.1f} ms: 1/60 s throws the ball",
                                        1e3 * std::numbers::pi / omega, 1e3 * 2.0 / omega);
  Figure figure("bounce", title, "time [s]");
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
