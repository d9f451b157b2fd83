#include "drawing.h"
#include "tools.h"

#include <cmath>
#include <numbers>

namespace muelle::plots::hookes_law_3d {

namespace {

const double k = 100.0, L0 = 1.0;

/// Node a in space, on a spring to node b in the origin.
engine::Model spring() {
  engine::Model model;
  model.nodes.resize(2);
  model.nodes[0].pinned = true;
  model.nodes[1].x = Vec3(L0, 0.0, 0.0);
  model.springs.push_back({.a = 1, .b = 0, .k = k, .L0 = L0});
  return model;
}

Vec3 onCircle(double radius, double angle) { return radius * Vec3(std::cos(angle), 0.0, std::sin(angle)); }

}  // namespace

/// Slide "Ley de Hooke", in 3D: the force lies along the spring, and its size knows nothing but the distance.
Figure hookes_law_3d() {
  const double metresPerNewton = 1.0 / 125.0;
  const auto system = engine::build(spring());
  State state = system->initialState();
  const auto forceAt = [&](const Vec3& xa) {
    moveTo(*system, state, 1, xa);
    return forceOn(*system, state, 1);
  };

  Figure figure("hookes_law_3d", "Hooke's law in 3D: along the spring, towards the sphere of radius L₀", "xₐ [m]");
  figure.slide(2);
  Arrows pushed, pulled;
  std::vector<double> circleX, circleZ;
  for (int i = 0; i < 16; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / 16;
    pushed.add(onCircle(0.5, angle), metresPerNewton * forceAt(onCircle(0.5, angle)));
    pulled.add(onCircle(1.6, angle), metresPerNewton * forceAt(onCircle(1.6, angle)));
  }
  for (const double angle : linear(0.0, 2.0 * std::numbers::pi, 200)) {
    circleX.push_back(onCircle(L0, angle).x());
    circleZ.push_back(onCircle(L0, angle).z());
  }
  auto plane = figure.panel("zₐ [m]");
  plane.heading("force on node a: 1 m is 125 N; dashed: L = L₀");
  plane.reference("", circleX, circleZ).nodes("", {0.0}, {0.0}).note(0.03, 0.0, "b");
  pushed.addTo(plane, "compressed", 0);
  pulled.addTo(plane, "stretched", 1);
  plane.equalAxes().xRange(-1.8, 1.8).yRange(-1.8, 1.8);

  const std::vector<double> L = linear(0.1, 2.0, 20);
  std::vector<double> law;
  for (const double length : linear(0.0, 2.0, 20)) law.push_back(-k * (length - L0));
  auto size = figure.panel("F [N]");
  size.heading("force along the spring, in any direction").xLabel("distance L [m]");
  size.reference("−k (L − L₀)", linear(0.0, 2.0, 20), law);
  int colour = 0;
  for (const Vec3& direction : {Vec3(1, 0, 0), Vec3(0, 0, 1), Vec3(1, 1, 1)}) {
    std::vector<double> along;
    const Vec3 n = direction.normalized();
    for (std::size_t i = static_cast<std::size_t>(colour); i < L.size(); i += 3)
      along.push_back(forceAt(L[i] * n).dot(n));
    std::vector<double> lengths;
    for (std::size_t i = static_cast<std::size_t>(colour); i < L.size(); i += 3) lengths.push_back(L[i]);
    const char* names[] = {"x", "z", "(1, 1, 1)"};
    size.points(names[colour], lengths, along).colour(colour);
    ++colour;
  }
  size.note(0.45, 85, "pushed out").note(1.05, -85, "pulled back");
  return figure;
}

}  // namespace muelle::plots::hookes_law_3d
