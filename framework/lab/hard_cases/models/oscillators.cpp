#include "lab/hard_cases/models.h"
#include "lab/hard_cases/models/parts.h"

namespace muelle::hard_cases {

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

}  // namespace muelle::hard_cases
