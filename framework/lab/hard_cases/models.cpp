#include "lab/hard_cases/models.h"

#include <cmath>
#include <numbers>

namespace muelle::hard_cases {

namespace {

using engine::ModelNode;
using engine::ModelSpring;
using engine::Obstacle;

constexpr double g = 9.81;

ModelNode at(const Vec3& x, double m = 1.0, const Vec3& v = Vec3::Zero()) { return {.x = x, .v = v, .m = m}; }
ModelNode anchor(const Vec3& x) { return {.x = x, .pinned = true}; }

Model inPlane() {
  Model model;
  model.dimension = 2;
  model.gravity = Vec3(0, 0, -g);
  return model;
}

Model onLine(double gravity = 0.0) {
  Model model;
  model.dimension = 1;
  model.gravity = Vec3(-gravity, 0, 0);
  return model;
}

Obstacle floorOfLine(double k, double d) {
  Obstacle ground;
  ground.normal = Vec3::UnitX();
  ground.material.k = k;
  ground.material.d = d;
  return ground;
}

}  // namespace

Model oscillator(double k, Damping kind, double d) {
  Model model = onLine();
  model.nodes = {at(Vec3::UnitX()), anchor(Vec3::Zero())};
  ModelSpring spring{.a = 0, .b = 1, .k = k, .L0 = 0.0};
  if (kind == Damping::Relative) spring.dRelative = d;
  if (kind == Damping::Projected) spring.dProjected = d;
  if (kind == Damping::Drag) model.nodes[0].drag = d;
  model.springs = {spring};
  return model;
}

Model elasticPendulum(double k, double x, double z) {
  Model model = inPlane();
  model.nodes = {at(Vec3(x, 0, z)), anchor(Vec3::Zero())};
  model.springs = {{.a = 0, .b = 1, .k = k, .L0 = 1.0}};
  return model;
}

Model regularPendulum() { return elasticPendulum(100.0, 0.3, -1.0); }
Model chaoticPendulum() { return elasticPendulum(29.43, 0.9, 0.9); }

Model meanHeight(int n) {
  Model model;
  engine::ModelProperty property{.nodes = {}, .weights = {}, .k = 400.0, .p0 = 1.0};
  for (int i = 0; i < n; ++i) {
    model.nodes.push_back(at(Vec3(0, 0, static_cast<double>(i) / n), 1.0 / n));
    property.nodes.push_back(i);
    property.weights.push_back(Vec3(0, 0, 1.0 / n));
  }
  model.properties = {property};
  return model;
}

Model conicalPendulum() {
  Model model;
  model.gravity = Vec3(0, 0, -g);
  model.nodes = {at(Vec3(0.8175, 0, -0.613125), 1.0, Vec3(0, 3.27, 0)), anchor(Vec3::Zero())};
  model.springs = {{.a = 0, .b = 1, .k = 100.0, .L0 = 0.858375}};
  return model;
}

Model dumbbell(Damping kind) {
  Model model;
  ModelSpring spring{.a = 0, .b = 1, .k = 252.0, .L0 = 1.0};
  if (kind == Damping::Drag) {
    model.nodes = {at(Vec3(0.525, 0, 0), 1.5, Vec3(0, 2.1, 0)), at(Vec3(-0.525, 0, 0), 1.5, Vec3(0, -2.1, 0))};
    for (ModelNode& node : model.nodes) node.drag = 0.6;
  } else {
    model.nodes = {at(Vec3(0.7875, 0, 0), 1.0, Vec3(0, 3.15, 0)), at(Vec3(-0.2625, 0, 0), 3.0, Vec3(0, -1.05, 0))};
  }
  if (kind == Damping::Relative) spring.dRelative = 0.3;
  if (kind == Damping::Projected) spring.dProjected = 0.3;
  model.springs = {spring};
  return model;
}

Model vibratingDumbbell() {
  Model model;
  model.nodes = {at(Vec3(0.9, 0, 0), 1.0, Vec3(0, 3.6, 0)), at(Vec3(-0.3, 0, 0), 3.0, Vec3(0, -1.2, 0))};
  model.springs = {{.a = 0, .b = 1, .k = 252.0, .L0 = 1.0, .dProjected = 3.0}};
  return model;
}

Model triangle(bool gravity) {
  Model model;
  if (gravity) model.gravity = Vec3(0, 0, -g);
  model.nodes = {at(Vec3(0, 0, 0), 1.0, Vec3(0.5, 0, 1)), at(Vec3(1.2, 0, 0), 2.0, Vec3(-0.3, 0.8, 0)),
                 at(Vec3(0.4, 0.9, 0.1), 3.0, Vec3(0, -0.5, 0.2))};
  model.springs = {{.a = 0, .b = 1, .k = 100.0, .L0 = 1.0},
                   {.a = 1, .b = 2, .k = 200.0, .L0 = 1.0},
                   {.a = 2, .b = 0, .k = 150.0, .L0 = 1.0}};
  return model;
}

Model hangingChain(double dragPerMass) {
  constexpr int n = 100;
  Model model = onLine(g);
  for (int i = 0; i < n; ++i) {
    model.nodes.push_back(at(Vec3(-0.01 * (i + 1), 0, 0), 0.01));
    model.nodes.back().drag = dragPerMass * 0.01;
    model.springs.push_back({.a = i == 0 ? n : i - 1, .b = i, .k = 1000.0, .L0 = 0.01});
  }
  model.nodes.push_back(anchor(Vec3::Zero()));
  return model;
}

Model catenary(double sag, double dragPerMass) {
  constexpr int springs = 20, n = springs - 1;
  Model model = inPlane();
  for (int i = 0; i < n; ++i) {
    const double s = (i + 1.0) / springs;
    model.nodes.push_back(at(Vec3(s, 0, -4.0 * sag * s * (1.0 - s)), 0.1));
    model.nodes.back().drag = dragPerMass * 0.1;
  }
  model.nodes.push_back(anchor(Vec3::Zero()));
  model.nodes.push_back(anchor(Vec3::UnitX()));
  for (int j = 0; j < springs; ++j) {
    model.springs.push_back({.a = j == 0 ? n : j - 1, .b = j == n ? n + 1 : j, .k = 1000.0, .L0 = 0.06});
  }
  return model;
}

namespace {

/// 50 nodes, `spacing` apart along x, between anchors, k = 100, L0 = 1.
Model chainBetweenAnchors(Model model, double spacing) {
  constexpr int n = 50;
  for (int i = 1; i <= n; ++i) model.nodes.push_back(at(Vec3(spacing * i, 0, 0)));
  model.nodes.push_back(anchor(Vec3::Zero()));
  model.nodes.push_back(anchor(Vec3(spacing * (n + 1), 0, 0)));
  for (int j = 0; j <= n; ++j) {
    model.springs.push_back({.a = j == 0 ? n : j - 1, .b = j == n ? n + 1 : j, .k = 100.0, .L0 = 1.0});
  }
  return model;
}

}  // namespace

Model longitudinalChain() {
  Model model = chainBetweenAnchors(onLine(), 1.0);
  for (int i = 1; i <= 50; ++i) {
    const double s = i * std::numbers::pi / 51.0;
    model.nodes[static_cast<std::size_t>(i - 1)].x[0] += 0.01 * (std::sin(s) + std::sin(50.0 * s));
  }
  return model;
}

Model transverseChain() {
  Model model;
  model.dimension = 2;
  model = chainBetweenAnchors(model, 1.1);
  for (int i = 1; i <= 50; ++i) {
    model.nodes[static_cast<std::size_t>(i - 1)].x[2] = 1e-6 * std::sin(i * std::numbers::pi / 51.0);
  }
  return model;
}

Model stiffnessRatio() {
  Model model = onLine();
  model.nodes = {at(Vec3(1, 0, 0)), at(Vec3(2.1, 0, 0)), anchor(Vec3::Zero())};
  model.springs = {{.a = 0, .b = 2, .k = 1e6, .L0 = 1.0}, {.a = 0, .b = 1, .k = 1.0, .L0 = 1.0}};
  return model;
}

Model heavyBelowLight() {
  Model model = onLine(g);
  model.nodes = {at(Vec3(-1, 0, 0)), at(Vec3(-2, 0, 0), 1e6), anchor(Vec3::Zero())};
  model.springs = {{.a = 0, .b = 2, .k = 1e8, .L0 = 1.0}, {.a = 0, .b = 1, .k = 1e8, .L0 = 1.0}};
  return model;
}

Model heavySwing() {
  Model model = inPlane();
  model.nodes = {at(Vec3(0.6, 0, -0.8)), at(Vec3(1.2, 0, -1.6), 1e6), anchor(Vec3::Zero())};
  model.springs = {{.a = 0, .b = 2, .k = 1e8, .L0 = 1.0}, {.a = 0, .b = 1, .k = 1e8, .L0 = 1.0}};
  return model;
}

Model coincidentNodes(double distance) {
  Model model;
  model.nodes = {at(Vec3::Zero()), at(Vec3(distance, 0, 0))};
  model.springs = {{.a = 0, .b = 1, .k = 100.0, .L0 = 1.0}};
  return model;
}

Model zeroLengthOscillator() {
  Model model;
  model.nodes = {at(Vec3::Zero(), 1.0, Vec3(1, 2, -2)), anchor(Vec3::Zero())};
  model.springs = {{.a = 0, .b = 1, .k = 100.0, .L0 = 0.0}};
  return model;
}

Model crossingOscillator(int dimension) {
  Model model;
  model.dimension = dimension;
  model.springsCross = true;
  model.nodes = {at(Vec3(1.2, 0, 0)), anchor(Vec3::Zero())};
  model.springs = {{.a = 0, .b = 1, .k = 100.0, .L0 = 0.5}};
  return model;
}

Model buckling(double k, double offset) {
  Model model;
  model.nodes = {at(Vec3(0, offset, 0)), anchor(Vec3(-0.8, 0, 0)), anchor(Vec3(0.8, 0, 0))};
  model.springs = {{.a = 1, .b = 0, .k = k, .L0 = 1.0}, {.a = 2, .b = 0, .k = k, .L0 = 1.0}};
  return model;
}

Model invertedTriangle(double ka, double y) {
  Model model;
  model.dimension = 2;
  model.plane = {0, 1};
  model.nodes = {at(Vec3(0, y, 0)), anchor(Vec3(-0.75, 0, 0)), anchor(Vec3(0.75, 0, 0))};
  model.springs = {{.a = 1, .b = 0, .k = 10.0, .L0 = 1.25}, {.a = 2, .b = 0, .k = 10.0, .L0 = 1.25}};
  if (ka > 0.0) model.areas = {{.a = 1, .b = 2, .c = 0, .k = ka, .A0 = 0.75}};
  return model;
}

Model cloth(double k, double d) {
  constexpr int side = 10;
  Model model;
  model.gravity = Vec3(0, 0, -g);
  const auto index = [](int i, int j) { return side * j + i; };
  for (int j = 0; j < side; ++j) {
    for (int i = 0; i < side; ++i) model.nodes.push_back(at(Vec3(0.1 * i, 0.1 * j, 0), 0.001));
  }
  model.nodes[0].pinned = model.nodes[9].pinned = true;
  const auto join = [&](int a, int b, double L0) {
    model.springs.push_back({.a = a, .b = b, .k = k, .L0 = L0, .dProjected = d});
  };
  for (int j = 0; j < side; ++j) {
    for (int i = 0; i < side; ++i) {
      if (i + 1 < side) join(index(i, j), index(i + 1, j), 0.1);
      if (j + 1 < side) join(index(i, j), index(i, j + 1), 0.1);
      if (i + 1 == side || j + 1 == side) continue;
      join(index(i, j), index(i + 1, j + 1), 0.1 * std::numbers::sqrt2);
      join(index(i + 1, j), index(i, j + 1), 0.1 * std::numbers::sqrt2);
    }
  }
  return model;
}

Model bouncingBall() {
  Model model = onLine(g);
  model.nodes = {at(Vec3(1, 0, 0))};
  model.obstacles = {floorOfLine(1e5, 0.0)};
  return model;
}

Model bouncingBallWithoutGravity() {
  Model model = onLine();
  model.nodes = {at(Vec3(0.5, 0, 0), 1.0, Vec3(-1, 0, 0))};
  model.obstacles = {floorOfLine(1e5, 0.0)};
  return model;
}

Model restingBall(double drag) {
  Model model = onLine(g);
  model.nodes = {at(Vec3::Zero())};
  model.nodes[0].drag = drag;
  model.obstacles = {floorOfLine(1e4, 0.0)};
  return model;
}

Model stack(double k, double top, double dragPerMass) {
  constexpr int n = 10;
  Model model = onLine(g);
  for (int i = 0; i < n; ++i) {
    const double m = i + 1 == n ? top : 1.0;
    model.nodes.push_back(at(Vec3(0.1 * i, 0, 0), m));
    model.nodes.back().drag = dragPerMass * m;
    if (i > 0) model.springs.push_back({.a = i - 1, .b = i, .k = k, .L0 = 0.1, .unilateral = true});
  }
  model.obstacles = {floorOfLine(k, 0.0)};
  return model;
}

Model tunnelling() {
  Model model = onLine();
  model.nodes = {at(Vec3(-1, 0, 0), 1.0, Vec3(100, 0, 0))};
  Obstacle slab;
  slab.kind = Obstacle::Kind::Box;
  slab.name = "slab";
  slab.centre = Vec3(0.005, 0, 0);
  slab.halfSize = Vec3(0.005, 1, 1);
  slab.material.k = 4e8;
  model.obstacles = {slab};
  return model;
}

Model incline(double degrees, double speed) {
  constexpr double k = 1e6;
  const double angle = degrees * std::numbers::pi / 180.0;
  const Vec3 normal(std::sin(angle), 0, std::cos(angle)), along(std::cos(angle), 0, -std::sin(angle));
  Model model = inPlane();
  model.nodes = {at(-g * std::cos(angle) / k * normal, 1.0, speed * along)};
  Obstacle plane;
  plane.name = "incline";
  plane.normal = normal;
  plane.material.k = k;
  plane.material.mu = 0.5;
  plane.material.kTangential = 1e7;
  plane.material.dTangential = 2.0 * std::sqrt(1e7);
  model.obstacles = {plane};
  return model;
}

double downhill(const Vec3& position, const Vec3& start, double degrees) {
  const double angle = degrees * std::numbers::pi / 180.0;
  return (position - start).dot(Vec3(std::cos(angle), 0, -std::sin(angle)));
}

Model overdampedContact() {
  Model model = onLine(g);
  model.nodes = {at(Vec3(1, 0, 0))};
  model.obstacles = {floorOfLine(1e4, 1e4)};
  return model;
}

Model pulse() {
  Model model = onLine();
  model.nodes = {at(Vec3::Zero())};
  model.externalForces = {
      {.nodes = {0},
       .force = [](double, int segment) -> Vec3 { return segment == 1 ? Vec3(1000, 0, 0) : Vec3::Zero(); },
       .times = {1.0, 1.001}}};
  return model;
}

Model stiffDrag() {
  Model model = onLine();
  model.nodes = {at(Vec3::Zero(), 1.0, Vec3::UnitX()), anchor(Vec3::Zero())};
  model.nodes[0].drag = 1e4;
  model.springs = {{.a = 0, .b = 1, .k = 1.0, .L0 = 0.0}};
  return model;
}

Model stiffPair() {
  Model model = onLine();
  model.nodes = {at(Vec3::Zero(), 1.0, Vec3::UnitX()), at(Vec3::UnitX())};
  model.springs = {{.a = 0, .b = 1, .k = 1.0, .L0 = 1.0, .dRelative = 1e4}};
  return model;
}

}  // namespace muelle::hard_cases
