#include "lab/bench/report.h"

#include <fmt/format.h>
#include <algorithm>
#include <set>

namespace muelle::bench {

namespace {

/// What is drawn: of each row the curves that are best at some error, then those that come first to mind.
std::vector<const Curve*> shown(const SceneResult& scene) {
  std::vector<const Curve*> ours, peers;
  const auto add = [](std::vector<const Curve*>& to, const Curve* curve, std::size_t most) {
    if (curve != nullptr && to.size() < most && std::ranges::find(to, curve) == to.end()) to.push_back(curve);
  };
  const std::vector<Entry> entries = entriesOf(scene);
  for (const Entry& entry : entries) {
    if (entry.ours) add(ours, entry.ours->curve, 4);
    if (entry.plain) add(peers, entry.plain->curve, 3);
    if (entry.plainWithEvents) add(peers, entry.plainWithEvents->curve, 4);
  }
  add(ours, scene.find("ours:muelle:velocity_verlet"), 4);
  add(peers, scene.find(naiveEulerKey), 4);
  for (const Entry& entry : entries) {
    if (entry.kernel && ours.size() + peers.size() < 8) add(peers, entry.kernel->curve, 4);
  }
  ours.insert(ours.end(), peers.begin(), peers.end());
  return ours;
}

/// What is off by less stands at it.
constexpr double leastShown = 1e-10;

std::string nameInKey(const Curve& curve) {
  const bool isExact = std::ranges::all_of(
      curve.points, [](const CurvePoint& point) { return !point.failed() && point.error.position <= leastShown; });
  const std::string tail = isExact ? fmt::format(", off by less than {:.0e}", leastShown) : "";
  if (curve.row == Row::Ours) return fmt::format("ours {}{}", curve.method, tail);
  return fmt::format("{} {} {}{}", nameOf(curve.row), curve.library, curve.method, tail);
}

struct Numbers {
  std::vector<double> error, seconds, evaluations;
};

/// A failed run stands at an error of 1; what is off by more does, too.
Numbers numbersOf(const Curve& curve) {
  Numbers numbers;
  for (const CurvePoint& point : curve.points) {
    const double error = point.failed() ? 1.0 : std::clamp(point.error.position, leastShown, 1.0);
    if (error == 1.0 && !numbers.error.empty() && numbers.error.back() == 1.0) {
      // One point at the margin is enough: the finest that fails.
      for (auto* values : {&numbers.error, &numbers.seconds, &numbers.evaluations}) values->pop_back();
    }
    numbers.error.push_back(error);
    numbers.seconds.push_back(statisticsOf(point.seconds).median);
    numbers.evaluations.push_back(static_cast<double>(std::max(1LL, point.cost.evaluations)));
  }
  return numbers;
}

}  // namespace

Figure figureOf(const SceneResult& scene) {
  Figure figure(scene.name, scene.title, "error eₓ over the whole run, in parts of the motion");
  figure.slide(2);
  auto seconds = figure.panel("");
  seconds.heading("processor time [s]");
  auto evaluations = figure.panel("");
  evaluations.heading("evaluations of the force");
  double least = 1e-3;
  int colour = 0;
  for (const Curve* curve : shown(scene)) {
    const Numbers numbers = numbersOf(*curve);
    if (numbers.error.empty()) continue;
    seconds.linePoints(nameInKey(*curve), numbers.error, numbers.seconds).colour(colour);
    evaluations.linePoints("", numbers.error, numbers.evaluations).colour(colour++);
    least = std::min(least, *std::ranges::min_element(numbers.error));
  }
  for (auto* panel : {&seconds, &evaluations})
    panel->logX().logY().xRange(least > 2.0 * leastShown ? least / 2.0 : 0.5 * leastShown, 2.0);
  return figure;
}

}  // namespace muelle::bench
