#include "lab/hard_cases/models.h"
#include "lab/hard_cases/models/parts.h"

namespace muelle::hard_cases {

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
