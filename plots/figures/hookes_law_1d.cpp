#include "engine/model/model_system.h"
#include "figure_list.h"

namespace muelle::plots::hookes_law_1d {

namespace {

/// Force on the free end of a spring to the origin, for each position of that end.
std::vector<double> forces(double k, double L0, const std::vector<double>& positions) {
  engine::Model model;
  model.dimension = 1;
  model.nodes.resize(2);
  model.nodes[0].pinned = true;
  model.nodes[1].x[0] = L0;
  model.springs.push_back({.a = 1, .b = 0, .k = k, .L0 = L0});
  const auto system = engine::build(model);
  State state = system->initialState();
  std::vector<double> values, force(state.x.size());
  for (const double x : positions) {
    state.x[0] = x;
    system->force(0.0, state.x, state.v, state.z, force);
    values.push_back(force[0]);
  }
  return values;
}

}  // namespace

/// Slide "Ley de Hooke": a straight line through the rest length, whose slope is -k.
Figure hookes_law_1d() {
  const double L0 = 1.0;
  std::vector<double> x;
  for (int i = 1; i <= 200; ++i) x.push_back(0.01 * i);
  Figure figure("hookes_law_1d", "Hooke's law in 1D: a straight line through the rest length, of slope −k",
                "position xₐ [m]");
  figure.slide();
  figure.panel("force Fₐ [N]")
      .line("k = 50 N/m", x, forces(50, L0, x))
      .line("k = 100 N/m", x, forces(100, L0, x))
      .line("k = 200 N/m", x, forces(200, L0, x))
      .structure("", {0.0, 2.0}, {0.0, 0.0})
      .note(1.04, 40, "no force at the rest length L₀ = 1 m")
      .note(0.34, 160, "compressed: pushed out")
      .note(1.2, -160, "stretched: pulled back");
  return figure;
}

}  // namespace muelle::plots::hookes_law_1d
