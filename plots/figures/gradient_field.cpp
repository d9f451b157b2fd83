#include "drawing.h"
#include "tools.h"

namespace muelle::plots {

namespace {

/// A node between two walls, on a spring to each that is longer than the way: two rest positions.
engine::Model betweenWalls() {
  engine::Model model;
  model.dimension = 2;
  model.nodes.resize(3);
  model.nodes[0].x = Vec3(-1.0, 0.0, 0.0);
  model.nodes[1].x = Vec3(1.0, 0.0, 0.0);
  model.nodes[0].pinned = model.nodes[1].pinned = true;
  model.nodes[2].x = Vec3(0.0, 0.0, 1.0);
  for (const int wall : {0, 1}) model.springs.push_back({.a = 2, .b = wall, .k = 100.0, .L0 = 1.25});
  return model;
}

}  // namespace

/// Slide "Energía Elástica": the force is the negative gradient of the energy, by the engine's force and by differences
/// of its energy.
Figure gradient_field() {
  const auto system = engine::build(betweenWalls());
  State state = system->initialState();
  const auto energyAt = [&](double x, double z) {
    moveTo(*system, state, 2, Vec3(x, 0.0, z));
    return system->totalEnergy(state);
  };
  const auto forceAt = [&](double x, double z) {
    moveTo(*system, state, 2, Vec3(x, 0.0, z));
    return forceOn(*system, state, 2);
  };

  Field field;
  field.x = linear(-0.9, 0.9, 91);
  field.y = linear(-1.3, 1.3, 131);
  for (const double z : field.y) {
    for (const double x : field.x) field.values.push_back(energyAt(x, z));
  }
  field.label = "E [J]";
  Arrows arrows;
  for (const double z : linear(-1.2, 1.2, 13)) {
    for (const double x : linear(-0.8, 0.8, 9)) arrows.add(Vec3(x, 0.0, z), 0.0025 * forceAt(x, z));
  }
  Figure figure("gradient_field", "The force is minus the gradient of the energy: it points downhill", "x [m]");
  figure.slide(2);
  auto plane = figure.panel("z [m]");
  plane.heading("energy and force of a node on two springs").field(field).equalAxes();
  arrows.addTo(plane, "force", 1);
  plane.points("rest", {0.0, 0.0}, {-0.75, 0.75}).colour(3).xRange(-0.9, 0.9).yRange(-1.3, 1.3);

  const double cut = 0.3, apart = 1e-4;
  std::vector<double> fx, fz, differenceX, differenceZ;
  const std::vector<double> x = linear(-0.9, 0.9, 181), coarse = linear(-0.9, 0.9, 19);
  for (const double position : x) {
    fx.push_back(forceAt(position, cut).x());
    fz.push_back(forceAt(position, cut).z());
  }
  for (const double position : coarse) {
    differenceX.push_back(-(energyAt(position + apart, cut) - energyAt(position - apart, cut)) / (2.0 * apart));
    differenceZ.push_back(-(energyAt(position, cut + apart) - energyAt(position, cut - apart)) / (2.0 * apart));
  }
  figure.panel("force [N]")
      .heading("on the line z = 0.3 m")
      .line("F_x", x, fx)
      .colour(0)
      .line("F_z", x, fz)
      .colour(1)
      .points("-dE/dx", coarse, differenceX)
      .colour(0)
      .points("-dE/dz", coarse, differenceZ)
      .colour(1);
  return figure;
}

}  // namespace muelle::plots
