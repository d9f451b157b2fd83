#include "contour.h"
#include "drawing.h"
#include "tools.h"

namespace muelle::plots::gradient_field {

namespace {

const double metresPerNewton = 1.0 / 400.0;

/// A node between a floor and a ceiling, on a spring to each that is longer than the way: two places of rest.
engine::Model betweenTwo() {
  engine::Model model;
  model.dimension = 2;
  model.nodes.resize(3);
  model.nodes[0].x = Vec3(0.0, 0.0, -1.0);
  model.nodes[1].x = Vec3(0.0, 0.0, 1.0);
  model.nodes[0].pinned = model.nodes[1].pinned = true;
  model.nodes[2].x = Vec3(1.0, 0.0, 0.0);
  for (const int held : {0, 1}) model.springs.push_back({.a = 2, .b = held, .k = 100.0, .L0 = 1.25});
  return model;
}

class Node {
 public:
  double energy(double x, double z) {
    moveTo(*system_, state_, 2, Vec3(x, 0.0, z));
    return system_->totalEnergy(state_);
  }
  Vec3 force(double x, double z) {
    moveTo(*system_, state_, 2, Vec3(x, 0.0, z));
    return forceOn(*system_, state_, 2);
  }

 private:
  std::unique_ptr<engine::ModelSystem> system_ = engine::build(betweenTwo());
  State state_ = system_->initialState();
};

void addPlane(Figure& figure, Node& node) {
  Field field;
  field.x = linear(-1.3, 1.3, 261);
  field.y = linear(-1.1, 1.1, 221);
  for (const double z : field.y) {
    for (const double x : field.x) field.values.push_back(node.energy(x, z));
  }
  field.label = "E [J]";
  field.range = {0.0, 50.0};
  field.bands = 10;
  auto plane = figure.panel("z [m]");
  plane.heading("lines every 10 J; arrows: 0.25 m is 100 N").field(field).equalAxes();
  for (const double level : {10.0, 20.0, 30.0, 40.0}) {
    const Segments line = contour(field, level);
    plane.structure("", line.x, line.y);
  }
  Arrows arrows;
  for (const double z : linear(-0.8, 0.8, 5)) {
    for (const double x : linear(-1.2, 1.2, 7)) arrows.add(Vec3(x, 0.0, z), metresPerNewton * node.force(x, z));
  }
  arrows.addTo(plane, "force", 1);
  plane.points("rest", {-0.75, 0.75}, {0.0, 0.0}).colour(5).nodes("", {0.0, 0.0}, {-1.0, 1.0});
  plane.xRange(-1.3, 1.3).yRange(-1.1, 1.1);
}

/// The force that the engine calculates, and differences of its energy.
void addSlopes(Figure& figure, Node& node) {
  const double cut = 0.3, apart = 1e-4;
  std::vector<double> forceX, forceZ, slopeX, slopeZ;
  const std::vector<double> x = linear(-1.3, 1.3, 181), coarse = linear(-1.3, 1.3, 14);
  for (const double position : x) {
    forceX.push_back(node.force(position, cut).x());
    forceZ.push_back(node.force(position, cut).z());
  }
  for (const double position : coarse) {
    slopeX.push_back(-(node.energy(position + apart, cut) - node.energy(position - apart, cut)) / (2.0 * apart));
    slopeZ.push_back(-(node.energy(position, cut + apart) - node.energy(position, cut - apart)) / (2.0 * apart));
  }
  figure.panel("force [N]")
      .heading("on the line z = 0.3 m")
      .line("along x", x, forceX)
      .colour(0)
      .line("along z", x, forceZ)
      .colour(1)
      .points("−ΔE / Δx", coarse, slopeX)
      .colour(0)
      .points("−ΔE / Δz", coarse, slopeZ)
      .colour(1);
}

}  // namespace

/// Slide "Energía Elástica": the force is the negative gradient of the energy, by the engine's force and by differences
/// of its energy.
Figure gradient_field() {
  Node node;
  Figure figure("gradient_field",
                "The force is minus the gradient: downhill, straight across the lines of equal energy", "x [m]");
  figure.slide(2);
  addPlane(figure, node);
  addSlopes(figure, node);
  return figure;
}

}  // namespace muelle::plots::gradient_field
