#include "lab/hard_cases/variants/families.h"
#include "lab/hard_cases/variants/parts.h"

namespace muelle::hard_cases {

namespace {

Variant h01() {
  Variant v{.id = "H01", .name = "", .measured = "relative change of the energy", .model = oscillator(1.0)};
  v.duration = 1e4;
  v.bar = 0.1;
  v.steps = {0.1, 0.1, 0.1, 0.1, 1e-9};
  v.measure = Measure::Energy;
  v.error = [](const Finished& end) { return std::abs(end.energy() / 0.5 - 1.0); };
  v.modes = {mode(1.0, 1.0)};
  v.linear = true;
  return v;
}

Variant h02(int d) {
  Variant v{.id = "H02", .name = "d=" + std::to_string(d), .measured = "error of x at t = 1 s [m]"};
  v.model = oscillator(100.0, Damping::Projected, d);
  v.bar = 1e-4;
  v.steps = {1e-3, 1e-3, 1e-3, 1e-3, 1e-8};
  v.error = coordinate(0, reference("H02", "x(d=" + std::to_string(d) + ")"));
  v.modes = {{.stiffness = 100.0, .damping = static_cast<double>(d)}};
  v.linear = true;
  return v;
}

/// h omega = 1.99 and 2.01, at and beyond the limit of the methods that are stable up to 2.
Variant h03(double z, const std::string& name) {
  Variant v{
      .id = "H03", .name = name, .measured = "factor between the amplitude after 1000 steps and that of the start"};
  v.model = oscillator(1e4);
  const double h = z / 100.0;
  v.duration = 1000 * h;
  // The widest band of a method that is stable there: symplectic Euler keeps x^2 + y^2 - h omega x y, whose ellipse has
  // axes of the ratio sqrt((1 + z/2) / (1 - z/2)) = 19.97 at z = 1.99.
  v.bar = 20.0;
  v.steps = {h, h, h, h, 1e-6};
  v.measure = Measure::Amplitude;
  v.error = [](const Finished& end) { return amplitudeFactor(std::hypot(end.x(0)[0], end.v(0)[0] / 100.0)); };
  v.modes = {mode(100.0, 1.0)};
  v.linear = true;
  return v;
}

}  // namespace

std::vector<Variant> oscillatorVariants() { return {h01(), h02(2), h02(200), h03(1.99, "1.99"), h03(2.01, "2.01")}; }

}  // namespace muelle::hard_cases
