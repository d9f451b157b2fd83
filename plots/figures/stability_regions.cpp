#include "engine/analysis/amplification.h"
#include "engine/integrators/catalogue.h"
#include "tools.h"

#include <cmath>

namespace muelle::plots {

namespace {

/// log10 of the growth a step over h omega and the damping ratio, cut at tenfold either way.
Field growthField(const std::string& id) {
  const auto method = engine::makeMethod(id);
  engine::Amplification amplification(*method);
  Field field;
  field.x = linear(0.02, 4.0, 200);
  field.y = linear(0.0, 2.0, 100);
  for (const double zeta : field.y) {
    for (const double z : field.x) {
      const double growth = amplification.growth(z * z, 2.0 * zeta * z);
      field.values.push_back(std::clamp(std::log10(growth), -1.0, 1.0));
    }
  }
  field.label = "log10 growth";
  field.range = {-1.0, 1.0};
  return field;
}

}  // namespace

/// Where a step makes a damped oscillator grow: each method's own step, measured.
Figure stability_regions() {
  Figure figure("stability_regions",
                "Right of the line a method makes grow what should decay; backward Euler has no line", "h omega");
  figure.slide(2);
  for (const std::string id : {"symplectic_euler", "runge_kutta_4", "dormand_prince_5", "backward_euler"}) {
    const Field field = growthField(id);
    // The rim: the first h omega that grows by more than rounding, for each damping.
    std::vector<double> rimX, rimY;
    for (std::size_t j = 0; j < field.y.size(); ++j) {
      for (std::size_t i = 0; i < field.x.size(); ++i) {
        if (field.values[j * field.x.size() + i] <= 1e-9) continue;
        rimX.push_back(field.x[i]);
        rimY.push_back(field.y[j]);
        break;
      }
    }
    auto panel = figure.panel("damping ratio");
    panel.heading(engine::methodInfo(id).name).field(field).xRange(0.0, 4.0).yRange(0.0, 2.0);
    if (!rimX.empty()) panel.line("", rimX, rimY).colour(1);
  }
  return figure;
}

}  // namespace muelle::plots
