#include "contour.h"
#include "drawing.h"
#include "tools.h"

#include <cmath>
#include <numbers>

namespace muelle::plots::energy_landscape {

/// Slide "Energía Elástica": on which variables the energy depends. One end held, the other anywhere in a plane: a
/// valley around a hill, all of its floor at the rest length.
Figure energy_landscape() {
  const double L0 = 1.0, highest = 50.0;
  engine::Model model;
  model.dimension = 2;
  model.nodes.resize(2);
  model.nodes[0].pinned = true;
  model.nodes[1].x = Vec3(L0, 0.0, 0.0);
  model.springs.push_back({.a = 1, .b = 0, .k = 100.0, .L0 = L0});
  const auto system = engine::build(model);
  State state = system->initialState();
  const auto energyAt = [&](double x, double z) {
    moveTo(*system, state, 1, Vec3(x, 0.0, z));
    return system->totalEnergy(state);
  };

  Field field;
  field.x = field.y = linear(-1.8, 1.8, 181);
  for (const double z : field.y) {
    for (const double x : field.x) field.values.push_back(energyAt(x, z));
  }
  field.label = "E [J]";
  field.range = {0.0, highest};
  field.bands = 10;  // 5 J each: every second edge is a line
  std::vector<double> ringX, ringZ;
  for (const double angle : linear(0.0, 2.0 * std::numbers::pi, 200)) {
    ringX.push_back(L0 * std::cos(angle));
    ringZ.push_back(L0 * std::sin(angle));
  }
  const std::vector<double> x = linear(-1.8, 1.8, 361);
  std::vector<double> through, beside;
  for (const double position : x) {
    through.push_back(energyAt(position, 0.0));
    beside.push_back(energyAt(position, 0.7));
  }

  Figure figure("energy_landscape", "The energy depends on positions, through the length alone: a round valley",
                "xₐ [m]");
  figure.slide(2);
  auto plane = figure.panel("zₐ [m]");
  plane.heading("node b in the origin, a line every 10 J").field(field).equalAxes();
  for (const double level : {10.0, 20.0, 30.0, 40.0}) {
    const Segments line = contour(field, level);
    plane.structure("", line.x, line.y);
  }
  plane.line("L = L₀", ringX, ringZ).colour(1).nodes("", {0.0}, {0.0});
  figure.panel("E [J]")
      .heading("along two lines")
      .line("zₐ = 0", x, through)
      .line("zₐ = 0.7 m", x, beside)
      .note(0.0, 54, "a peak at L = 0: no direction there", true)
      .note(0.0, 8.0, "L = 0.7 m", true)
      .yRange(0, 60);
  return figure;
}

}  // namespace muelle::plots::energy_landscape
