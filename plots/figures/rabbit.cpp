#include "base/build_paths.h"
#include "lab/run/run_scene.h"
#include "tools.h"

#include <fmt/format.h>
#include <algorithm>
#include <Eigen/Geometry>
#include <limits>

namespace muelle::plots::rabbit {

namespace {

/// Edges of the surface that the viewer sees, from the side (along +y), with gaps between the triangles.
void addSide(Figure::PanelBuilder& panel, const engine::ModelSystem& system, const engine::Part& part,
             const State& state) {
  const double gap = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> x, z;
  for (const engine::Triangle& triangle : part.triangles) {
    const Vec3 a = system.position(state, triangle[0]), b = system.position(state, triangle[1]),
               c = system.position(state, triangle[2]);
    if ((b - a).cross(c - a).y() > 0.0) continue;
    for (const Vec3& corner : {a, b, c, a}) {
      x.push_back(corner.x());
      z.push_back(corner.z());
    }
    x.push_back(gap);
    z.push_back(gap);
  }
  panel.mesh("", std::move(x), std::move(z));
}

}  // namespace

/// Slide "Contacto Externo": a rabbit as the lecture's, squeezed between two planes until it no longer moves.
Figure rabbit() {
  engine::Scene scene =
      engine::readScene(std::filesystem::path(build_paths::source) / "framework/engine/scenes/rabbit_squeezed.toml");
  const engine::Obstacle& plate = scene.model.obstacles.at(1);
  scene.duration = scene.outputInterval = 1.5;  // the plate stops at 0.6 s; then the motion dies
  const lab::SceneRun squeezed = lab::runScene(scene);
  const engine::ModelSystem& system = *squeezed.system;

  double fastest = 0.0;
  for (int i = 0; i < system.nodeCount(); ++i) {
    fastest = std::max(fastest, system.velocity(squeezed.result.last, i).norm());
  }

  Figure figure("rabbit", "The squeezed rabbit has come to rest: springs, weight and planes balance", "x [m]");
  figure.slide(2);
  for (const auto& [state, name] :
       {std::pair(system.initialState(), std::string("before")),
        std::pair(squeezed.result.last, fmt::format("squeezed: fastest node {:.2f} mm/s", 1000.0 * fastest))}) {
    auto panel = figure.panel("height [m]");
    panel.heading(name).equalAxes().yRange(-0.01, 0.2).xRange(-0.12, 0.12);
    addSide(panel, system, scene.parts.front(), state);
    const double height = plate.centre.z() + plate.velocity.z() * std::min(state.t, plate.stopTime);
    panel.reference("", {-0.12, 0.12}, {height, height}).reference("", {-0.12, 0.12}, {0.0, 0.0});
  }
  return figure;
}

}  // namespace muelle::plots::rabbit
