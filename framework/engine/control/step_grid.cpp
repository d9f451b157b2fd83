#include "engine/control/step_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace muelle::engine {

double timeRounding(double a, double b) {
  return 8.0 * std::numeric_limits<double>::epsilon() * std::max(std::abs(a), std::abs(b));
}

StopTimes::StopTimes(double start, double end, const std::vector<double>& declared,
                     const std::vector<double>& outputs) {
  for (const double t : declared) stops_.push_back({t, true, false});
  for (const double t : outputs) stops_.push_back({t, false, true});
  stops_.push_back({end, false, true});
  std::erase_if(stops_, [&](const Stop& stop) { return stop.t <= start || stop.t > end; });
  std::stable_sort(stops_.begin(), stops_.end(), [](const Stop& a, const Stop& b) { return a.t < b.t; });
  std::vector<Stop> merged;
  for (const Stop& stop : stops_) {
    const bool same = !merged.empty() && stop.t - merged.back().t <= timeRounding(stop.t, merged.back().t);
    if (!same) {
      merged.push_back(stop);
      continue;
    }
    // A declared time is kept to the last bit: the system compares with it.
    if (stop.declared) merged.back().t = stop.t;
    merged.back().declared |= stop.declared;
    merged.back().output |= stop.output;
  }
  stops_ = std::move(merged);
}

PlannedStep TimeGrid::plan(double t, const StopTimes::Stop& stop) const {
  PlannedStep step{point(next_), h_, false, true};
  const double rounding = timeRounding(stop.t, t);
  // A stop that differs from the grid point by rounding is that point; a sliver of a step would only add rounding.
  const double near = 1e-9 * h_ + rounding;
  if (stop.t <= step.t + near) {
    step.reachesGrid = std::abs(stop.t - step.t) <= near;
    step.reachesStop = true;
    step.t = stop.t;
  }
  const double rest = step.t - t;
  const bool whole = onGrid_ && std::abs(rest - h_) <= 1e-12 * h_ + rounding;
  step.length = whole ? h_ : rest;
  return step;
}

void TimeGrid::moved(bool reachedGrid) {
  onGrid_ = reachedGrid;
  if (reachedGrid) ++next_;
}

}  // namespace muelle::engine
