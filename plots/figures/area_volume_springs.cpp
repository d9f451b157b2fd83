#include "drawing.h"
#include "tools.h"

#include <fmt/format.h>
#include <cmath>
#include <Eigen/Geometry>
#include <numbers>

namespace muelle::plots::area_volume_springs {

namespace {

/// A base held in the plane, and a tip turned over through it (hard case H15; in 3D its tetrahedron, whose base lies
/// in the plane of x and y). `stiffness` is that of the signed area or volume.
engine::Model turnedOver(int dimension, double stiffness) {
  engine::Model model;
  model.dimension = dimension;
  for (int i = 0; i < dimension; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / dimension;
    model.nodes.push_back({.x = 0.75 * Vec3(-std::cos(angle), -std::sin(angle), 0.0), .pinned = true});
    model.springs.push_back({.a = i, .b = dimension, .k = 10.0, .L0 = 1.25});
  }
  if (dimension == 2) model.nodes[0].x.y() = model.nodes[1].x.y() = 0.0;
  model.nodes.push_back({.x = Vec3(0.0, 0.0, -1.0), .m = 1.0});
  const Vec3 a = model.nodes[0].x, b = model.nodes[1].x;
  if (dimension == 2) model.areas.push_back({.k = stiffness, .A0 = 0.5 * (b - a).norm()});
  if (dimension == 3) {
    const double V0 = (b - a).cross(model.nodes[2].x - a).norm() / 6.0;
    model.volumes.push_back({.k = stiffness, .V0 = V0});
  }
  return model;
}

void addPanel(Figure& figure, int dimension, const std::vector<double>& stiffnesses) {
  auto landscape = figure.panel("energy [J]");
  landscape.heading(dimension == 2 ? "triangle with a signed area, k in N/m³"
                                   : "tetrahedron, signed volume, k in N/m⁵");
  const double most = 8.0;
  const std::vector<double> heights = linear(-1.5, 1.5, 301);
  for (const double k : stiffnesses) {
    const auto system = engine::build(turnedOver(dimension, k));
    State state = system->initialState();
    std::vector<double> energy;
    for (const double z : heights) {
      moveTo(*system, state, dimension, Vec3(0.0, 0.0, z));
      energy.push_back(system->totalEnergy(state));
    }
    const std::size_t last = heights.size() / 6;  // at -1 m, where the springs are as long as at rest
    if (energy[last] > most) {
      landscape.note(-1.2, 6.6, fmt::format("k = {}:", k))
          .note(-1.2, 5.95, fmt::format("{:.0f} J at −1 m", energy[last]));
    }
    landscape.line(k > 0.0 ? fmt::format("k = {}", k) : "springs alone", heights, energy);
  }
  landscape.yRange(0, most).note(-1.2, 7.4, "inside out").note(0.75, 7.4, "upright");
}

}  // namespace

/// Slide "Aplicaciones", generalised springs: lengths do not know inside from outside, a signed area or volume does.
Figure area_volume_springs() {
  Figure figure("area_volume_springs", "Springs are content inside out; a signed area or volume turns them back",
                "height of the tip over its base [m]");
  figure.slide(2);
  addPanel(figure, 2, {0.0, 3.0, 10.0});
  addPanel(figure, 3, {0.0, 20.0, 100.0});
  return figure;
}

}  // namespace muelle::plots::area_volume_springs
