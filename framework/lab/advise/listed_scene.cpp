#include "lab/advise/listed_scene.h"

#include "base/text/lists.h"
#include "engine/model/axes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <cmath>
#include <vector>

namespace muelle::lab {

using namespace engine;

namespace {

std::string quoted(const std::string& words) {
  std::string text = "\"";
  for (const char c : words) {
    if (c == '"' || c == '\\') text += '\\';
    text += c;
  }
  return text + "\"";
}

/// All digits, and always a TOML float.
std::string digits(double value) {
  if (std::isinf(value)) return value > 0.0 ? "inf" : "-inf";
  std::string text = fmt::format("{}", value);
  if (text.find_first_of(".en") == std::string::npos) text += ".0";
  return text;
}

/// Lines "key = value" of a table.
class Listing {
 public:
  explicit Listing(const Model& model) : axes_(engine::axesOf(model)) {}

  void table(const char* name) { text_ += fmt::format("\n[[{}]]\n", name); }
  void line(const char* key, const std::string& value) { text_ += fmt::format("{} = {}\n", key, value); }
  void number(const char* key, double value) { line(key, digits(value)); }
  void numberUnless(const char* key, double value, double usual) {
    if (value != usual) number(key, value);
  }
  void flag(const char* key, bool value) {
    if (value) line(key, "true");
  }
  void vector(const char* key, const Vec3& value) {
    std::vector<std::string> parts;
    for (const int c : axes_) parts.push_back(digits(value[c]));
    line(key, parts.size() == 1 ? parts[0] : fmt::format("[{}]", joined(parts, ", ")));
  }
  void nodes(const std::vector<int>& nodes) { line("nodes", fmt::format("[{}]", fmt::join(nodes, ", "))); }
  void add(const std::string& text) { text_ += text; }
  std::string take() { return std::move(text_); }

