#include "engine/analysis/convergence.h"
#include "engine/integrators/catalogue.h"
#include "tools.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

namespace muelle::plots {

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

double errorAfter(const engine::ModelSystem& system, const std::string& id, double h, double duration) {
  const engine::RunResult result = run(system, id, h, duration, duration);
  if (result.failed()) return NAN;
  const double r = 0.8175, omega = 4.0;
  const Vec3 exact(r * std::cos(omega * duration), r * std::sin(omega * duration), -0.613125);
  return (system.position(result.last, 1) - exact).norm();
}

}  // namespace

/// "Which step?" Order p: halving the step divides the error by 2^p, until round-off.
Figure order_of_convergence() {
  const auto system = engine::build(conicalPendulum());
  const double duration = 2.0;
  Figure figure("order_of_convergence",
                "The slope is the order: with order 4, half the step leaves a sixteenth of the error", "step h [s]");
  figure.slide();
  auto panel = figure.panel("position error after 2 s [m]");
  panel.heading("in the key: the measured slope").logX().logY();
  for (const std::string id :
       {"symplectic_euler", "velocity_verlet", "runge_kutta_4", "dormand_prince_5", "kahan_li_8", "nystrom12"}) {
    std::vector<double> steps, errors;
    for (int n = 2; n <= 20000; n = std::max(n + 1, n * 7 / 5)) {
      const double h = duration / n;
      const double error = errorAfter(*system, id, h, duration);
      if (!(error < 2.0)) continue;
      steps.push_back(h);
      errors.push_back(error);
      if (error < 2e-14) break;
    }
    const engine::OrderFit fit = engine::fitOrder(steps, errors, 1e-15);
    // Too steep for a window in double precision: only its name.
    const std::string& method = engine::methodInfo(id).name;
    const std::string name = fit.found ? fmt::format("{}: {:.2f}", method, fit.order) : method;
    panel.linePoints(name, steps, errors);
  }
  panel.xRange(1e-4, 1.0).yRange(1e-15, 10.0);
  return figure;
}

}  // namespace muelle::plots
