#include "engine/integrators/catalogue.h"
#include "tools.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace muelle::plots::bounce {

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

/// Two bounces and a half.
constexpr double duration = 2.4;
constexpr double top = 2.0;  ///< of the picture [m]

struct Flight {
  std::vector<double> t, height;
  double fastest = 0.0;  ///< upwards [m/s]

  /// When its line first leaves the picture [s].
  double leaves() const {
    const auto above = std::ranges::find_if(height, [](double y) { return y > top; });
    const auto i = static_cast<std::size_t>(above - height.begin());
    return t[i - 1] + (top - height[i - 1]) / (height[i] - height[i - 1]) * (t[i] - t[i - 1]);
  }
};

Flight fly(const engine::ModelSystem& system, double h, bool locateEvents) {
  engine::RunOptions options;
  options.h = h;
  options.fixedStep = true;
  options.duration = duration;
  options.outputInterval = locateEvents ? 2e-3 : 0.0;
  options.locateEvents = locateEvents;
  options.checkStability = options.checkNumericalDamping = false;
  const engine::RunResult result =
      engine::simulate(system, *engine::makeMethod("velocity_verlet"), system.initialState(), options);
  const std::vector<double> speeds = result.trajectory.velocity(0);
  return {result.trajectory.t, result.trajectory.position(0), *std::max_element(speeds.begin(), speeds.end())};
}

}  // namespace

/// Slide "Contacto Externo": beyond the limit of its contact, 2 / omega, a step throws the ball; to locate the touch
/// does not help, for the contact itself is what the step cannot follow.
Figure bounce() {
  const auto system = engine::build(ball());
  const double omega = std::sqrt(system->model().obstacles[0].material.k / system->model().nodes[0].m);
  const double contact = std::numbers::pi / omega, limit = 2.0 / omega;
  Figure figure("bounce",
                fmt::format("A step beyond the contact's limit, 2/ω = {:.1f} ms, throws the ball", 1e3 * limit),
                "time [s]");
  figure.slide();
  auto panel = figure.panel("height [m]");
  const Flight fine = fly(*system, 1e-3, true), within = fly(*system, 1.0 / 240, false);
  panel.line("1 ms, touch located", fine.t, fine.height).line("1/240 s", within.t, within.height);
  double x = 0.54, y = 1.85;
  for (const auto& [located, name] : {std::pair(false, "1/60 s"), std::pair(true, "1/60 s, touch located")}) {
    const Flight thrown = fly(*system, 1.0 / 60, located);
    panel.line(name, thrown.t, thrown.height);
    panel.note(
        x, y, fmt::format("{}: leaves the picture at t = {:.2f} s, {:.0f} m/s", name, thrown.leaves(), thrown.fastest));
    y -= 0.17;
  }
  panel.note(0.74, 0.14, fmt::format("contact: π/ω = {:.0f} ms", 1e3 * contact));
  const double highest = *std::max_element(within.height.begin() + 1, within.height.end());
  panel.note(0.8, 1.15, fmt::format("1/240 s: within the limit, but {:.0f} % too high", 100.0 * (highest - 1.0)));
  panel.structure("", {0.0, duration}, {0.0, 0.0}).xRange(0.0, duration).yRange(-0.2, top);
  return figure;
}

}  // namespace muelle::plots::bounce
