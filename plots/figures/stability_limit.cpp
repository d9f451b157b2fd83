#include "engine/analysis/amplification.h"
#include "engine/analysis/stability.h"
#include "engine/integrators/catalogue.h"
#include "tools.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

namespace muelle::plots::stability_limit {

namespace {

constexpr double mostStep = 3.6, mostGrowth = 3.0;  // of what is shown
constexpr double mostEnd = 3.0;                     // [mm], three times the chain's right answer

/// Ten nodes in a row, the last of which is struck, so weakly that no spring passes through zero length in the picture.
engine::Model struckChain() {
  engine::Model model;
  model.dimension = 1;
  model.nodes.resize(11);
  for (int i = 0; i <= 10; ++i) model.nodes[static_cast<std::size_t>(i)].x[0] = 0.1 * i;
  for (int i = 0; i < 10; ++i) model.springs.push_back({.a = i, .b = i + 1, .k = 1000.0, .L0 = 0.1});
  model.nodes[0].pinned = true;
  model.nodes[10].v[0] = 0.1;
  for (auto& node : model.nodes) node.m = 0.1;
  return model;
}

/// The growth a step of an undamped oscillator, against h omega.
void addGrowth(Figure::PanelBuilder& panel, const std::string& id, int colour) {
  const auto method = engine::makeMethod(id);
  engine::Amplification amplification(*method);
  const std::vector<double> steps = linear(0.0, mostStep, 641);
  std::vector<double> growth;
  for (const double z : steps) growth.push_back(amplification.growth(z * z, 0.0));
  panel.line("", steps, growth).colour(colour);
}

void addLimit(Figure::PanelBuilder& panel, const std::string& id, int colour) {
  const auto method = engine::makeMethod(id);
  panel.points("", {engine::Amplification(*method).imaginaryLimit()}, {1.0}).colour(colour);
}

void addOscillator(Figure::PanelBuilder panel) {
  panel.heading("undamped oscillator").xRange(0, mostStep).yRange(0, mostGrowth);
  panel.structure("", {0.0, mostStep}, {1.0, 1.0});
  addGrowth(panel, "explicit_euler", 1);
  panel.nameAt(0.5, 1.95, "explicit Euler");
  // One curve: the two differ by half a step, which does not change what grows.
  addGrowth(panel, "symplectic_euler", 0);
  panel.nameAt(0.5, 2.55, "symplectic Euler");
  addGrowth(panel, "velocity_verlet", 0);
  panel.nameAt(0.5, 2.75, "velocity Verlet and");
  addGrowth(panel, "runge_kutta_4", 2);
  panel.nameAt(0.9, 0.35, "classical Runge-Kutta");
  addLimit(panel, "explicit_euler", 1);
  panel.nameAt(0.0, 0.87, "limit 0");
  addLimit(panel, "velocity_verlet", 0);
  panel.nameAt(2.02, 1.13, "limit 2");
  addLimit(panel, "runge_kutta_4", 2);
  panel.nameAt(2.84, 0.87, "limit 2√2");
}

/// The chain's free end, as far as the picture shows it: what comes back from outside would be a stroke without
/// meaning. Says where it leaves.
std::string addFreeEnd(Figure::PanelBuilder& panel, const engine::ModelSystem& system, double h, int colour) {
  const Trajectory path = run(system, "velocity_verlet", h, 1.0).trajectory;
  std::vector<double> end = path.position(system.lane(10, 0));
  for (double& x : end) x = 1e3 * (x - 1.0);
  const auto lost = std::ranges::find_if(end, [](double x) { return std::abs(x) > mostEnd; });
  std::string leaves;
  if (lost != end.end()) {
    leaves = fmt::format("leaves the picture at t = {:.2f} s", path.t[static_cast<std::size_t>(lost - end.begin())]);
    std::fill(lost + 1, end.end(), NAN);
  }
  panel.line("", path.t, end).colour(colour);
  return leaves;
}

void addChain(Figure::PanelBuilder panel) {
  const auto system = engine::build(struckChain());
  const auto verlet = engine::makeMethod("velocity_verlet");
  const double limit = engine::stability(*system, *verlet, system->initialState()).largestStep;
  panel.heading(fmt::format("velocity Verlet on a chain: limit 2/ωₘₐₓ = {:.1f} ms", 1e3 * limit));
  panel.xLabel("time [s]").yRange(-mostEnd, mostEnd);
  addFreeEnd(panel, *system, 0.99 * limit, 0);
  panel.nameAt(0.43, 1.3, "h = 0.99 × limit");
  const std::string leaves = addFreeEnd(panel, *system, 1.01 * limit, 1);
  panel.nameAt(0.24, 2.7, "h = 1.01 × limit").nameAt(0.24, 2.3, leaves);
}

}  // namespace

/// Hard case H03: where an undamped oscillator begins to grow, method by method, and the same on a chain of ten nodes,
/// whose largest step the engine tells before the run.
Figure stability_limit() {
  Figure figure("stability_limit",
                "The limit of hω is known before the run: beyond it, every step makes the motion grow", "hω");
  figure.slide(2);
  addOscillator(figure.panel("growth per step (cut at 3)"));
  addChain(figure.panel("free end [mm]"));
  return figure;
}

}  // namespace muelle::plots::stability_limit
