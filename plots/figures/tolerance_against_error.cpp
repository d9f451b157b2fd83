#include "engine/integrators/catalogue.h"
#include "lab/hard_cases/models.h"
#include "lab/run/tolerance_sweep.h"
#include "tools.h"

#include <cmath>
#include <numbers>

namespace muelle::plots {

namespace {

struct Problem {
  const char* name;
  engine::Model model;
  double duration;  ///< [s]
};

/// Tolerances as the test of the same sweep has them: by the root of ten. Errors below 1e-13 are rounding.
void addSweeps(Figure::PanelBuilder& panel, const Problem& problem, bool named) {
  const auto system = engine::build(problem.model);
  const Trajectory exact = lab::runAtTolerance(*system, "dop853", 1e-14, problem.duration);
  int colour = 0;
  for (const std::string id : {"rkc2", "dormand_prince_5", "dop853", "nystrom8", "nystrom12"}) {
    const engine::MethodInfo& info = engine::methodInfo(id);
    std::vector<double> asked, got;
    for (int i = 4; i <= 22; ++i) {
      const double tolerance = std::pow(10.0, -0.5 * i);
      if (info.order < 4 && tolerance < 1e-8) break;  // too many steps for a figure
      asked.push_back(tolerance);
      got.push_back(lab::errorOver(*system, lab::runAtTolerance(*system, id, tolerance, problem.duration), exact));
    }
    panel.linePoints(named ? info.name : "", asked, got).colour(colour++);
  }
  panel.reference(named ? "" : "as asked for", {1e-11, 1e-2}, {1e-11, 1e-2}).heading(problem.name);
  panel.logX().logY().xRange(3e-12, 3e-2).yRange(1e-14, 10.0);
}

}  // namespace

/// "Which step?" What one gets for a tolerance: it bounds the error of a step, and a run's grows with their number; but
/// a tighter one never costs accuracy.
Figure tolerance_against_error() {
  Figure figure("tolerance_against_error",
                "A tighter tolerance never costs accuracy, but it is not the error of the run",
                "tolerance of a step, in parts of the motion");
  figure.slide(2);
  auto oscillator = figure.panel("error over the run, in parts of the motion");
  addSweeps(oscillator, {"oscillator, 100 periods", hard_cases::oscillator(100.0), 20.0 * std::numbers::pi}, true);
  auto pendulum = figure.panel("");
  addSweeps(pendulum, {"elastic pendulum, 10 s", hard_cases::regularPendulum(), 10.0}, false);
  return figure;
}

}  // namespace muelle::plots
