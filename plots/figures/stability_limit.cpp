#include "engine/analysis/stability.h"
#include "engine/integrators/catalogue.h"
#include "tools.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

namespace muelle::plots {

namespace {

/// Ten nodes in a row, the last of which is struck.
engine::Model chain(double speed) {
  engine::Model model;
  model.dimension = 1;
  model.nodes.resize(11);
  for (int i = 0; i <= 10; ++i) model.nodes[static_cast<std::size_t>(i)].x[0] = 0.1 * i;
  for (int i = 0; i < 10; ++i) model.springs.push_back({.a = i, .b = i + 1, .k = 1000.0, .L0 = 0.1});
  model.nodes[0].pinned = true;
  model.nodes[10].v[0] = speed;
  for (auto& node : model.nodes) node.m = 0.1;
  return model;
}

}  // namespace

/// Hard case H03 on a scene: a chain of ten nodes, and the largest step that the engine tells before the run.
Figure stability_limit() {
  const auto system = engine::build(chain(1.0));
  const auto verlet = engine::makeMethod("velocity_verlet");
  const double limit = engine::stability(*system, *verlet, system->initialState()).largestStep;

  Figure figure("stability_limit",
                fmt::format("The limit h omega = 2 is known before the run: here h = {:.4f} s", limit), "time [s]");
  figure.slide(2);
  auto early = figure.panel("end [m]");
  early.heading("the free end, with two steps");
  for (const double part : {0.99, 1.01}) {
    const engine::RunResult result = run(*system, "velocity_verlet", part * limit, 1.0);
    std::vector<double> end = result.trajectory.position(system->unknown(10, 0));
    // What leaves the plot does not come back as a meaningless stroke.
    const auto lost = std::find_if(end.begin(), end.end(), [](double x) { return std::abs(x - 1.0) > 0.05; });
    if (lost != end.end()) std::fill(lost + 1, end.end(), NAN);
    early.line(part < 1.0 ? "1 % below" : "1 % above", result.trajectory.t, end);
  }
  early.yRange(0.95, 1.05);
  std::vector<double> ratio, energy;
  // Struck so weakly that no spring passes through zero length, which would cut the steps.
  const auto weak = engine::build(chain(1e-6));
  const double E0 = weak->kineticEnergy(weak->initialState());
  for (const double part : linear(0.80, 1.10, 61)) {
    const engine::RunResult result = run(*weak, "velocity_verlet", part * limit, 400 * part * limit);
    const auto energies = along(result.trajectory, [&](const State& s) { return weak->kineticEnergy(s); });
    const double E = *std::max_element(energies.begin(), energies.end());
    ratio.push_back(part);
    energy.push_back(std::min(E / E0, 1e8));
  }
  figure.panel("largest / first")
      .heading("the kinetic energy within 400 steps")
      .xLabel("step / limit")
      .linePoints("", ratio, energy)
      .reference("limit", {1.0, 1.0}, {0.1, 1e8})
      .logY()
      .yRange(0.1, 1e8);
  return figure;
}

}  // namespace muelle::plots
