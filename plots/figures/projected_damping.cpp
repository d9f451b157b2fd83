#include "tools.h"

namespace muelle::plots {

/// Slide "Amortiguamiento", "the best of the three": a pair that turns and vibrates (hard case H07, "vibrate"). The
/// vibration dies, the turning does not.
Figure projected_damping() {
  engine::Model model;
  model.nodes.resize(2);
  model.nodes[0].m = 1.0;
  model.nodes[0].x = {0.9, 0.0, 0.0};
  model.nodes[0].v = {0.0, 3.6, 0.0};
  model.nodes[1].m = 3.0;
  model.nodes[1].x = {-0.3, 0.0, 0.0};
  model.nodes[1].v = {0.0, -1.2, 0.0};
  model.springs.push_back({.a = 0, .b = 1, .k = 252.0, .L0 = 1.0, .dProjected = 3.0});
  const auto system = engine::build(model);
  const engine::RunResult result = run(*system, "runge_kutta_4", 1e-3, 3.0, 5e-3);
  const Trajectory& trajectory = result.trajectory;
  const auto& t = trajectory.t;

  // Turning without vibration: k (L - L0) = J^2 / (mu L^3), J the angular momentum, mu the reduced mass.
  const double turning = 1.07867456862361;

  Figure figure("projected_damping", "Projected damping takes the vibration and leaves the rotation", "time [s]");
  figure.slide(2);
  figure.panel("length [m]")
      .heading("vibration")
      .line("", t,
            along(trajectory, [&](const State& s) { return (system->position(s, 0) - system->position(s, 1)).norm(); }))
      .reference("turning equilibrium", {0.0, 3.0}, {turning, turning});
  figure.panel("[J], [kg m²/s]")
      .heading("energy and rotation")
      .line("energy", t, along(trajectory, [&](const State& s) { return system->totalEnergy(s); }))
      .line("ang. momentum", t, along(trajectory, [&](const State& s) { return system->angularMomentum(s).z(); }))
      .yRange(0.0, 16.0);
  return figure;
}

}  // namespace muelle::plots
