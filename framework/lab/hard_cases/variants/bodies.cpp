#include "lab/hard_cases/variants/families.h"
#include "lab/hard_cases/variants/parts.h"

#include <algorithm>

namespace muelle::hard_cases {

namespace {

Variant h04Regular() {
  Variant v{.id = "H04", .name = "regular", .measured = "distance from the reference at t = 10 s [m]"};
  v.model = regularPendulum();
  v.duration = 10.0;
  v.bar = 1e-8;
  v.steps = {1e-3, 2e-3, 0.04, 1e-3, 1e-13};
  v.error = nodeAt(0, place("H04", "regular.t10.x1", "", "regular.t10.z1"));
  v.modes = {mode(10.0, 0.06), mode(3.0, 0.3)};
  v.sensitive = true;
  return v;
}

Variant h04Chaotic() {
  Variant v{.id = "H04", .name = "chaotic", .measured = "distance from the reference at t = 20 s [m]"};
  v.model = chaoticPendulum();
  v.duration = 20.0;
  v.bar = 1e-8;
  v.steps = {1e-3, 2e-3, 0.025, 1e-3, 1e-14};
  v.error = nodeAt(0, place("H04", "chaotic.t20.x1", "", "chaotic.t20.z1"));
  v.modes = {mode(5.4, 1.0), mode(3.1, 1.0)};
  v.sensitive = true;
  return v;
}

Variant h05() {
  constexpr int n = 1000;
  Variant v{.id = "H05", .name = "", .measured = "error of the mean height at t = 1 s [m]", .model = meanHeight(n)};
  v.bar = 1e-3;
  v.steps = {1e-3, 1e-3, 1e-2, 1e-3, 1e-9};
  v.error = [](const Finished& end) {
    double mean = 0.0;
    for (int i = 0; i < n; ++i) mean += end.x(i)[2] / n;
    return std::abs(mean - reference("H05", "hbar(1)"));
  };
  v.modes = {mode(20.0, 0.5)};
  v.linear = true;
  return v;
}

Variant h06() {
  Variant v{.id = "H06", .name = "", .measured = "distance from the circle's point at t = 10 s [m]"};
  v.model = conicalPendulum();
  v.duration = 10.0;
  v.bar = 1e-9;
  v.steps = {1e-3, 1e-3, 0.05, 1e-3, 1e-14};
  v.error = nodeAt(0, place("H06", "x(10)", "y(10)", "z(10)"));
  v.modes = {mode(4.0, 0.8)};
  v.sensitive = true;
  return v;
}

Variant h07() {
  Variant v{.id = "H07", .name = "projected", .measured = "relative change of the angular momentum in 5 s"};
  v.model = dumbbell(Damping::Projected);
  v.duration = 5.0;
  v.bar = 5e-8;  // RKC2 at its tolerance has 3e-8; BDF2, the next, loses (omega h)^4 / 2 a step, 3e-6
  v.steps = {1.0 / 600, 1.0 / 600, 1.0 / 600, 1.0 / 600, 1e-9};
  v.measure = Measure::AngularSpeed;
  v.error = [](const Finished& end) {
    return std::abs(end.system->angularMomentum(end.result.last)[2] / reference("H07", "Lz(0)") - 1.0);
  };
  v.modes = {mode(4.0, 1.0)};
  return v;
}

Variant h08() {
  Variant v{.id = "H08", .name = "", .measured = "largest distance of a node from its place at t = 10 s [m]"};
  v.model = triangle();
  v.duration = 10.0;
  v.bar = 1e-6;
  v.steps = {1.0 / 600, 1.0 / 600, 1.0 / 100, 1.0 / 600, 1e-11};
  v.error = [](const Finished& end) {
    double largest = 0.0;
    for (int i = 0; i < 3; ++i) {
      const std::string n = std::to_string(i);
      largest = std::max(largest, (end.x(i) - place("H08", "t10.x" + n, "t10.y" + n, "t10.z" + n)).norm());
    }
    return largest;
  };
  // Vibrations of sqrt(k/mu) = 12 and 17 /s, and the rotation.
  v.modes = {mode(12.0, 0.1), mode(17.0, 0.1), mode(1.0, 0.6)};
  v.sensitive = true;
  v.coupled = 3;
  return v;
}

}  // namespace

std::vector<Variant> bodyVariants() { return {h04Regular(), h04Chaotic(), h05(), h06(), h07(), h08()}; }

}  // namespace muelle::hard_cases
