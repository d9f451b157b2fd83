#include "lab/advise/advice_figure.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

namespace muelle::lab {

namespace {

constexpr std::size_t mostCurves = 5, mostParts = 6;
constexpr double leastShown = 1e-14;

double shown(double error) { return std::clamp(error, leastShown, 1.0); }

/// What both panels have in common.
struct Ranges {
  double leastError = 1.0, leastTime = INFINITY, mostTime = 0.0;

  void add(double error, double seconds) {
    leastError = std::min(leastError, shown(error));
    leastTime = std::min(leastTime, seconds);
    mostTime = std::max(mostTime, seconds);
  }
  void set(Figure::PanelBuilder& panel, double tolerance, const char* name) const {
    const double left = std::max(std::min(leastError, tolerance) / 3.0, leastShown / 3.0);
    panel.logX().logY().xRange(left, 3.0).yRange(leastTime / 2.0, mostTime * 3.0);
    panel.reference(name, {tolerance, tolerance}, {leastTime / 2.0, mostTime * 3.0});
  }
};

/// The curves of the fastest, by the error that is allowed, as they stand in the table.
std::vector<const Candidate*> curvesOf(const MethodChoice& choice) {
  std::vector<const Candidate*> curves;
  for (const Candidate& candidate : choice.candidates) {
    if (candidate.runs > 0 && !candidate.points.empty() && curves.size() < mostCurves) curves.push_back(&candidate);
  }
  return curves;
}

void drawMethods(Figure::PanelBuilder& panel, const std::vector<const Candidate*>& curves) {
  int colour = 0;
  for (const Candidate* candidate : curves) {
    std::vector<TriedPoint> points = candidate->points;
    std::ranges::sort(points, {}, &TriedPoint::error);
    std::vector<double> error, seconds;
    for (const TriedPoint& point : points) {
      error.push_back(shown(point.error));
      seconds.push_back(point.seconds);
    }
    panel.linePoints(candidate->setting.name(), std::move(error), std::move(seconds)).colour(colour++);
  }
}

/// The way down in grey, and a mark for each model on it.
void drawLadder(Figure::PanelBuilder& panel, const std::vector<LadderStep>& ladder, int& colour) {
  std::vector<double> error, seconds;
  for (const LadderStep& step : ladder) {
    error.push_back(shown(step.error));
    seconds.push_back(step.seconds);
  }
  if (ladder.size() > 1) panel.structure("", error, seconds);
  for (std::size_t i = 0; i < ladder.size(); ++i) {
    panel.linePoints(i < 2 ? ladder[i].left : "and " + ladder[i].left, {error[i]}, {seconds[i]}).colour(colour++);
  }
}

void drawKept(Figure::PanelBuilder& panel, const Advice& advice, double whole, int& colour) {
  std::size_t drawn = 0;
  for (const PartTrial& trial : advice.parts) {
    if (trial.leftOut || !trial.measured || !std::isfinite(trial.error) || drawn++ >= mostParts) continue;
    panel.points("kept: " + trial.part.name, {shown(trial.error / statedFactor)}, {trial.timeLeft * whole});
    panel.colour(colour++);
  }
}

}  // namespace

Figure figureOf(const engine::Scene& scene, const Advice& advice) {
  Figure figure("advice", scene.name + ": what it needs", "error in parts of the motion");
  const Candidate* whole = advice.whole.chosen();
  figure.slide(whole != nullptr && !advice.parts.empty() ? 2 : 1);
  const std::vector<const Candidate*> curves = curvesOf(advice.whole);
  Ranges ranges;
  for (const Candidate* candidate : curves) {
    for (const TriedPoint& point : candidate->points) ranges.add(point.error, point.seconds);
  }
  for (const LadderStep& step : advice.ladder) ranges.add(step.error, step.seconds);
  for (const PartTrial& trial : advice.parts) {
    if (!trial.leftOut && trial.measured && std::isfinite(trial.error))
      ranges.add(trial.error, trial.timeLeft * whole->seconds);
  }
  auto methods = figure.panel("processor time [s]");
  methods.heading("methods, the whole model");
  drawMethods(methods, curves);
  if (curves.empty()) return figure;
  ranges.set(methods, advice.tolerance, "allowed");
  if (!figure.isSlide() || figure.columns() < 2) return figure;
  auto parts = figure.panel("processor time [s]");
  parts.heading("parts of the model");
  std::vector<LadderStep> ladder = advice.ladder;
  if (ladder.empty()) ladder.push_back({"whole model", whole->setting, whole->error / statedFactor, whole->seconds});
  int colour = 0;
  drawLadder(parts, ladder, colour);
  drawKept(parts, advice, whole->seconds, colour);
  ranges.set(parts, advice.tolerance, "");
  return figure;
}

}  // namespace muelle::lab
