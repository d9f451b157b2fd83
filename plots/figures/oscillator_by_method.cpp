#include "engine/integrators/catalogue.h"
#include "tools.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace muelle::plots::oscillator_by_method {

namespace {

// x0 = 1 m and omega = 1 /s, so that metres and m/s are x / x0 and v / (omega x0), and h is h omega.
constexpr double phaseStep = 0.3;
constexpr int stepsOfTwoPeriods = 42;                         // 4 pi / 0.3 = 41.9
constexpr int stepsToPeriod99 = 2053, stepsOfPeriods = 2094;  // 98 and 100 times 2 pi / 0.3
constexpr double mostShown = 3.0;                             // times the exact orbit

/// The states after steps `from` to `to`.
struct Orbit {
  std::vector<double> x, v;
  double leavesAt = 0.0;  ///< omega t of the first state outside the picture, the orbit's last; 0: none
};

Orbit orbitOf(const std::string& method, int from, int to) {
  const auto system = engine::build(oscillator(1.0, 1.0, 1.0));
  const Trajectory path = run(*system, method, phaseStep, phaseStep * to).trajectory;
  const std::vector<double> x = path.position(0), v = path.velocity(0);
  Orbit orbit;
  for (auto i = static_cast<std::size_t>(from); i < x.size(); ++i) {
    orbit.x.push_back(x[i]);
    orbit.v.push_back(v[i]);
    if (std::max(std::abs(x[i]), std::abs(v[i])) <= mostShown) continue;
    orbit.leavesAt = path.t[i];
    break;
  }
  return orbit;
}

/// Goes round as the motion does: x = cos, v = -sin.
void addExact(Figure::PanelBuilder& panel, double nameAbove) {
  std::vector<double> x, v;
  for (const double angle : linear(0.0, 2.0 * std::numbers::pi, 200)) {
    x.push_back(std::cos(angle));
    v.push_back(-std::sin(angle));
  }
  panel.reference("", std::move(x), std::move(v)).nameAt(0.0, nameAbove, "exact", true);
}

void addDrifting(Figure::PanelBuilder panel) {
  panel.heading("hω = 0.3, the first two periods").equalAxes();
  panel.xRange(-mostShown, mostShown).yRange(-mostShown, mostShown);
  addExact(panel, 1.3);
  const Orbit out = orbitOf("explicit_euler", 0, stepsOfTwoPeriods);
  const Orbit in = orbitOf("backward_euler", 0, stepsOfTwoPeriods);
  panel.linePoints("", out.x, out.v).colour(1).nameAt(-2.95, 2.7, "explicit Euler");
  panel.nameAt(-2.95, 2.3, fmt::format("leaves the picture at ωt = {:.1f}", out.leavesAt));
  panel.linePoints("", in.x, in.v).colour(0).nameAt(-2.95, -2.3, "backward Euler");
  panel.structure("", {-1.7, -0.62}, {-2.1, -0.42});  // from the name to its curve
}

/// What symplectic Euler keeps of x = 1, v = 0: the ellipse x^2 - h omega x v + v^2 = 1.
void addKeptEllipse(Figure::PanelBuilder& panel) {
  std::vector<double> x, v;
  for (const double angle : linear(0.0, 2.0 * std::numbers::pi, 200)) {
    const double c = std::cos(angle), s = std::sin(angle), radius = 1.0 / std::sqrt(1.0 - phaseStep * c * s);
    x.push_back(radius * c);
    v.push_back(radius * s);
  }
  panel.structure("", std::move(x), std::move(v));
}

void addStaying(Figure::PanelBuilder panel) {
  panel.heading("hω = 0.3, periods 99 and 100").equalAxes().xRange(-1.4, 1.4).yRange(-1.4, 1.4);
  addExact(panel, 1.18);
  addKeptEllipse(panel);
  const Orbit oval = orbitOf("symplectic_euler", stepsToPeriod99, stepsOfPeriods);
  const Orbit circle = orbitOf("velocity_verlet", stepsToPeriod99, stepsOfPeriods);
  panel.points("", oval.x, oval.v).colour(2).nameAt(0.0, 0.17, "symplectic Euler", true);
  panel.points("", circle.x, circle.v).colour(3).nameAt(0.0, -0.1, "velocity Verlet", true);
}

}  // namespace

/// Slide "Receta para una Simulación", discretisation: the same oscillator, the same step, and what each method makes
/// of its orbit in the phase plane.
Figure oscillator_by_method() {
  Figure figure("oscillator_by_method",
                "Explicit Euler gains energy, backward Euler loses it; symplectic methods keep to one orbit", "x / x₀");
  figure.slide(2);
  addDrifting(figure.panel("v / (ω x₀)"));
  addStaying(figure.panel("v / (ω x₀)"));
  return figure;
}

}  // namespace muelle::plots::oscillator_by_method
