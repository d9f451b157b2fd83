#include "engine/scene/object_reader.h"
#include "engine/scene/scene.h"
#include "engine/scene/selection.h"
#include "engine/scene/table_reader.h"
#include "engine/scene/time_functions.h"

#include "base/text/nearest.h"
#include "base/text/printable.h"
#include "engine/integrators/catalogue.h"
#include "engine/model/axes.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <stdexcept>

namespace muelle::engine {

namespace {

using Keys = TableReader::Keys;

constexpr double forever = std::numeric_limits<double>::infinity();

Keys with(Keys keys, const Keys& more) {
  keys.insert(keys.end(), more.begin(), more.end());
  return keys;
}

const Vec3& positionOf(const Model& model, int node) { return model.nodes[static_cast<std::size_t>(node)].x; }

/// `count` different nodes of the model under the key "nodes".
std::vector<int> readNodes(const TableReader& table, const Model& model, int count) {
  if (model.nodes.empty()) table.failHere("the scene has no nodes; [[node]] and [[object]] make them");
  std::vector<int> nodes = readNumbers(table, count, static_cast<int>(model.nodes.size()), "the scene");
  std::vector<int> sorted = nodes;
  std::ranges::sort(sorted);
  if (std::ranges::adjacent_find(sorted) != sorted.end()) table.fail("nodes", "a node stands twice");
  return nodes;
}

// --- what the scene is ---

/// "xz" or "zx": two different axes.
std::array<int, 2> readPlane(const TableReader& table, const std::string& key) {
  const std::string axes = table.text(key);
  const auto isAxis = [](char c) { return c >= 'x' && c <= 'z'; };
  if (axes.size() != 2 || !isAxis(axes[0]) || !isAxis(axes[1]) || axes[0] == axes[1]) {
    table.fail(key, fmt::format("'{}' is no plane; expected two axes, as in \"xz\"", printableLine(axes)));
  }
  return {axes[0] - 'x', axes[1] - 'x'};
}

Space readSpace(const TableReader& table, Model& model) {
  model.dimension = table.has("dimension") ? table.integer("dimension", 1, 3) : 3;
  if (table.has("plane")) {
    if (model.dimension != 2) table.fail("plane", "needs dimension = 2");
    model.plane = readPlane(table, "plane");
  }
  return {model.dimension, model.plane};
}

kernels::Precision readPrecision(const TableReader& table) {
  const std::string precision = table.text("precision");
  if (precision == "single") return kernels::Precision::Single;
  if (precision != "double") {
    table.fail("precision", fmt::format("'{}' is none; expected \"double\" or \"single\"", printableLine(precision)));
  }
  return kernels::Precision::Double;
}

/// g >= 0 pulls down: along -z in space, against the second axis in a plane, along -x in 1D.
void readGravity(const TableReader& table, Model& model) {
  const double g = table.notNegative("gravity", 0.0);
  model.gravity[upAxisOf(model)] = -g;
}

// --- nodes and springs by hand ---

void readNode(const TableReader& table, Model& model) {
  table.refuseOtherNames({{"mass", "m"}, {"position", "x"}, {"velocity", "v"}, {"fixed", "pinned"}});
  table.checkKeys({"x", "v", "m", "pinned", "drag"}, {"x"});
  ModelNode node;
  node.x = table.vector("x");
  node.v = table.vector("v", Vec3::Zero());
  node.pinned = table.flag("pinned", false);
  node.m = table.positive("m", 1.0);
  node.drag = table.notNegative("drag", 0.0);
  model.nodes.push_back(node);
}

/// Known only once pins and motions are: a node that one of them holds needs no mass.
void requireMass(const TableReader& table, const ModelNode& node) {
  if (isFree(node) && !table.has("m")) table.fail("m", "missing: a node that is neither pinned nor moved has a mass");
}

/// The part that the element is of: part = "hem".
int readPart(const TableReader& table, Model& model) {
  return table.has("part") ? partNamed(model, table.text("part")) : partOfItsKind;
}

void readSpring(const TableReader& table, Model& model) {
  table.refuseOtherNames({{"stiffness", "k"}, {"rest_length", "L0"}, {"damping", "projected_damping"}});
  table.checkKeys({"nodes", "k", "L0", "relative_damping", "projected_damping", "damping_ratio", "unilateral", "signed",
                   "rod", "part"},
                  {"nodes"});
  const std::vector<int> nodes = readNodes(table, model, 2);
  ModelSpring spring;
  spring.a = nodes[0];
  spring.b = nodes[1];
  spring.rod = table.flag("rod", false);
  if (spring.rod && table.has("k")) table.fail("k", "a rod has no stiffness: leave k or rod out");
  if (!spring.rod) spring.k = table.notNegative("k");
  spring.L0 = table.notNegative("L0", (positionOf(model, spring.a) - positionOf(model, spring.b)).norm());
  spring.dRelative = table.notNegative("relative_damping", 0.0);
  spring.dProjected = table.notNegative("projected_damping", 0.0);
  spring.unilateral = table.flag("unilateral", false);
  spring.isSigned = table.flag("signed", false);
  if (spring.isSigned && model.dimension != 1) table.fail("signed", "only a scene of dimension 1 has sides");
  table.oneKeyOf({"damping_ratio", "projected_damping"}, false);
  spring.dampingRatio = table.notNegative("damping_ratio", 0.0);
  spring.part = readPart(table, model);
  model.springs.push_back(spring);
}

/// The [[angle]], [[dihedral]], ... of the scene: what all kinds have, and what theirs has.
template <class Element>
void readElements(const TableReader& scene, Model& model, std::vector<Element>& elements) {
  for (const TableReader& table : scene.tables(Element::kind)) {
    Keys keys = {"nodes", "k", "part"};
    keys.insert(keys.end(), Element::ownKeys.begin(), Element::ownKeys.end());
    table.checkKeys(keys, {"nodes", "k"});
    if (model.dimension < Element::leastDimension) {
      table.failHere(Element::leastDimension == 3 ? "needs a scene of dimension 3"
                                                  : "needs a scene of dimension 2 or 3");
    }
    Element element;
    const std::vector<int> nodes = readNodes(table, model, static_cast<int>(element.nodes.size()));
    std::ranges::copy(nodes, element.nodes.begin());
    element.k = table.notNegative("k");
    element.readOwn(table, model);
    element.part = readPart(table, model);
    elements.push_back(element);
  }
}

// --- what acts on chosen nodes ---

void readPin(const TableReader& table, Scene& scene) {
  table.checkKeys(selectionKeys, {});
  for (const int i : selectNodes(table, scene)) {
    ModelNode& node = scene.model.nodes[static_cast<std::size_t>(i)];
    node.pinned = true;
    node.v = Vec3::Zero();
  }
}

void readVelocity(const TableReader& table, Scene& scene) {
  table.checkKeys(with({"v"}, selectionKeys), {"v"});
  const Vec3 v = table.vector("v");
  for (const int i : selectNodes(table, scene)) scene.model.nodes[static_cast<std::size_t>(i)].v = v;
}

void readMotion(const TableReader& table, Scene& scene) {
  table.checkKeys(with({"displacement", "amplitude", "velocity", "during", "frequency"}, selectionKeys), {});
  const std::string kind = table.oneKeyOf({"displacement", "amplitude", "velocity"}, true);
  const auto [from, to] = table.has("during") ? table.interval("during") : std::pair(0.0, forever);
  Motion about;  // by how much, and how fast, the nodes have moved
  if (kind == "displacement") {
    if (!table.has("during")) table.fail("during", "missing: a displacement takes a time, [t0, t1]");
    about = smoothStroke(table.vector("displacement"), from, to);
  } else if (kind == "amplitude") {
    if (!table.has("frequency")) table.fail("frequency", "missing: an amplitude needs a frequency [Hz]");
    about = oscillation(table.vector("amplitude"), table.positive("frequency"), from, to);
  } else {
    about = steadyMotion(table.vector("velocity"), from, to);
  }
  for (const int i : selectNodes(table, scene)) {
    ModelNode& node = scene.model.nodes[static_cast<std::size_t>(i)];
    if (!isFree(node)) table.failHere(fmt::format("node {} is pinned or moved already", i));
    node.motion = static_cast<int>(scene.model.motions.size());
    scene.model.motions.push_back(startingAt(node.x, about));
  }
}

void readForce(const TableReader& table, Scene& scene) {
  table.refuseOtherNames({{"force", "F"}});
  table.checkKeys(with({"F", "during", "frequency", "part"}, selectionKeys), {"F"});
  const Vec3 F = table.vector("F");
  const auto [from, to] = table.has("during") ? table.interval("during") : std::pair(0.0, forever);
  const double frequency = table.positive("frequency", 0.0);
  scene.model.externalForces.push_back(externalForce(selectNodes(table, scene), F, from, to, frequency));
  scene.model.externalForces.back().part = readPart(table, scene.model);
}

void readProperty(const TableReader& table, Scene& scene) {
  table.checkKeys(with({"axis", "k", "p0", "part"}, selectionKeys), {"axis", "k", "p0"});
  ModelProperty property;
  property.nodes = selectNodes(table, scene);
  const Vec3 weight = Vec3::Unit(readAxis(table, "axis")) / static_cast<double>(property.nodes.size());
  property.weights.assign(property.nodes.size(), weight);
  property.k = table.notNegative("k");
  property.p0 = table.number("p0");
  property.part = readPart(table, scene.model);
  scene.model.properties.push_back(std::move(property));
}

void readObstacle(const TableReader& table, Model& model) {
  static const Keys material = {"name",      "shape",        "k",           "d", "mu", "velocity",
                                "stop_time", "k_tangential", "d_tangential"};
  table.refuseOtherNames(
      {{"kind", "shape"}, {"type", "shape"}, {"stiffness", "k"}, {"friction", "mu"}, {"damping", "d"}});
  const std::string shape = table.choice("shape", {"plane", "sphere", "box"});
  Obstacle obstacle;
  if (shape == "plane") {
    table.checkKeys(with(material, {"point", "normal"}), {"k", "point"});
    obstacle.kind = Obstacle::Kind::Plane;
    obstacle.centre = table.vector("point");
    obstacle.normal = Vec3::Unit(upAxisOf(model));
    if (table.has("normal")) obstacle.normal = table.direction("normal");
  } else if (shape == "sphere") {
    table.checkKeys(with(material, {"centre", "radius"}), {"k", "centre", "radius"});
    obstacle.kind = Obstacle::Kind::Sphere;
    obstacle.centre = table.vector("centre");
    obstacle.radius = table.positive("radius");
  } else {
    table.checkKeys(with(material, {"centre", "half_size"}), {"k", "centre", "half_size"});
    obstacle.kind = Obstacle::Kind::Box;
    obstacle.centre = table.vector("centre");
    obstacle.halfSize = table.sizes("half_size", true);
  }
  obstacle.name = table.text("name", shape);
  obstacle.material = {table.positive("k"), table.notNegative("d", 0.0), table.notNegative("mu", 0.0),
                       table.notNegative("k_tangential", 0.0), table.notNegative("d_tangential", 0.0)};
  obstacle.velocity = table.vector("velocity", Vec3::Zero());
  obstacle.stopTime = table.notNegative("stop_time", forever);
  model.obstacles.push_back(std::move(obstacle));
}

// --- how it runs, and what is measured ---

void readRun(const TableReader& table, Scene& scene) {
  table.refuseOtherNames(
      {{"integrator", "method"}, {"dt", "step"}, {"h", "step"}, {"time", "duration"}, {"locate_events", "events"}});
  table.checkKeys(
      {"method", "step", "tolerance", "duration", "output_interval", "largest_step", "events", "compensated"},
      {"method", "duration"});
  scene.method = table.text("method");
  if (std::ranges::find(methodIds(), scene.method) == methodIds().end()) {
    table.fail("method", fmt::format("no method '{}'{}", printableLine(scene.method), methodSuggestion(scene.method)));
  }
  scene.duration = table.positive("duration");
  if (table.has("step")) scene.step = table.positive("step");
  if (table.has("tolerance")) {
    scene.tolerance = table.positive("tolerance");
    if (*scene.tolerance > 1.0) {
      table.fail("tolerance", "bounds the error of a step in parts of the motion, so it is at most 1");
    }
  }
  const bool adaptive = methodInfo(scene.method).adaptive;
  if (!scene.step && !adaptive) table.fail("step", fmt::format("missing: {} needs a step [s]", scene.method));
  if (!scene.step && !scene.tolerance) {
    table.fail("tolerance", fmt::format("missing: {} needs a tolerance or a step", scene.method));
  }
  scene.outputInterval = table.notNegative("output_interval", 0.0);
  scene.largestStep = table.positive("largest_step", forever);
  scene.locateEvents = table.flag("events", true);
  scene.compensated = table.flag("compensated", false);
}

SceneOutput readOutput(const TableReader& table, const Scene& scene) {
  using Kind = SceneOutput::Kind;
  static const std::vector<std::pair<std::string, Kind>> kinds = {
      {"position", Kind::Position}, {"velocity", Kind::Velocity}, {"mean_position", Kind::MeanPosition},
      {"lowest", Kind::Lowest},     {"highest", Kind::Highest},   {"distance", Kind::Distance},
      {"path", Kind::Path}};
  Keys names;
  for (const auto& [name, kind] : kinds) names.push_back(name);
  const std::string word = table.choice("kind", names);
  SceneOutput output;
  output.kind = std::ranges::find(kinds, word, &std::pair<std::string, Kind>::first)->second;
  const bool hasAxis = output.kind != Kind::Distance && output.kind != Kind::Path;
  table.checkKeys(with(hasAxis ? Keys{"kind", "name", "axis"} : Keys{"kind", "name"}, selectionKeys), {"kind", "name"});
  output.name = table.text("name");
  if (hasAxis) output.axis = readAxis(table, "axis");
  const bool one = output.kind == Kind::Position || output.kind == Kind::Velocity || output.kind == Kind::Path;
  output.nodes = selectNodes(table, scene, one ? 1 : output.kind == Kind::Distance ? 2 : 0);
  if (output.kind == Kind::Distance && output.nodes.size() != 2) table.fail("nodes", "a distance has two nodes");
  const auto isTwin = [&](const SceneOutput& other) { return other.name == output.name; };
  if (std::ranges::any_of(scene.outputs, isTwin)) {
    table.fail("name", fmt::format("'{}' is already that of another output", printableLine(output.name)));
  }
  return output;
}

void readView(const TableReader& table, Scene& scene) {
  if (scene.model.dimension == 2) scene.view = scene.model.plane;
  if (scene.model.dimension == 1) scene.view = {0, 0};
  if (!table.has("view")) return;
  if (scene.model.dimension != 3) table.fail("view", "needs dimension = 3: other scenes have one view");
  scene.view = readPlane(table, "view");
}

Scene interpret(const TableReader& given, const std::filesystem::path& file) {
  TableReader table = given;
  Scene scene;
  Model& model = scene.model;
  Keys keys = {"title",     "shows",  "slide", "dimension", "plane",  "gravity",  "cross_zero_length",
               "precision", "view",   "node",  "object",    "spring", "property", "pin",
               "velocity",  "motion", "force", "obstacle",  "run",    "output"};
  forEachElementKind(model, [&]<class List>(const List&) { keys.emplace_back(ElementOf<List>::kind); });
  table.checkKeys(keys, {"title", "shows", "slide", "run"});
  scene.name = file.stem().string();
  scene.title = table.text("title");
  scene.shows = table.text("shows");
  scene.slide = table.text("slide");
  table.setSpace(readSpace(table, model));
  readGravity(table, model);
  model.springsCross = table.flag("cross_zero_length", false);
  if (table.has("precision")) model.precision = readPrecision(table);
  readView(table, scene);
  // Nodes by hand come first, then those of the objects in the order of the file: that is the numbering.
  for (const TableReader& t : table.tables("node")) readNode(t, model);
  for (const TableReader& t : table.tables("object")) readObject(t, scene, file.parent_path());
  if (model.nodes.empty()) table.failHere("has no nodes; [[node]] and [[object]] make them");
  for (const TableReader& t : table.tables("spring")) readSpring(t, model);
  forEachElementKind(model, [&](auto& elements) { readElements(table, model, elements); });
  for (const TableReader& t : table.tables("property")) readProperty(t, scene);
  for (const TableReader& t : table.tables("velocity")) readVelocity(t, scene);
  for (const TableReader& t : table.tables("pin")) readPin(t, scene);
  for (const TableReader& t : table.tables("motion")) readMotion(t, scene);
  std::size_t node = 0;
  for (const TableReader& t : table.tables("node")) requireMass(t, model.nodes[node++]);
  for (const TableReader& t : table.tables("force")) readForce(t, scene);
  for (const TableReader& t : table.tables("obstacle")) readObstacle(t, model);
  const auto run = table.table("run");
  readRun(*run, scene);
  for (const TableReader& t : table.tables("output")) scene.outputs.push_back(readOutput(t, scene));
  return scene;
}

}  // namespace

Scene readScene(const std::filesystem::path& file) {
  const std::string name = printableLine(file.string());
  const TomlValue root = readToml(file, name);
  return interpret(TableReader(root, name, "the scene"), file);
}

std::vector<std::filesystem::path> listScenes(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  if (!std::filesystem::is_directory(folder)) {
    throw std::runtime_error(fmt::format("no folder of scenes at {}", folder.string()));
  }
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

std::filesystem::path findScene(const std::string& nameOrPath, const std::filesystem::path& folder) {
  if (nameOrPath.ends_with(".toml") || nameOrPath.find('/') != std::string::npos) {
    if (std::filesystem::is_regular_file(nameOrPath)) return nameOrPath;
    throw std::runtime_error(fmt::format("no scene file {}", printableLine(nameOrPath)));
  }
  std::vector<std::string> names;
  for (const std::filesystem::path& file : listScenes(folder)) {
    names.push_back(file.stem().string());
    if (names.back() == nameOrPath) return file;
  }
  throw std::runtime_error(fmt::format("no scene '{}'{}", printableLine(nameOrPath), suggestion(nameOrPath, names)));
}

}  // namespace muelle::engine
