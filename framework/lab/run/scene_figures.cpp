#include "lab/run/scene_figures.h"

#include "base/text/printable.h"
#include "lab/run/energy_balance.h"

#include <fmt/format.h>
#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <span>
#include <string_view>

namespace muelle::lab {

using namespace engine;

namespace {

constexpr std::size_t mostDrawnSprings = 4000;  // beyond that the surface alone, or the nodes
constexpr std::size_t mostBroadEdges = 100;     // beyond, hair lines: broad ones are a blot
constexpr std::size_t mostDots = 120;           // beyond, nodes as dots hide the springs
constexpr std::size_t mostDrawnNodes = 30;      // of 1D scenes

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

/// How many outputs the axes are made for: all, or of a run that explodes those before its energy has changed by more
/// than the scene's own scale; where something drives the scene, by more than a thousandth of where it ends. At least
/// the first two.
std::size_t rowsInPicture(const SceneRun& run) {
  const std::vector<double>& energy = run.result.trajectory.track("total energy");
  const auto changeOf = [&](double E) { return std::isfinite(E) ? std::abs(E - energy.front()) : 0.0; };
  double limit = energyScale(*run.system);
  if (energyFate(*run.system) == EnergyFate::Open) {
    if (!run.result.failed()) return energy.size();
    limit = 0.0;
    for (const double E : energy) limit = std::max(limit, 1e-3 * changeOf(E));
  }
  const auto isBeyond = [&](double E) { return E - energy.front() > limit; };  // what is lost leaves no picture
  const auto row = std::ranges::find_if(energy, isBeyond) - energy.begin();
  return std::min(energy.size(), std::max<std::size_t>(2, static_cast<std::size_t>(row)));
}

/// What the curves of a panel reach along one axis in the outputs that the picture is made for; from 0 on where that
/// is no range.
class Reach {
 public:
  void include(std::span<const double> values) {
    for (const double value : values) {
      if (!std::isfinite(value)) continue;
      low_ = std::min(low_, value);
      high_ = std::max(high_, value);
    }
  }
  bool isRange() const { return low() < high() && std::isfinite(high() - low()); }
  double low() const { return low_ < high_ ? low_ : std::min(low_, 0.0); }
  double high() const { return low_ < high_ ? high_ : std::max(high_, 0.0); }

 private:
  double low_ = std::numeric_limits<double>::infinity();
  double high_ = -low_;
};

/// One panel over time, whose axis follows the outputs that the picture is made for.
class TimePanel {
 public:
  TimePanel(Figure& figure, std::string label, const SceneRun& run)
      : panel_(figure.panel(std::move(label))), t_(run.result.trajectory.t), rows_(rowsInPicture(run)) {}
  ~TimePanel() {
    if (rows_ < t_.size() && reach_.isRange()) panel_.expect(reach_.low(), reach_.high());
  }
  TimePanel(const TimePanel&) = delete;
  TimePanel& operator=(const TimePanel&) = delete;

  void line(std::string name, std::vector<double> values) {
    reach_.include(std::span(values).first(std::min(rows_, values.size())));
    panel_.line(std::move(name), t_, std::move(values));
  }
  void reference(std::string name, std::vector<double> values) {
    panel_.reference(std::move(name), t_, std::move(values));
  }

