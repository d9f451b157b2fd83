#include "lab/hard_cases/variants/families.h"
#include "lab/hard_cases/variants/parts.h"

namespace muelle::hard_cases {

namespace {

Variant h22() {
  Variant v{.id = "H22", .name = "", .measured = "error of x at t = 2 s [m]", .model = pulse()};
  v.duration = 2.0;
  v.bar = 1e-12;
  v.steps = {1.0 / 60, 1.0 / 60, 1.0 / 60, 1.0 / 60, 1e-6};
  v.error = coordinate(0, reference("H22", "x(2)"));
  v.flightAcceleration = 1000.0;
  v.flightTime = 1e-3;
  return v;
}

Variant h23() {
  Variant v{.id = "H23", .name = "drag", .measured = "relative error of x at t = 1 s", .model = stiffDrag()};
  v.bar = 1e-3;
  v.steps = {1.0 / 60, 1.0 / 60, 1.0 / 60, 1.0 / 60, 1e-9};
  v.error = [](const Finished& end) { return std::abs(end.x(0)[0] / reference("H23", "drag.x(1)") - 1.0); };
  v.modes = {{.stiffness = 1.0,
              .amplitude = 0.0,
              .speed = 1.0,
              .drag = 1e4,
              .sensitivity = 1.0 / reference("H23", "drag.x(1)")}};
  v.linear = true;
  return v;
}

Variant h24() {
  Variant v{.id = "H24", .name = "", .measured = "bad steps and states that were accepted", .model = oscillator(1.0)};
  v.bar = 0.0;
  v.inputs = true;
  return v;
}

}  // namespace

std::vector<Variant> pulseAndDragVariants() { return {h22(), h23(), h24()}; }

}  // namespace muelle::hard_cases
