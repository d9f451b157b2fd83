#include "lab/run/scene_figures.h"

#include "base/text/printable.h"

#include <fmt/format.h>
#include <algorithm>
#include <cctype>
#include <limits>
#include <string_view>

namespace muelle::lab {

using namespace engine;

namespace {

constexpr std::size_t mostDrawnSprings = 4000;  // beyond that the surface alone, or the nodes
constexpr std::size_t mostReferenceEdges = 100;
constexpr std::size_t mostDrawnNodes = 30;  // of 1D scenes

/// A scene's own words, as far as a figure can show them: on one line, and not too long.
std::string drawable(std::string_view text) { return cut(printableLine(text), longestFigureText); }

/// Letters, digits and _ for a file's name.
std::string fileStem(std::string_view text) {
  std::string result;
  for (const char c : text) result += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  return result;
}

State stateAt(const RunResult& result, std::size_t row) {
  const Trajectory& t = result.trajectory;
  return {t.t[row], t.x[row], t.v[row], {}};
}

std::string axisLabel(const Scene& scene, int axis) {
  if (scene.model.dimension == 1) return "position [m]";
  return fmt::format("{} [m]", "xyz"[static_cast<std::size_t>(axis)]);
}

Figure energyFigure(const Scene& scene, const SceneRun& run) {
  const Trajectory& t = run.result.trajectory;
  Figure figure(fileStem(scene.name) + "_energy", drawable(scene.title), "time [s]");
  figure.panel("energy [J]")
      .line("kinetic", t.t, t.track("kinetic energy"))
      .line("potential", t.t, t.track("potential energy"))
      .line("total", t.t, t.track("total energy"));
  return figure;
}

Figure outputsFigure(const Scene& scene, const SceneRun& run) {
  const Trajectory& t = run.result.trajectory;
  Figure figure(fileStem(scene.name) + "_outputs", drawable(scene.title), "time [s]");
  for (const SceneOutput& output : scene.outputs) {
    if (output.kind == SceneOutput::Kind::Path) continue;
    const char* unit = output.kind == SceneOutput::Kind::Velocity ? "m/s" : "m";
    figure.panel(fmt::format("{} [{}]", drawable(output.name), unit)).line("", t.t, t.track(output.name));
  }
  return figure;
}

/// A curve with a gap after each piece.
struct Pieces {
  std::vector<double> x, y;

  void gap() {
    x.push_back(std::numeric_limits<double>::quiet_NaN());
    y.push_back(std::numeric_limits<double>::quiet_NaN());
  }
};

Pieces drawn(const Scene& scene, const ModelSystem& system, const State& state,
             const std::vector<std::array<int, 2>>& edges) {
  Pieces pieces;
  for (const auto& edge : edges) {
    for (const int node : edge) {
      const Vec3 x = system.position(state, node);
      pieces.x.push_back(x[scene.view[0]]);
      pieces.y.push_back(x[scene.view[1]]);
    }
    pieces.gap();
  }
  return pieces;
}

/// The springs, or the edges of the surfaces when they are too many to see.
std::vector<std::array<int, 2>> drawnEdges(const Scene& scene) {
  std::vector<std::array<int, 2>> edges;
  if (scene.model.springs.size() <= mostDrawnSprings) {
    for (const ModelSpring& spring : scene.model.springs) edges.push_back({spring.a, spring.b});
    return edges;
  }
  for (const Part& part : scene.parts) {
    const auto surface = edgesOf(part.triangles);
    edges.insert(edges.end(), surface.begin(), surface.end());
  }
  return edges;
}

/// The outlines of the obstacles at time t, where the view shows them.
Pieces obstacleOutlines(const Scene& scene, double t, const Pieces& about) {
  Pieces pieces;
  double low = 0.0;
  double high = 0.0;
  for (std::size_t i = 0; i < about.x.size(); ++i) {
    if (about.x[i] != about.x[i]) continue;
    low = i == 0 ? about.x[i] : std::min(low, about.x[i]);
    high = i == 0 ? about.x[i] : std::max(high, about.x[i]);
  }
  const auto [across, up] = scene.view;
  for (const Obstacle& obstacle : scene.model.obstacles) {
    const Vec3 c = obstacle.centre + obstacle.velocity * std::min(t, obstacle.stopTime);
    if (obstacle.kind == Obstacle::Kind::Sphere) {
      for (int i = 0; i <= 90; ++i) {
        const double angle = i * 0.06981317007977318;  // 2 pi / 90
        pieces.x.push_back(c[across] + obstacle.radius * std::cos(angle));
        pieces.y.push_back(c[up] + obstacle.radius * std::sin(angle));
      }
    } else if (obstacle.kind == Obstacle::Kind::Plane && std::abs(obstacle.normal[up]) > 1e-9) {
      for (const double x : {low, high}) {
        pieces.x.push_back(x);
        pieces.y.push_back(c[up] - (x - c[across]) * obstacle.normal[across] / obstacle.normal[up]);
      }
    } else if (obstacle.kind == Obstacle::Kind::Box) {
      const double w = std::min(obstacle.halfSize[across], high - low);
      const double h = std::min(obstacle.halfSize[up], high - low);
      for (const auto& [sx, sy] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}, {-1, -1}}) {
        pieces.x.push_back(c[across] + sx * w);
        pieces.y.push_back(c[up] + sy * h);
      }
    }
    pieces.gap();
  }
  return pieces;
}

