#include "engine/statics/equilibrium.h"
#include "tools.h"

namespace muelle::plots {

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

}  // namespace

/// Slide "Fuerzas y Energias": a compressed pair of springs buckles; forces that balance are not yet a rest.
Figure buckling() {
  const auto system = engine::build(compressed(0.0, 0.0));
  State state = system->initialState();
  const auto y = static_cast<std::size_t>(system->unknown(2, 1));
  std::vector<double> heights = linear(-1.0, 1.0, 201), energies;
  for (const double height : heights) {
    state.x[y] = height;
    energies.push_back(system->potential()->energy(0.0, state.x, state.z));
  }
  Figure figure("buckling",
                "A compressed spring buckles: forces sum to 0 on the saddle too, but the least push leads away",
                "position across the axis y [m]");
  figure.slide(2);
  auto landscape = figure.panel("elastic energy [J]");
  landscape.heading("two springs, 1 m long, in 1.6 m").line("", heights, energies);
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
  landscape.points("minimum", rests, lows).points("saddle", {saddle.state.x[y]}, {saddle.energy}).yRange(-0.3, 9.0);

  auto motion = figure.panel("y [m]");
  motion.heading("let go 1 micrometre off the axis").xLabel("time [s]");
  for (const auto& [drag, name] : {std::pair(0.0, "undamped"), std::pair(3.0, "drag 3 kg/s")}) {
    const auto leaving = engine::build(compressed(1e-6, drag));
    const engine::RunResult result = run(*leaving, "runge_kutta_4", 1e-3, 5.0, 0.01);
    motion.line(name, result.trajectory.t, result.trajectory.position(leaving->unknown(2, 1)));
  }
  motion.reference("minimum", {0.0, 5.0}, {rests.back(), rests.back()}).yRange(-0.05, 1.1);
  return figure;
}

}  // namespace muelle::plots
