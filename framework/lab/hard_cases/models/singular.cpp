#include "lab/hard_cases/models.h"
#include "lab/hard_cases/models/parts.h"

namespace muelle::hard_cases {

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
  if (ka > 0.0) model.areas = {{.nodes = {1, 2, 0}, .k = ka, .A0 = 0.75}};
  return model;
}

}  // namespace muelle::hard_cases
