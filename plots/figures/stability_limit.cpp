#include "engine/analysis/stability.h"
#include "engine/integrators/catalogue.h"
#include "tools.h"

#include <fmt/format.h>
#include <cmath>

namespace muelle::plots {

/// Hard case H03 on a scene: a hanging chain of ten nodes, and the largest step that the engine tells before the run.
Figure stability_limit() {
  engine::Model model;
  model.dimension = 1;
  model.nodes.resize(11);
  for (int i = 0; i <= 10; ++i) model.nodes[static_cast<std::size_t>(i)].x[0] = 0.1 * i;
  for (int i = 0; i < 10; ++i) model.springs.push_back({.a = i, .b = i + 1, .k = 1000.0, .L0 = 0.1});
  model.nodes[0].pinned = true;
  model.nodes[10].v[0] = 0.1;
  for (auto& node : model.nodes) node.m = 0.1;
  const auto system = engine::build(model);
  const auto verlet = engine::makeMethod("velocity_verlet");
  const double limit = engine::stability(*system, *verlet, system->initialState()).largestStep;

  Figure figure("stability_limit",
                fmt::format("The limit h omega = 2 is known before the run: here h = {:.4f} s", limit), "time [s]");
  figure.slide(2);
  auto early = figure.panel("free end [m]");
  early.heading("just below and just above the limit");
  for (const double part : {0.99, 1.01}) {
    const engine::RunResult result = run(*system, "velocity_verlet", part * limit, 2.2);
    std::vector<double> end;
    for (const auto& x : result.trajectory.x) end.push_back(x[static_cast<std::size_t>(system->unknown(10, 0))]);
    early.line(fmt::format("{:.2f} of it", part), result.trajectory.t, end);
  }
  early.yRange(0.9, 1.1);
  std::vector<double> ratio, energy;
  const double E0 = system->totalEnergy(system->initialState());
  for (const double part : linear(0.80, 1.10, 61)) {
    const engine::RunResult result = run(*system, "velocity_verlet", part * limit, 400 * part * limit, part * limit);
    const double E = result.failed() ? 1e8 * E0 : system->totalEnergy(result.last);
    ratio.push_back(part);
    energy.push_back(std::min(E / E0, 1e8));
  }
  figure.panel("energy after 400 steps, of the first")
      .heading("energy against the step")
      .xLabel("step, of the limit")
      .linePoints("", ratio, energy)
      .reference("limit", {1.0, 1.0}, {0.1, 1e8})
      .logY()
      .yRange(0.1, 1e8);
  return figure;
}

}  // namespace muelle::plots
