#include "engine/integrators/catalogue.h"
#include "tools.h"

#include <numbers>

namespace muelle::plots {

/// Slide "Receta para una Simulación", discretisation: the same oscillator, the same step, and what each method makes
/// of its orbit in the phase plane.
Figure oscillator_by_method() {
  const double omega = 1.0, h = 0.12, periods = 2.0;
  const auto system = engine::build(oscillator(1.0, omega * omega, 1.0));
  Figure figure("oscillator_by_method",
                "One oscillator, one step: explicit Euler spirals out, backward Euler in, the rest stay",
                "position x [m]");
  figure.slide(3);
  const std::vector<double> angle = linear(0.0, 2.0 * std::numbers::pi, 200);
  std::vector<double> cosine, sine;
  for (const double a : angle) {
    cosine.push_back(std::cos(a));
    sine.push_back(-std::sin(a));
  }
  int colour = 0;
  for (const std::string id : {"explicit_euler", "backward_euler", "symplectic_euler", "runge_kutta_4",
                               "implicit_midpoint", "velocity_verlet"}) {
    const engine::RunResult result = run(*system, id, h, periods * 2.0 * std::numbers::pi);
    figure.panel("v [m/s]")
        .heading(engine::methodInfo(id).name)
        .reference("", cosine, sine)
        .line("", result.trajectory.position(0), result.trajectory.velocity(0))
        .colour(colour++)
        .xRange(-2.2, 2.2)
        .yRange(-2.2, 2.2)
        .equalAxes();
  }
  return figure;
}

}  // namespace muelle::plots
