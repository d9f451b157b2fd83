#include "engine/analysis/stability.h"
#include "engine/integrators/catalogue.h"
#include "tools.h"

#include <cmath>

namespace muelle::plots::stiffness_ratio {

namespace {

/// Hard case H11 with any ratio: a stiff spring to a wall, a soft one after it, all the motion in the soft one.
engine::Model stiffAndSoft(double ratio) {
  engine::Model model;
  model.dimension = 1;
  model.nodes.resize(3);
  model.nodes[0].pinned = true;
  model.nodes[1].x[0] = 1.0;
  model.nodes[2].x[0] = 2.1;
  model.springs.push_back({.a = 1, .b = 0, .k = ratio, .L0 = 1.0});
  model.springs.push_back({.a = 2, .b = 1, .k = 1.0, .L0 = 1.0});
  return model;
}

/// Position of the outer node at the end; NaN when the run fails.
double endOf(const engine::ModelSystem& system, const std::string& method, double h, double duration) {
  const engine::RunResult result = run(system, method, h, duration, duration);
  return result.failed() ? NAN : system.position(result.last, 2)[0];
}

}  // namespace

/// "Which step?" An explicit method must follow the stiffest spring, though nothing moves there.
Figure stiffness_ratio() {
  const double duration = 10.0;
  std::vector<double> ratios, explicitSteps, implicitSteps, implicitErrors, explicitErrors;
  const auto verlet = engine::makeMethod("velocity_verlet");
  for (const double ratio : logarithmic(1.0, 1e6, 13)) {
    const auto system = engine::build(stiffAndSoft(ratio));
    const double limit = engine::stability(*system, *verlet, system->initialState()).largestStep;
    const double h = std::min(0.9 * limit, 1.0 / 60);
    const double exact = endOf(*system, "velocity_verlet", 0.02 * limit, duration);
    ratios.push_back(ratio);
    explicitSteps.push_back(duration / h);
    implicitSteps.push_back(duration * 60);
    explicitErrors.push_back(std::abs(endOf(*system, "velocity_verlet", h, duration) - exact));
    implicitErrors.push_back(std::abs(endOf(*system, "implicit_midpoint", 1.0 / 60, duration) - exact));
  }
  Figure figure("stiffness_ratio", "The stiffest spring sets the step of an explicit method, even when it stands still",
                "stiffness ratio of the two springs");
  figure.slide(2);
  figure.panel("steps for 10 s")
      .heading("what it costs")
      .linePoints("velocity Verlet", ratios, explicitSteps)
      .linePoints("implicit midpoint", ratios, implicitSteps)
      .logX()
      .logY();
  figure.panel("error at 10 s [m]")
      .heading("what comes out")
      .linePoints("velocity Verlet", ratios, explicitErrors)
      .linePoints("implicit midpoint", ratios, implicitErrors)
      .logX()
      .logY();
  return figure;
}

}  // namespace muelle::plots::stiffness_ratio
