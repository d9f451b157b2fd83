#include "tools.h"

#include <fmt/format.h>

namespace muelle::plots {

namespace {

/// Five pupils, light and heavy, short and tall, whose mean height should be h0.
engine::Model pupils(double h0, double drag) {
  engine::Model model;
  model.dimension = 1;
  engine::ModelProperty mean;
  mean.k = 8000.0;
  mean.p0 = h0;
  const double heights[] = {1.3, 1.45, 1.6, 1.75, 1.9}, masses[] = {70.0, 30.0, 55.0, 40.0, 90.0};
  for (int i = 0; i < 5; ++i) {
    model.nodes.push_back({.x = Vec3(heights[i], 0.0, 0.0), .m = masses[i], .drag = drag});
    mean.nodes.push_back(i);
    mean.weights.push_back(Vec3(0.2, 0.0, 0.0));
  }
  model.properties.push_back(mean);
  return model;
}

}  // namespace

/// Slide "Fuerzas y Energías": an energy that is least where a property holds gives a force towards it.
Figure property_mean_height() {
  const double h0 = 2.0, duration = 6.0;
  Figure figure("property_mean_height",
                "An energy of the mean height: the mean goes to 2 m, each pupil wherever the force takes them",
                "time [s]");
  figure.slide(2);
  for (const double drag : {0.0, 60.0}) {
    const auto system = engine::build(pupils(h0, drag));
    const Trajectory trajectory = run(*system, "runge_kutta_4", 0.01, duration).trajectory;
    const auto height = [&](const State& state, int node) { return system->position(state, node).x(); };
    auto panel = figure.panel("height [m]");
    panel.heading(drag > 0.0 ? fmt::format("with drag, d = {} kg/s", drag) : "without drag: about h0 for ever");
    for (int i = 0; i < 5; ++i) {
      const auto values = along(trajectory, [&](const State& state) { return height(state, i); });
      panel.line(i == 0 ? "each pupil" : "", trajectory.t, values).colour(5);
    }
    const auto mean = along(trajectory, [&](const State& state) {
      double sum = 0.0;
      for (int i = 0; i < 5; ++i) sum += height(state, i);
      return sum / 5.0;
    });
    panel.line("mean", trajectory.t, mean).colour(1);
    panel.reference("h0", {0.0, duration}, {h0, h0}).yRange(1.0, 3.4);
  }
  return figure;
}

}  // namespace muelle::plots
