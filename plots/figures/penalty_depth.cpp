#include "engine/statics/equilibrium.h"
#include "tools.h"

namespace muelle::plots::penalty_depth {

namespace {

constexpr double g = 9.81;

/// A ball of 1 kg just above a floor whose penalty stiffness is k [N/m].
engine::Model ballOnFloor(double k, double d) {
  engine::Model model;
  model.dimension = 1;
  model.gravity = {-g, 0.0, 0.0};
  model.nodes.resize(1);
  model.nodes[0].x[0] = 0.0;
  engine::Obstacle floor;
  floor.normal = Vec3::UnitX();
  floor.material.k = k;
  floor.material.d = d;
  model.obstacles.push_back(floor);
  return model;
}

}  // namespace

/// Slide "Contacto Externo": a penalty floor lets a resting ball in by m g / k.
Figure penalty_depth() {
  Figure figure("penalty_depth", "A penalty floor gives way by m g / k: stiffer is truer, and harder to integrate",
                "stiffness k [N/m]");
  figure.slide(2);
  std::vector<double> stiffness, depth, expected;
  for (const double k : logarithmic(1e2, 1e6, 9)) {
    const auto system = engine::build(ballOnFloor(k, 0.0));
    State start = system->initialState();
    start.x[0] = -2.0 * g / k;
    stiffness.push_back(k);
    depth.push_back(-engine::equilibrium(*system, start).state.x[0]);
    expected.push_back(g / k);
  }
  figure.panel("depth at rest [m]")
      .heading("equilibrium, m = 1 kg")
      .points("engine", stiffness, depth)
      .reference("m g / k", stiffness, expected)
      .logX()
      .logY();
  auto settling = figure.panel("height [mm]");
  settling.heading("put down on the floor, damped").xLabel("time [s]");
  for (const double k : {1e3, 1e4}) {
    const auto system = engine::build(ballOnFloor(k, 10.0));
    const engine::RunResult result = run(*system, "runge_kutta_4", 1e-4, 1.2, 2e-3);
    std::vector<double> height = result.trajectory.position(0);
    for (double& h : height) h *= 1000.0;
    settling.line(k < 1e4 ? "k = 10³ N/m" : "k = 10⁴ N/m", result.trajectory.t, height);
    settling.reference("", {0.0, 1.2}, {-1000.0 * g / k, -1000.0 * g / k});
  }
  return figure;
}

}  // namespace muelle::plots::penalty_depth
