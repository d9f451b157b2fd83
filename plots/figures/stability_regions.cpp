#include "engine/analysis/amplification.h"
#include "engine/integrators/catalogue.h"
#include "tools.h"

#include <cmath>

namespace muelle::plots::stability_regions {

namespace {

constexpr double mostDamping = 1.5, mostStep = 3.5;  // of what is shown

/// The least h omega from which on a step grows; NaN beyond what the picture shows.
double limitOf(engine::Amplification& amplification, double zeta) {
  const auto grows = [&](double z) { return amplification.growth(z * z, 2.0 * zeta * z) > 1.0 + 1e-9; };
  constexpr double apart = 0.02;
  constexpr int halvings = 25;
  double low = 0.0, high = apart;
  for (; !grows(high); high += apart) {
    if (high > mostStep) return NAN;
    low = high;
  }
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (low + high);
    (grows(middle) ? high : low) = middle;
  }
  return low;
}

void addLimits(Figure::PanelBuilder& panel, const std::string& id, int colour) {
  const auto method = engine::makeMethod(id);
  engine::Amplification amplification(*method);
  const std::vector<double> damping = linear(0.0, mostDamping, 301);
  std::vector<double> limits;
  for (const double zeta : damping) limits.push_back(limitOf(amplification, zeta));
  panel.line("", damping, limits).colour(colour);
}

}  // namespace

/// The largest step at which a damped oscillator does not grow: each method's own step, measured.
Figure stability_regions() {
  Figure figure("stability_regions",
                "Stable below the line: damping makes room for explicit Euler and takes it from symplectic Euler",
                "damping ratio ζ = d / (2mω)");
  figure.slide();
  auto panel = figure.panel("largest hω");
  panel.xRange(0, mostDamping).yRange(0, mostStep);
  addLimits(panel, "runge_kutta_4", 2);
  panel.nameAt(0.3, 3.1, "classical Runge-Kutta");
  addLimits(panel, "velocity_verlet", 3);
  panel.nameAt(0.96, 0.2, "velocity Verlet: 2(√(1 + 4ζ²) − 2ζ)");
  addLimits(panel, "symplectic_euler", 0);
  panel.nameAt(0.06, 2.15, "symplectic Euler: 2(√(1 + ζ²) − ζ)");
  addLimits(panel, "explicit_euler", 1);
  panel.nameAt(0.25, 0.3, "explicit Euler: 2ζ up to ζ = 1");
  addLimits(panel, "backward_euler", 4);
  panel.note(1.1, 3.1, "backward Euler: no limit");
  return figure;
}

}  // namespace muelle::plots::stability_regions