 private:
  Figure::PanelBuilder panel_;
  const std::vector<double>& t_;
  std::size_t rows_;
  Reach reach_;
};

/// Heights have no zero of their own: the potential energy is told from its least, so that it is drawn beside the
/// kinetic energy and not far off.
Figure energyFigure(const Scene& scene, const SceneRun& run) {
  const Trajectory& t = run.result.trajectory;
  const std::vector<double>& potential = t.track("potential energy");
  const double least = *std::ranges::min_element(std::span(potential).first(rowsInPicture(run)));
  const auto fromLeast = [least](std::vector<double> values) {
    for (double& value : values) value -= least;
    return values;
  };
  Figure figure(fileStem(scene.name) + "_energy", drawable(scene.title), "time [s]");
  TimePanel panel(figure, "energy [J], the potential one from its least", run);
  panel.line("kinetic", t.track("kinetic energy"));
  panel.line("potential", fromLeast(potential));
  panel.line("total", fromLeast(t.track("total energy")));
  return figure;
}

Figure outputsFigure(const Scene& scene, const SceneRun& run) {
  const Trajectory& t = run.result.trajectory;
  Figure figure(fileStem(scene.name) + "_outputs", drawable(scene.title), "time [s]");
  for (const SceneOutput& output : scene.outputs) {
    if (output.kind == SceneOutput::Kind::Path) continue;
    const char* unit = output.kind == SceneOutput::Kind::Velocity ? "m/s" : "m";
    TimePanel panel(figure, fmt::format("{} [{}]", drawable(output.name), unit), run);
    panel.line("", t.track(output.name));
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

/// Where the nodes are.
Pieces dots(const Scene& scene, const ModelSystem& system, const State& state) {
  Pieces points;
  for (int node = 0; node < system.nodeCount(); ++node) {
    const Vec3 x = system.position(state, node);
    points.x.push_back(x[scene.view[0]]);
    points.y.push_back(x[scene.view[1]]);
  }
  return points;
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

/// The outlines of the obstacles at time t, where the view shows them; `about` is what the picture shows across.
Pieces obstacleOutlines(const Scene& scene, double t, const Reach& about) {
  Pieces pieces;
  const double margin = about.isRange() ? 0.1 * (about.high() - about.low()) : 0.5;  // so that a ground is seen
  const double low = about.low() - margin;
  const double high = about.high() + margin;
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

/// How far a picture in the plane reaches.
struct PlaneReach {
  Reach x, y;

  void include(const Pieces& pieces) {
    x.include(pieces.x);
    y.include(pieces.y);
  }
  void use(Figure::PanelBuilder& panel) const {
    if (x.isRange()) panel.expectX(x.low(), x.high());
    if (y.isRange()) panel.expect(y.low(), y.high());
  }
};

Figure shapeFigure(const Scene& scene, const SceneRun& run) {
  const auto edges = drawnEdges(scene);
  const std::size_t rows = run.result.trajectory.t.size();
  const State first = stateAt(run.result, 0);
  const State last = stateAt(run.result, rows - 1);
  const Pieces start = drawn(scene, *run.system, first, edges);
  const Pieces end = drawn(scene, *run.system, last, edges);
  Figure figure(fileStem(scene.name) + "_shape", drawable(scene.title), axisLabel(scene, scene.view[0]));
  figure.equalAxes();
  auto panel = figure.panel(axisLabel(scene, scene.view[1]));
  const std::string endName = fmt::format("at {:.3g} s", last.t);
  if (edges.size() <= mostBroadEdges) {
    panel.reference(edges.empty() ? "" : "at the start", start.x, start.y);
    panel.line(edges.empty() ? "" : endName, end.x, end.y).colour(0);
  } else {
    panel.structure("at the start", start.x, start.y);
    panel.mesh(endName, end.x, end.y).colour(0);
  }
  const Pieces startDots = dots(scene, *run.system, first);
  const Pieces endDots = dots(scene, *run.system, last);
  if (scene.model.nodes.size() <= mostDots || edges.empty()) {
    if (edges.empty()) panel.points("at the start", startDots.x, startDots.y).colour(1);
    panel.points(edges.empty() ? endName : "nodes", endDots.x, endDots.y).colour(0);
  }
  PlaneReach seen;
  seen.include(startDots);
  if (rowsInPicture(run) == rows) {
    seen.include(endDots);
  } else {
    seen.use(panel);
  }
  if (!scene.model.obstacles.empty()) {
    const Pieces outlines = obstacleOutlines(scene, last.t, seen.x);
    panel.line("obstacles", outlines.x, outlines.y).colour(2);
  }
  return figure;
}

/// 1D: where the nodes are over time.
Figure nodesFigure(const Scene& scene, const SceneRun& run) {
  const Trajectory& t = run.result.trajectory;
  Figure figure(fileStem(scene.name) + "_shape", drawable(scene.title), "time [s]");
  TimePanel panel(figure, "position [m]", run);
  const std::size_t count = std::min(scene.model.nodes.size(), mostDrawnNodes);
  for (std::size_t node = 0; node < count; ++node) {
    std::vector<double> x;
    for (std::size_t row = 0; row < t.t.size(); ++row) {
      x.push_back(run.system->position(stateAt(run.result, row), static_cast<int>(node))[0]);
    }
    panel.line(count <= 6 ? fmt::format("node {}", node) : "", std::move(x));
  }
  for (const Obstacle& obstacle : scene.model.obstacles) {
    if (obstacle.kind != Obstacle::Kind::Plane) continue;
    std::vector<double> x;
    for (const double time : t.t)
      x.push_back(obstacle.centre[0] + obstacle.velocity[0] * std::min(time, obstacle.stopTime));
    panel.reference(drawable(obstacle.name), std::move(x));
  }
  return figure;
}

Figure pathFigure(const Scene& scene, const SceneRun& run) {
  const Trajectory& t = run.result.trajectory;
  Figure figure(fileStem(scene.name) + "_path", drawable(scene.title), axisLabel(scene, scene.view[0]));
  figure.equalAxes();
  auto panel = figure.panel(axisLabel(scene, scene.view[1]));
  const std::size_t rows = rowsInPicture(run);
  PlaneReach seen;
  Pieces starts;
  for (const SceneOutput& output : scene.outputs) {
    if (output.kind != SceneOutput::Kind::Path) continue;
    std::vector<double> x, y;
    for (std::size_t row = 0; row < t.t.size(); ++row) {
      const Vec3 at = run.system->position(stateAt(run.result, row), output.nodes[0]);
      x.push_back(at[scene.view[0]]);
      y.push_back(at[scene.view[1]]);
    }
    starts.x.push_back(x.front());
    starts.y.push_back(y.front());
    seen.x.include(std::span(x).first(rows));
    seen.y.include(std::span(y).first(rows));
    panel.line(drawable(output.name), std::move(x), std::move(y));
  }
  panel.points("start", starts.x, starts.y);
  if (rows < t.t.size()) seen.use(panel);
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
