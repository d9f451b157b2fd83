#include "lab/hard_cases/models.h"
#include "lab/hard_cases/models/parts.h"

#include <cmath>
#include <numbers>

namespace muelle::hard_cases {

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

}  // namespace muelle::hard_cases
