#include "engine/integrators/catalogue.h"
#include "lab/hard_cases/models.h"
#include "lab/run/tolerance_sweep.h"
#include "tools.h"

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace muelle::plots::tolerance_against_error {

namespace {

struct Problem {
  const char* name;
  engine::Model model;
  double duration;  ///< [s]
};

/// Tolerances as the test of the same sweep has them: by the root of ten. Errors below 1e-13 are rounding.
void addSweeps(Figure::PanelBuilder& panel, const Problem& problem) {
  const auto system = engine::build(problem.model);
  const Trajectory exact = lab::runAtTolerance(*system, "dop853", 1e-14, problem.duration);
  const std::vector<std::pair<std::string, std::string>> methods = {{"rkc2", "RKC2"},
                                                                    {"dormand_prince_5", "DP5"},
                                                                    {"dop853", "DOP853"},
                                                                    {"nystrom8", "Nyström 8"},
                                                                    {"nystrom12", "Nyström 12"}};
  for (const auto& [id, name] : methods) {
    const engine::MethodInfo& info = engine::methodInfo(id);
    std::vector<double> asked, got;
    for (int i = 4; i <= 22; ++i) {
      const double tolerance = std::pow(10.0, -0.5 * i);
      if (info.order < 4 && tolerance < 1e-8) break;  // too many steps for a figure
      asked.push_back(tolerance);
      got.push_back(lab::errorOver(*system, lab::runAtTolerance(*system, id, tolerance, problem.duration), exact));
    }
    panel.linePoints(name, asked, got);
  }
  panel.reference("as asked for", {1e-11, 1e-2}, {1e-11, 1e-2}).heading(problem.name);
  panel.logX().logY().xRange(3e-12, 3e-2).yRange(1e-14, 1e2);
}

}  // namespace

/// "Which step?" What one gets for a tolerance: it bounds the error of a step, and a run's grows with their number; but
/// a tighter one costs no accuracy, but for a factor of 5 by chance.
Figure tolerance_against_error() {
  Figure figure("tolerance_against_error", "A tighter tolerance pays in accuracy, but it is not the error of the run",
                "tolerance of a step, in parts of the motion");
  figure.slide(2);
  auto oscillator = figure.panel("error over the run, in parts of the motion");
  addSweeps(oscillator, {"oscillator, 100 periods", hard_cases::oscillator(100.0), 20.0 * std::numbers::pi});
  oscillator.note(1.5e-11, 10.0, "RKC2: to 10⁻⁸, too many steps below");
  auto pendulum = figure.panel("");
  addSweeps(pendulum, {"elastic pendulum, 10 s", hard_cases::regularPendulum(), 10.0});
  return figure;
}

}  // namespace muelle::plots::tolerance_against_error