Figure shapeFigure(const Scene& scene, const SceneRun& run) {
  const auto edges = drawnEdges(scene);
  const State first = stateAt(run.result, 0);
  const State last = stateAt(run.result, run.result.trajectory.t.size() - 1);
  const Pieces start = drawn(scene, *run.system, first, edges);
  const Pieces end = drawn(scene, *run.system, last, edges);
  Figure figure(fileStem(scene.name) + "_shape", drawable(scene.title), axisLabel(scene, scene.view[0]));
  figure.equalAxes();
  auto panel = figure.panel(axisLabel(scene, scene.view[1]));
  // The pen of references is broad: right for a few springs, a blot for a mesh.
  if (edges.size() <= mostReferenceEdges) {
    panel.reference("at the start", start.x, start.y);
  } else {
    panel.line("at the start", start.x, start.y);
  }
  panel.line(fmt::format("at {:.3g} s", last.t), end.x, end.y);
  if (!scene.model.obstacles.empty()) {
    const Pieces outlines = obstacleOutlines(scene, last.t, end);
    panel.line("obstacles", outlines.x, outlines.y);
  }
  return figure;
}

/// 1D: where the nodes are over time.
Figure nodesFigure(const Scene& scene, const SceneRun& run) {
  const Trajectory& t = run.result.trajectory;
  Figure figure(fileStem(scene.name) + "_shape", drawable(scene.title), "time [s]");
  auto panel = figure.panel("position [m]");
  const std::size_t count = std::min(scene.model.nodes.size(), mostDrawnNodes);
  for (std::size_t node = 0; node < count; ++node) {
    std::vector<double> x;
    for (std::size_t row = 0; row < t.t.size(); ++row) {
      x.push_back(run.system->position(stateAt(run.result, row), static_cast<int>(node))[0]);
    }
    panel.line(count <= 6 ? fmt::format("node {}", node) : "", t.t, std::move(x));
  }
  return figure;
}

Figure pathFigure(const Scene& scene, const SceneRun& run) {
  const Trajectory& t = run.result.trajectory;
  Figure figure(fileStem(scene.name) + "_path", drawable(scene.title), axisLabel(scene, scene.view[0]));
  figure.equalAxes();
  auto panel = figure.panel(axisLabel(scene, scene.view[1]));
  for (const SceneOutput& output : scene.outputs) {
    if (output.kind != SceneOutput::Kind::Path) continue;
    std::vector<double> x, y;
    for (std::size_t row = 0; row < t.t.size(); ++row) {
      const Vec3 at = run.system->position(stateAt(run.result, row), output.nodes[0]);
      x.push_back(at[scene.view[0]]);
      y.push_back(at[scene.view[1]]);
    }
    panel.line(drawable(output.name), std::move(x), std::move(y));
  }
  return figure;
}

}  // namespace

std::vector<Figure> figuresOf(const Scene& scene, const SceneRun& run) {
  using Kind = SceneOutput::Kind;
  const auto isPath = [](const SceneOutput& output) { return output.kind == Kind::Path; };
  std::vector<Figure> figures;
  if (run.result.trajectory.t.empty()) return figures;
  figures.push_back(energyFigure(scene, run));
  if (!std::ranges::all_of(scene.outputs, isPath)) figures.push_back(outputsFigure(scene, run));
  figures.push_back(scene.model.dimension == 1 ? nodesFigure(scene, run) : shapeFigure(scene, run));
  const bool hasPaths = std::ranges::any_of(scene.outputs, isPath) && scene.model.dimension > 1;
  if (hasPaths) figures.push_back(pathFigure(scene, run));
  return figures;
}

}  // namespace muelle::lab
