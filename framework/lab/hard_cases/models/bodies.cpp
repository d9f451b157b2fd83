#include "lab/hard_cases/models.h"
#include "lab/hard_cases/models/parts.h"

namespace muelle::hard_cases {

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

}  // namespace muelle::hard_cases
