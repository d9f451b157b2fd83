#include "engine/statics/equilibrium.h"
#include "tools.h"

#include <fmt/format.h>

namespace muelle::plots::buckling {

namespace {

/// Hard case H14: a node of 1 kg between two anchors 1.6 m apart on springs of rest length 1 m, off the axis by y [m].
engine::Model compressed(double y, double drag) {
  engine::Model model;
  model.dimension = 2;
  model.plane = {0, 1};
  model.nodes.resize(3);
  model.nodes[0] = {.x = {-0.8, 0.0, 0.0}, .pinned = true};
  model.nodes[1] = {.x = {0.8, 0.0, 0.0}, .pinned = true};
  model.nodes[2] = {.x = {0.0, y, 0.0}, .drag = drag};
  for (const int anchor : {0, 1}) model.springs.push_back({.a = anchor, .b = 2, .k = 100.0, .L0 = 1.0});
  return model;
}

constexpr double release = 1e-3;

/// The energy across the axis; returns where the minimum above it lies [m].
double addEnergy(Figure& figure) {
  const auto system = engine::build(compressed(0.0, 0.0));
  State state = system->initialState();
  const auto y = static_cast<std::size_t>(system->lane(2, 1));
  std::vector<double> heights = linear(-1.0, 1.0, 201), energies;
  for (const double height : heights) {
    state.x[y] = height;
    energies.push_back(system->potential()->energy(0.0, state.x, state.z));
  }
  std::vector<double> rests, lows;
  for (const double start : {-0.1, 0.1}) {
    state.x[y] = start;
    const engine::StaticResult rest = engine::equilibrium(*system, state);
    rests.push_back(rest.state.x[y]);
    lows.push_back(rest.energy);
  }
  state.x[y] = 0.0;
  engine::StaticOptions stay;
  stay.leaveSaddles = false;
  const engine::StaticResult saddle = engine::equilibrium(*system, state, stay);
  figure.panel("elastic energy [J]")
      .heading("forces sum to 0 at three places")
      .line("", heights, energies)
      .points("stable", rests, lows)
      .points("saddle", {saddle.state.x[y]}, {saddle.energy})
      .yRange(-0.3, 9.0);
  return rests.back();
}

/// The springs where the node is on the saddle and at its two places of rest.
void addShapes(Figure& figure, double rest) {
  auto panel = figure.panel("y [m]");
  panel.heading("two springs of 1 m, in 1.6 m").xLabel("x [m]");
  for (const double y : {-rest, rest}) panel.line("", {-0.8, 0.0, 0.8}, {0.0, y, 0.0}).colour(1);
  panel.line("", {-0.8, 0.0, 0.8}, {0.0, 0.0, 0.0}).colour(2);
  panel.nodes("", {-0.8, 0.8, 0.0, 0.0, 0.0}, {0.0, 0.0, -rest, 0.0, rest}).equalAxes();
  panel.xRange(-1.0, 1.0).yRange(-1.0, 1.0);
}

void addMotion(Figure& figure, double rest) {
  const double duration = 5.0;
  auto motion = figure.panel("y [m]");
  motion.heading(fmt::format("let go at y = {:.0f} mm: away, and back", 1e3 * release)).xLabel("time [s]");
  for (const auto& [drag, name] : {std::pair(0.0, "no drag"), std::pair(3.0, "drag")}) {
    const auto leaving = engine::build(compressed(release, drag));
    const engine::RunResult result = run(*leaving, "runge_kutta_4", 1e-3, duration, 0.01);
    motion.line(name, result.trajectory.t, result.trajectory.position(leaving->lane(2, 1)));
  }
  motion.reference("stable", {0.0, duration}, {rest, rest}).xRange(0.0, duration).yRange(-0.05, 1.1);
}

}  // namespace

/// Slide "Fuerzas y Energias": a compressed pair of springs buckles; forces that balance are not yet a rest. Without
/// drag the node comes back to where it was let go, and leaves again.
Figure buckling() {
  Figure figure("buckling", "Forces sum to 0 on the saddle, too: 1 mm beside it, the springs buckle", "y [m]");
  figure.slide(3);
  const double rest = addEnergy(figure);
  addShapes(figure, rest);
  addMotion(figure, rest);
  return figure;
}

}  // namespace muelle::plots::buckling
