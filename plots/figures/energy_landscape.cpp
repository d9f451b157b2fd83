#include "drawing.h"
#include "tools.h"

#include <cmath>
#include <numbers>

namespace muelle::plots {

/// Slide "Energía Elástica": on which variables the energy depends. One end held, the other anywhere in a plane: a
/// valley around a hill, all of its floor at the rest length.
Figure energy_landscape() {
  const double L0 = 1.0;
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
  field.x = field.y = linear(-1.8, 1.8, 121);
  for (const double z : field.y) {
    for (const double x : field.x) field.values.push_back(energyAt(x, z));
  }
  field.label = "E [J]";
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

  Figure figure("energy_landscape", "A spring's energy is a function of positions: a round valley at the rest length",
                "x_a [m]");
  figure.slide(2);
  figure.panel("z_a [m]")
      .heading("E (x_a, z_a), the other end in the origin")
      .field(field)
      .line("", ringX, ringZ)
      .colour(1)
      .equalAxes()
      .note(0.0, 1.35, "E = 0 where L = L0", true);
  figure.panel("E [J]")
      .heading("two cuts")
      .line("z_a = 0", x, through)
      .line("z_a = 0.7 m", x, beside)
      .reference("rest length", {-1, -1}, {0, 60})
      .reference("", {1, 1}, {0, 60})
      .note(0.0, 54, "sharp: no direction", true)
      .yRange(0, 60);
  return figure;
}

}  // namespace muelle::plots
