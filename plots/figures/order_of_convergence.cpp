#include "engine/integrators/catalogue.h"
#include "tools.h"

#include <cmath>

namespace muelle::plots::order_of_convergence {

namespace {

/// A mass on a circle about the vertical, at the end of a spring: hard case H06, whose solution is known.
engine::Model conicalPendulum() {
  engine::Model model;
  model.gravity = {0.0, 0.0, -9.81};
  model.nodes.resize(2);
  model.nodes[0].pinned = true;
  model.nodes[1].x = {0.8175, 0.0, -0.613125};
  model.nodes[1].v = {0.0, 3.27, 0.0};
  model.springs.push_back({.a = 1, .b = 0, .k = 100.0, .L0 = 0.858375});
  return model;
}

constexpr double duration = 2.0;  // [s]

/// NaN where the run breaks off.
double errorAfter(const engine::ModelSystem& system, const std::string& id, double h) {
  const engine::RunResult result = run(system, id, h, duration, duration);
  if (result.failed()) return NAN;
  const double r = 0.8175, omega = 4.0;
  const Vec3 exact(r * std::cos(omega * duration), r * std::sin(omega * duration), -0.613125);
  return (system.position(result.last, 1) - exact).norm();
}

/// Errors with 4, 8, 16 ... steps, as far as the run stays cheap.
void addErrors(Figure::PanelBuilder& panel, const engine::ModelSystem& system, const std::string& id) {
  constexpr double mostError = 2.0;  // [m] about the circle's width: beyond it there is no answer
  constexpr int mostSteps = 1 << 17, mostEvaluations = 1 << 18;
  std::vector<double> steps, errors;
  for (int n = 4; n <= mostSteps && n * engine::methodInfo(id).stages <= mostEvaluations; n *= 2) {
    const double error = errorAfter(system, id, duration / n);
    if (!(error < mostError)) continue;
    steps.push_back(duration / n);
    errors.push_back(error);
  }
  panel.linePoints("", std::move(steps), std::move(errors));
}

}  // namespace

/// "Which step?" Order p: halving the step divides the error by 2^p, until round-off.
Figure order_of_convergence() {
  const auto system = engine::build(conicalPendulum());
  Figure figure("order_of_convergence",
                "The slope is the order p: half the step leaves 1/2ᵖ of the error, down to round-off", "step h [s]");
  figure.slide();
  auto panel = figure.panel("position error after 2 s [m]");
  panel.heading("from mark to mark the step halves").logX().logY().xRange(1e-5, 1).yRange(1e-17, 10);
  addErrors(panel, *system, "symplectic_euler");
  panel.nameAt(3e-5, 2e-6, "symplectic Euler").slope(1.2e-4, 2.5e-5, 4, 1, "p = 1");
  addErrors(panel, *system, "velocity_verlet");
  panel.nameAt(1e-4, 2e-9, "velocity Verlet").slope(5e-4, 4e-7, 4, 2, "p = 2");
  addErrors(panel, *system, "runge_kutta_4");
  panel.nameAt(1.1e-3, 4e-12, "classical Runge-Kutta").slope(4e-3, 3e-9, 4, 4, "p = 4");
  addErrors(panel, *system, "kahan_li_8");
  panel.nameAt(4.5e-2, 1e-12, "Kahan-Li 8").slope(6e-2, 2e-10, 2, 8, "p = 8");
  panel.note(1.1e-5, 1e-16, "round-off: smaller steps gain nothing");
  return figure;
}

}  // namespace muelle::plots::order_of_convergence
