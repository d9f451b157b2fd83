#include "lab/hard_cases/variants/families.h"
#include "lab/hard_cases/variants/parts.h"

#include <fmt/format.h>
#include <algorithm>

namespace muelle::hard_cases {

namespace {

/// The cloth with stiffness k; `prefix` of its references.
Variant h16(double k, const std::string& name, const std::string& prefix, const Steps& steps) {
  Variant v{.id = "H16", .name = name, .measured = "largest error of nodes 44 and 99 at t = 0.5 s [m]"};
  v.model = cloth(k);
  v.duration = 0.5;
  v.bar = 1e-2;  // what one sees: the case's own bar, to be met in real time
  v.steps = steps;
  v.error = [prefix](const Finished& end) {
    double largest = 0.0;
    for (const int node : {44, 99}) {
      const auto named = [&](const char* axis) { return fmt::format("{}{}{}", prefix, axis, node); };
      largest = std::max(largest, (end.x(node) - place("H16", named("x"), named("y"), named("z"))).norm());
    }
    return largest;
  };
  // The fall about the hung edge, as that of a hanging chain of 0.9 m let go level: modes J0(z sqrt(s/L)) of
  // z/2 sqrt(g/L) with the zeros z of J0, and what of 1 - s/L each has. And the shortest waves: 2 sqrt(k/m) along both
  // axes and the diagonals, 3400 /s with k = 1000. The damper of a spring d = 0.01 kg/s = k (d/k) adds omega^2 d/k.
  const double top = 3400.0 * std::sqrt(k / 1000.0);
  v.modes = {mode(3.97, 1.0),
             mode(9.11, 0.126),
             mode(14.3, 0.041),
             {.stiffness = top * top, .amplitude = 1e-2 / k, .damping = 0.01 / k * top * top}};
  v.sensitive = true;
  v.realTime = true;
  v.coupled = 342;
  v.stretch =
      0.5 * 0.9 * 0.1 * 9.81 / (10.0 * k) / 0.1;  // ten threads of nine springs carry 0.1 kg, half on the average
  return v;
}

}  // namespace

std::vector<Variant> clothVariants() {
  return {h16(1e3, "", "t0.5.", {1.0 / 4000, 1.0 / 4000, 1.0 / 4000, 1.0 / 500, 1e-4}),
          h16(1e4, "k=1e4", "k=1e4.t0.5.", {1.0 / 8000, 1.0 / 8000, 1.0 / 4000, 1.0 / 500, 1e-4, 1.0 / 2000}),
          h16(1e5, "k=1e5", "k=1e5.t0.5.", {1.0 / 25000, 1.0 / 25000, 1.0 / 12500, 1.0 / 500, 1e-4, 1.0 / 2000}),
          h16(1e6, "k=1e6", "k=1e6.t0.5.", {1.0 / 80000, 1.0 / 80000, 1.0 / 40000, 1.0 / 500, 1e-4, 1.0 / 2000})};
}

}  // namespace muelle::hard_cases