 private:
  std::vector<int> axes_;
  std::string text_;
};

void addNodes(Listing& to, const Model& model) {
  for (const ModelNode& node : model.nodes) {
    to.table("node");
    to.vector("x", node.x);
    if (node.v.norm() > 0.0) to.vector("v", node.v);
    if (!node.pinned) to.number("m", node.m);
    to.flag("pinned", node.pinned);
    to.numberUnless("drag", node.drag, 0.0);
  }
}

void addSprings(Listing& to, const Model& model) {
  for (const ModelSpring& spring : model.springs) {
    to.table("spring");
    to.nodes({spring.a, spring.b});
    if (!spring.rod) to.number("k", spring.k);
    to.number("L0", spring.L0);
    to.numberUnless("relative_damping", spring.dRelative, 0.0);
    to.numberUnless("projected_damping", spring.dProjected, 0.0);
    to.numberUnless("damping_ratio", spring.dampingRatio, 0.0);
    to.flag("unilateral", spring.unilateral);
    to.flag("signed", spring.isSigned);
    to.flag("rod", spring.rod);
  }
  for (const ModelAngle& angle : model.angles) {
    to.table("angle");
    to.nodes({angle.nodes.begin(), angle.nodes.end()});
    to.number("k", angle.k);
    to.numberUnless("theta0", angle.theta0, 0.0);
  }
}

void addObstacles(Listing& to, const Model& model) {
  for (const Obstacle& obstacle : model.obstacles) {
    const ContactMaterial& material = obstacle.material;
    to.table("obstacle");
    if (obstacle.kind == Obstacle::Kind::Plane) {
      to.line("shape", "\"plane\"");
      to.vector("point", obstacle.centre);
      to.vector("normal", obstacle.normal);
    } else if (obstacle.kind == Obstacle::Kind::Sphere) {
      to.line("shape", "\"sphere\"");
      to.vector("centre", obstacle.centre);
      to.number("radius", obstacle.radius);
    } else {
      to.line("shape", "\"box\"");
      to.vector("centre", obstacle.centre);
      to.vector("half_size", obstacle.halfSize);
    }
    to.line("name", quoted(obstacle.name));
    to.number("k", material.k);
    to.numberUnless("d", material.d, 0.0);
    to.numberUnless("mu", material.mu, 0.0);
    to.numberUnless("k_tangential", material.kTangential, 0.0);
    to.numberUnless("d_tangential", material.dTangential, 0.0);
    if (obstacle.velocity.norm() > 0.0) to.vector("velocity", obstacle.velocity);
    if (std::isfinite(obstacle.stopTime)) to.number("stop_time", obstacle.stopTime);
  }
}

void addRun(Listing& to, const Scene& scene) {
  to.add("\n[run]\n");
  to.line("method", quoted(scene.method));
  if (scene.step) to.number("step", *scene.step);
  if (scene.tolerance) to.number("tolerance", *scene.tolerance);
  to.number("duration", scene.duration);
  if (scene.outputInterval > 0.0) to.number("output_interval", scene.outputInterval);
  if (std::isfinite(scene.largestStep)) to.number("largest_step", scene.largestStep);
  if (!scene.locateEvents) to.line("events", "false");
  to.flag("compensated", scene.compensated);
}

void addOutputs(Listing& to, const Scene& scene) {
  using Kind = SceneOutput::Kind;
  static constexpr std::pair<Kind, const char*> kinds[] = {
      {Kind::Position, "position"}, {Kind::Velocity, "velocity"}, {Kind::MeanPosition, "mean_position"},
      {Kind::Lowest, "lowest"},     {Kind::Highest, "highest"},   {Kind::Distance, "distance"},
      {Kind::Path, "path"}};
  const std::vector<int> axes = engine::axesOf(scene.model);
  for (const SceneOutput& output : scene.outputs) {
    const bool hasAxis = output.kind != Kind::Distance && output.kind != Kind::Path;
    // Along a direction that is gone nothing moves.
    if (hasAxis && std::ranges::find(axes, output.axis) == axes.end()) continue;
    to.table("output");
    for (const auto& [kind, word] : kinds) {
      if (kind == output.kind) to.line("kind", quoted(word));
    }
    to.line("name", quoted(output.name));
    to.nodes(output.nodes);
    if (hasAxis) to.line("axis", fmt::format("\"{}\"", "xyz"[static_cast<std::size_t>(output.axis)]));
  }
}

}  // namespace

std::string unlisted(const Scene& scene) {
  const Model& model = scene.model;
  if (!model.motions.empty()) return "it has nodes that are moved";
  if (!model.externalForces.empty()) return "it has forces that change with time";
  if (!model.properties.empty()) return "it has a property of many nodes";
  if (elementCount(model) > model.angles.size()) return "it has dihedrals, areas or volumes";
  Vec3 across = model.gravity;
  across[upAxisOf(model)] = 0.0;
  return across.norm() > 0.0 ? "gravity is not along its last axis" : "";
}

std::string listedScene(const Scene& scene) {
  const Model& model = scene.model;
  Listing to(model);
  to.line("title", quoted(scene.title));
  to.line("shows", quoted(scene.shows));
  to.line("slide", quoted(scene.slide));
  to.line("dimension", fmt::format("{}", model.dimension));
  if (model.dimension == 2) {
    to.line("plane", fmt::format("\"{}{}\"", "xyz"[static_cast<std::size_t>(model.plane[0])],
                                 "xyz"[static_cast<std::size_t>(model.plane[1])]));
  }
  to.numberUnless("gravity", -model.gravity[upAxisOf(model)], 0.0);
  to.flag("cross_zero_length", model.springsCross);
  if (model.precision == kernels::Precision::Single) to.line("precision", quoted("single"));
  addNodes(to, model);
  addSprings(to, model);
  addObstacles(to, model);
  addRun(to, scene);
  addOutputs(to, scene);
  return to.take();
}

}  // namespace muelle::lab
