#include "lab/bench/results.h"
#include "lab/bench/sweep.h"
#include "tools.h"

#include <fmt/format.h>
#include <algorithm>
#include <limits>
#include <stdexcept>

namespace muelle::plots::work_precision {

namespace {

constexpr const char* names[] = {"Verlet", "RK4", "DP5", "midpoint", "Kahan-Li 8", "Nyström 12"};
static_assert(std::size(names) == std::size(bench::lectureMethods));
constexpr double margin = 1.0;  ///< where a run stands that is as far off as the motion, or failed

struct Points {
  std::vector<double> error, evaluations, seconds;
  std::vector<double> at, interval;  ///< upright lines with gaps: the interval of each median
};

Points pointsOf(const bench::KeptCurve& curve) {
  Points points;
  const double gap = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t i = 0; i < curve.error.size(); ++i) {
    const double error = std::min(curve.error[i], margin);
    points.error.push_back(error);
    points.evaluations.push_back(std::max(curve.evaluations[i], 1.0));
    points.seconds.push_back(curve.seconds[i].median);
    points.at.insert(points.at.end(), {error, error, gap});
    points.interval.insert(points.interval.end(), {curve.seconds[i].low, curve.seconds[i].high, gap});
  }
  return points;
}

const bench::KeptCurve& find(const std::vector<bench::KeptCurve>& curves, const std::string& method) {
  const std::string key = "ours:muelle:" + method;
  const auto place = std::ranges::find(curves, key, &bench::KeptCurve::key);
  if (place == curves.end()) throw std::runtime_error("the kept results have no curve of " + method);
  return *place;
}

}  // namespace

/// "Which integrator, which step?" Speed against error: evaluations of the force and processor time that an error
/// costs, from the results that ./muelle bench has kept: medians of runs made in turn, with the interval in which they
/// lie.
Figure work_precision() {
  const std::vector<bench::KeptCurve> curves =
      bench::readKeptCurves(bench::keptPoints(MUELLE_RESULTS), bench::lectureScene);
  Figure figure("work_precision", "Speed against error: the more digits are asked for, the more a high order pays",
                "error eₓ over 10 s, in parts of the motion");
  figure.slide(2);
  auto evaluations = figure.panel("");
  evaluations.heading("evaluations of the force, elastic pendulum");
  auto seconds = figure.panel("");
  seconds.heading("processor time [s], medians");
  double least = 1e-3;
  for (std::size_t m = 0; m < std::size(names); ++m) {
    const Points points = pointsOf(find(curves, bench::lectureMethods[m]));
    evaluations.linePoints(names[m], points.error, points.evaluations).colour(static_cast<int>(m));
    seconds.linePoints("", points.error, points.seconds).colour(static_cast<int>(m));
    seconds.mesh("", points.at, points.interval).colour(static_cast<int>(m));
    least = std::min(least, *std::ranges::min_element(points.error));
  }
  evaluations.note(2.0 * std::max(least / 2.0, 1e-10), 20.0, "at 1: as far off as it moves, or failed");
  for (auto* panel : {&evaluations, &seconds}) panel->logX().logY().xRange(std::max(least / 2.0, 1e-10), 2.0);
  return figure;
}

}  // namespace muelle::plots::work_precision
