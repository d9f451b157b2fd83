#include "lab/rest/rest_figure.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace muelle::lab {

using namespace engine;

namespace {

constexpr std::size_t mostDots = 200;  // beyond, nodes as dots hide the springs

/// Curves of many pieces, with a gap after each.
struct Drawn {
  std::vector<double> x, y;

  void add(const Scene& scene, const SceneAtRest& rest, const State& state, const ModelSpring& spring) {
    for (const int node : {spring.a, spring.b}) {
      const Vec3 at = rest.system->position(state, node);
      x.push_back(at[scene.view[0]]);
      y.push_back(at[scene.view[1]]);
    }
    x.push_back(std::numeric_limits<double>::quiet_NaN());
    y.push_back(std::numeric_limits<double>::quiet_NaN());
  }
};

void drawShape(Figure& figure, const Scene& scene, const SceneAtRest& rest) {
  const RestResult& result = rest.result;
  const State start = rest.system->initialState();
  double largest = 0.0;
  for (const double T : result.tensions) {
    if (std::isfinite(T)) largest = std::max(largest, std::abs(T));
  }
  Drawn before, pulls, pushes, idle;
  for (std::size_t i = 0; i < scene.model.springs.size(); ++i) {
    const ModelSpring& spring = scene.model.springs[i];
    before.add(scene, rest, start, spring);
    const double T = i < result.tensions.size() ? result.tensions[i] : 0.0;
    Drawn& own = T > 1e-12 * largest ? pulls : T < -1e-12 * largest ? pushes : idle;
    own.add(scene, rest, result.state, spring);
  }
  auto panel = figure.panel(fmt::format("{} [m]", "xyz"[static_cast<std::size_t>(scene.view[1])]));
  panel.equalAxes().heading("shape").xLabel(fmt::format("{} [m]", "xyz"[static_cast<std::size_t>(scene.view[0])]));
  if (!before.x.empty()) panel.reference("at the start", before.x, before.y);
  if (!pulls.x.empty()) panel.line("pulls", pulls.x, pulls.y).colour(0);
  if (!pushes.x.empty()) panel.line("pushes", pushes.x, pushes.y).colour(1);
  if (!idle.x.empty()) panel.line("does neither", idle.x, idle.y).colour(2);
  if (scene.model.nodes.size() > mostDots) return;
  std::vector<double> x, y;
  for (int node = 0; node < rest.system->nodeCount(); ++node) {
    const Vec3 at = rest.system->position(result.state, node);
    x.push_back(at[scene.view[0]]);
    y.push_back(at[scene.view[1]]);
  }
  panel.points("nodes", std::move(x), std::move(y)).colour(3);
}

void drawPositions(Figure& figure, const SceneAtRest& rest) {
  const State start = rest.system->initialState();
  std::vector<double> node, before, now;
  for (int i = 0; i < rest.system->nodeCount(); ++i) {
    node.push_back(i);
    before.push_back(rest.system->position(start, i)[0]);
    now.push_back(rest.system->position(rest.result.state, i)[0]);
  }
  figure.panel("position [m]")
      .heading("positions")
      .xLabel("node")
      .reference("at the start", node, before)
      .linePoints("at rest", node, now);
}

}  // namespace

Figure figureOf(const Scene& scene, const SceneAtRest& rest) {
  Figure figure("rest", (rest.result.isFound() ? "At rest: " : "Not at rest: ") + nameOf(rest.result.verdict), "node");
  const bool hasSprings = !rest.result.tensions.empty();
  figure.slide(hasSprings ? 2 : 1);
  if (scene.model.dimension == 1) {
    drawPositions(figure, rest);
  } else {
    drawShape(figure, scene, rest);
  }
  if (!hasSprings) return figure;
  std::vector<double> spring, tension;
  for (std::size_t i = 0; i < rest.result.tensions.size(); ++i) {
    spring.push_back(static_cast<double>(i));
    tension.push_back(rest.result.tensions[i]);
  }
  auto panel = figure.panel("tension [N]");
  panel.heading("tension of each spring").xLabel("spring");
  if (spring.size() <= mostDots) {
    panel.linePoints("", std::move(spring), std::move(tension));
  } else {
    panel.points("", std::move(spring), std::move(tension));
  }
  return figure;
}

}  // namespace muelle::lab
