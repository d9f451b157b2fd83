#include "lab/hard_cases/variants/families.h"
#include "lab/hard_cases/variants/parts.h"

namespace muelle::hard_cases {

namespace {

Variant h13() {
  Variant v{.id = "H13", .name = "c crossing", .measured = "error of x at t = 5 s [m]", .model = crossingOscillator(3)};
  v.duration = 5.0;
  v.bar = 2e-7;  // Yoshida 4 has 1.6e-7, the largest of order 4
  v.steps = {1.0 / 600, 1.0 / 600, 1.0 / 100, 1.0 / 600, 1e-11};
  v.error = nodeAt(0, Vec3(reference("H13", "c.x(5)"), 0, 0));
  v.modes = {mode(10.0, 0.7)};
  v.sensitive = true;
  return v;
}

Variant h13Coincident() {
  Variant v{.id = "H13", .name = "a coincident", .measured = "distance that the nodes have moved in 0.1 s [m]"};
  v.model = coincidentNodes(0.0);
  v.duration = 0.1;
  v.bar = 1e-12;
  v.steps = {0.01, 0.01, 0.01, 0.01, 1e-6};
  v.error = [](const Finished& end) { return end.x(0).norm() + end.x(1).norm(); };
  return v;
}

Variant h14() {
  Variant v{.id = "H14", .name = "", .measured = "error of y at t = 3 s [m]", .model = buckling(100.0, 1e-6)};
  v.duration = 3.0;
  v.bar = 1e-8;
  v.steps = {1e-3, 1e-3, 0.01, 1e-3, 1e-14};
  v.error = [](const Finished& end) { return std::abs(end.x(0)[1] - reference("H14", "t3.y2")); };
  // Growth at 7.07 /s from 1e-6 m until the ring is reached after 1.9 s; then the way back to the saddle.
  v.modes = {{.stiffness = -50.0, .amplitude = 1e-6, .duration = 1.9}};
  v.sensitive = true;
  return v;
}

Variant h14Stiff() {
  Variant v{
      .id = "H14", .name = "stiff", .measured = "distance from the ring after 6 s [m]", .model = buckling(1e6, 1e-6)};
  v.duration = 6.0;
  v.bar = 1e-3;
  v.steps = {1.0 / 60, 1.0 / 60, 1.0 / 60, 1.0 / 60, 1e-6};
  v.measure = Measure::Size;
  v.error = [](const Finished& end) { return std::abs(std::hypot(end.x(0)[1], end.x(0)[2]) - 0.6); };
  // On the ring two springs give 2 k 0.6^2 across and 2 k 0.8^2 along the line.
  v.modes = {mode(std::sqrt(2e6 * 0.36), 0.6), mode(std::sqrt(2e6 * 0.64), 1e-9)};
  v.stiffest = std::sqrt(2e6);
  return v;
}

Variant h15() {
  Variant v{.id = "H15", .name = "", .measured = "error of y at t = 1 s [m]", .model = invertedTriangle(100.0)};
  v.bar = 1e-9;
  v.steps = {1e-3, 5e-4, 5e-3, 1e-3, 1e-13};
  v.error = [](const Finished& end) { return std::abs(end.x(0)[1] - reference("H15", "y(1)")); };
  v.modes = {mode(std::sqrt(100.0 * 0.5625 + 20.0), 2.0)};
  v.sensitive = true;
  return v;
}

}  // namespace

std::vector<Variant> singularVariants() { return {h13(), h13Coincident(), h14(), h14Stiff(), h15()}; }

}  // namespace muelle::hard_cases
