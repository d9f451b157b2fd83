#include "tools.h"

#include <fmt/format.h>
#include <cmath>
#include <numbers>

namespace muelle::plots::friction_threshold {

namespace {

constexpr double mu = 0.5;

/// How far [m] a node of 1 kg, put down at rest on a slope, has come down it by each output time (hard case H20). The
/// slope is the floor of a world that is turned: gravity leans instead.
Trajectory slide(double degrees, double duration, double outputInterval) {
  const double g = 9.81, k = 1e4, angle = degrees * std::numbers::pi / 180.0;
  engine::Model model;
  model.dimension = 2;
  model.gravity = {g * std::sin(angle), 0.0, -g * std::cos(angle)};
  model.nodes.resize(1);
  model.nodes[0].x.z() = -g * std::cos(angle) / k;
  engine::Obstacle slope;
  slope.material.k = k;
  slope.material.mu = mu;
  model.obstacles.push_back(slope);
  const auto system = engine::build(model);
  return run(*system, "runge_kutta_4", 2e-3, duration, outputInterval).trajectory;
}

}  // namespace

/// Slide "Contacto Externo": Coulomb friction holds up to the angle whose tangent is mu, without any creep.
Figure friction_threshold() {
  const double seconds = 2.0;
  std::vector<double> angles = linear(15, 35, 41), distances;
  for (const double angle : angles) distances.push_back(slide(angle, seconds, seconds).last().x[0]);

  Figure figure("friction_threshold", "Friction holds a node for ever up to tan α = μ, and not beyond",
                "angle α of the slope [degrees]");
  figure.slide(2);
  const double threshold = std::atan(mu) * 180.0 / std::numbers::pi;
  figure.panel(fmt::format("distance slid in {:.0f} s [m]", seconds))
      .heading("μ = 0.5")
      .line("", angles, distances)
      .reference("arctan μ", {threshold, threshold}, {0.0, distances.back()})
      .yRange(-0.1, 3.5);
  auto panel = figure.panel("distance slid [m]");
  panel.heading("a tenth of a degree apart").xLabel("time [s]");
  for (const double angle : {26.5, 26.6}) {
    const Trajectory path = slide(angle, 10.0, 0.1);
    panel.line(fmt::format("{:.1f} degrees", angle), path.t, path.position(0));
  }
  panel.yRange(-0.02, 0.4);
  return figure;
}

}  // namespace muelle::plots::friction_threshold
