#include "base/text/nearest.h"
#include "engine/scene/generators.h"
#include "engine/scene/scene.h"
#include "lab/bench/scene.h"
#include "lab/run/shipped_scenes.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <stdexcept>

namespace muelle::bench {

using namespace engine;

namespace {

constexpr double g = 9.81;
constexpr double pi = std::numbers::pi;

ModelNode nodeAt(const Vec3& x, double m, bool pinned = false) {
  ModelNode node;
  node.x = x;
  node.m = m;
  node.pinned = pinned;
  return node;
}

BenchScene oscillator() {
  BenchScene scene{.name = "oscillator", .title = "Oscillator"};
  scene.model.dimension = 1;
  scene.model.nodes = {nodeAt({0, 0, 0}, 1.0, true), nodeAt({1.2, 0, 0}, 1.0)};
  scene.model.springs = {{0, 1, 100.0, 1.0}};
  scene.duration = 100.0 * 2.0 * pi / 10.0;
  scene.quick = true;
  scene.samples = 400;
  return scene;
}

BenchScene pendulum() {
  BenchScene scene{.name = "pendulum", .title = "Elastic pendulum"};
  scene.model.dimension = 2;
  scene.model.gravity = {0, 0, -g};
  scene.model.nodes = {nodeAt({0, 0, 0}, 1.0, true), nodeAt({0.3, 0, -1.0}, 1.0)};
  scene.model.springs = {{0, 1, 100.0, 1.0}};
  scene.duration = 10.0;
  scene.quick = true;
  scene.samples = 400;
  return scene;
}

/// Hangs straight, each spring as long as its load makes it, and is set off sideways by half a wave of 1 m/s.
BenchScene chain() {
  BenchScene scene{.name = "chain", .title = "Chain of 100 with drag and damping", .kind = SceneKind::Grid};
  constexpr int n = 100;
  constexpr double m = 0.01, k = 1e4, L0 = 0.01;
  scene.model.gravity = {0, 0, -g};
  scene.model.nodes.push_back(nodeAt({0, 0, 0}, m, true));
  double z = 0.0;
  for (int i = 1; i <= n; ++i) {
    z -= L0 + (n - i + 1) * m * g / k;
    ModelNode node = nodeAt({0, 0, z}, m);
    node.v = {std::sin(pi * i / n), 0.5 * std::sin(2.0 * pi * i / n), 0.0};
    node.drag = m;  // 1/s times the mass
    scene.model.nodes.push_back(node);
    scene.model.springs.push_back({i - 1, i, k, L0, 0.0, 0.1});
  }
  scene.duration = 2.0;
  scene.quick = true;
  scene.quickDuration = 0.5;
  return scene;
}

/// n x n nodes of 1 m and 1 kg with springs of all three kinds, in the x-y plane.
Model square(int n, double k, double d, bool bend) {
  Model model;
  model.gravity = {0, 0, -g};
  GridShape shape;
  shape.nu = shape.nv = n;
  shape.spacing = 1.0 / (n - 1);
  shape.structural.k = shape.shearStiffness = k;
  shape.bendStiffness = bend ? k : 0.0;
  shape.structural.dProjected = d;
  const Part part = addGrid(model, shape);
  lumpMass(model, part, 1.0);
  return model;
}

BenchScene cloth(int n, double duration) {
  BenchScene scene{.name = fmt::format("cloth_{}", n),
                   .title = fmt::format("Cloth of {0} x {0}, lightly damped", n),
                   .model = waveCloth(n, 1e5, 1.0, 1.0),
                   .kind = SceneKind::Grid};
  scene.duration = duration;
  scene.quick = n == 16;
  scene.quickDuration = 0.03;
  scene.samples = 40;
  return scene;
}

BenchScene clothOfAnyTopology() {
  BenchScene scene = cloth(32, 1.0);
  scene.name = "cloth_32_shuffled";
  scene.title = "Cloth of 32 x 32, nodes and springs in random order (peers: in order)";
  scene.kind = SceneKind::General;
  scene.peerModel = scene.model;
  scene.model = shuffled(scene.peerModel, scene.placeOfPeerNode);
  return scene;
}

BenchScene dampedCloth(int n, double duration) {
  BenchScene scene{.name = fmt::format("damped_cloth_{}", n),
                   .title = fmt::format("Cloth of {0} x {0} dominated by damping", n),
                   .model = waveCloth(n, 1e3, 0.0, 1.0),
                   .kind = SceneKind::Damped};
  // Six times the critical damping of each spring with its two nodes: d = 6 * 2 sqrt(k m / 2).
  const double m = 1.0 / (n * n);
  for (ModelSpring& spring : scene.model.springs) spring.dProjected = 6.0 * 2.0 * std::sqrt(spring.k * m / 2.0);
  scene.duration = duration;
  scene.quick = n == 16;
  scene.quickDuration = 0.05;
  scene.samples = 40;
  return scene;
}

/// Held all around, every spring a tenth longer than its rest length; starts as a wave of displacement.
BenchScene drum() {
  BenchScene scene{.name = "drum", .title = "Drum of 16 x 16 with pre-tension", .kind = SceneKind::Grid};
  constexpr int n = 16;
  scene.model = square(n, 1e4, 0.0, true);
  for (int i = 0; i < n * n; ++i) {
    ModelNode& node = scene.model.nodes[static_cast<std::size_t>(i)];
    const int column = i % n, row = i / n;
    node.pinned = column == 0 || column == n - 1 || row == 0 || row == n - 1;
    if (!node.pinned) node.x[2] = 0.05 * std::sin(2.0 * pi * node.x[0]) * std::sin(pi * node.x[1]);
  }
  for (ModelSpring& spring : scene.model.springs) spring.L0 /= 1.1;
  scene.duration = 0.2;
  scene.quick = true;
  scene.quickDuration = 0.04;
  scene.samples = 40;
  return scene;
}

BenchScene ball() {
  BenchScene scene{.name = "ball", .title = "Ball bouncing on a stiff ground", .kind = SceneKind::Bounce};
  scene.model.dimension = 1;
  scene.model.gravity = {-g, 0, 0};
  scene.model.nodes = {nodeAt({1.0, 0, 0}, 1.0)};
  Obstacle ground;
  ground.normal = Vec3::UnitX();
  ground.material.k = 1e5;
  scene.model.obstacles = {ground};
  scene.duration = 5.0;
  scene.quick = true;
  scene.samples = 400;
  return scene;
}

/// A shipped scene without its friction, which no peer has, and for a shorter time.
BenchScene shipped(const std::string& file, BenchScene scene) {
  scene.model = readScene(findScene(file, lab::shippedScenes())).model;
  for (Obstacle& obstacle : scene.model.obstacles) obstacle.material.mu = 0.0;
  scene.kind = SceneKind::General;
  scene.locateEvents = false;  // hundreds of nodes touch and leave
  scene.samples = 25;
  return scene;
}

struct NamedScene {
  std::string name;
  std::function<BenchScene()> make;
};

const std::vector<NamedScene>& namedScenes() {
  static const std::vector<NamedScene> all = {
      {"oscillator", oscillator},
      {"pendulum", pendulum},
      {"chain", chain},
      {"cloth_16", [] { return cloth(16, 1.0); }},
      {"cloth_32", [] { return cloth(32, 1.0); }},
      {"cloth_32_shuffled", clothOfAnyTopology},
      {"cloth_64", [] { return cloth(64, 0.1); }},
      {"damped_cloth_16", [] { return dampedCloth(16, 1.0); }},
      {"damped_cloth_32", [] { return dampedCloth(32, 0.5); }},
      {"damped_cloth_64", [] { return dampedCloth(64, 0.1); }},
      {"drum", drum},
      {"ball", ball},
      {"rabbit",
       [] {
         return shipped("rabbit_squeezed",
                        {.name = "rabbit", .title = "Rabbit squeezed between plates", .duration = 0.2});
       }},
      {"jelly",
       [] {
         return shipped("jelly_box", {.name = "jelly", .title = "Box of jelly falls on its edge", .duration = 0.4});
       }},
  };
  return all;
}

}  // namespace

long long BenchScene::stepsOf(double h) const {
  // A step that divides the duration but for rounding is not cut into one more.
  long long steps = std::max(1LL, static_cast<long long>(std::ceil(duration / h * (1.0 - 1e-9))));
  if (steps > samples) return (steps + samples - 1) / samples * samples;
  while (samples % steps != 0) ++steps;
  return steps;
}

std::vector<std::string> sceneNames() {
  std::vector<std::string> names;
  for (const NamedScene& entry : namedScenes()) names.push_back(entry.name);
  return names;
}

BenchScene makeScene(const std::string& name) {
  for (const NamedScene& entry : namedScenes()) {
    if (entry.name == name) return entry.make();
  }
  const std::string guess = didYouMean(name, sceneNames());
  throw std::invalid_argument(
      fmt::format("--scene {}: no scene of the sweep{}", name, guess.empty() ? "; --list names them" : guess));
}

int unknownsOf(const Model& model) {
  int unknowns = 0;
  for (const ModelNode& node : model.nodes) unknowns += isFree(node) ? model.dimension : 0;
  return unknowns;
}

Model waveCloth(int n, double k, double d, double drag) {
  Model model = square(n, k, d, true);
  for (ModelSpring& spring : model.springs) spring.dProjected = d;
  for (ModelNode& node : model.nodes) {
    const double across = node.x[0], down = node.x[1];
    node.x = {across, 0.15 * std::sin(2.0 * pi * across) * std::sin(0.5 * pi * down), -down};
    node.drag = drag * node.m;
  }
  for (ModelSpring& spring : model.springs) {
    const auto place = [&model](int node) { return model.nodes[static_cast<std::size_t>(node)].x; };
    spring.L0 = (place(spring.a) - place(spring.b)).norm();
  }
  model.nodes[0].pinned = model.nodes[static_cast<std::size_t>(n - 1)].pinned = true;
  return model;
}

Model shuffled(const Model& model, std::vector<std::size_t>& place) {
  // Fisher and Yates by hand: std::shuffle draws differently from library to library.
  std::mt19937 dice(20'261'129);
  const auto order = [&dice](std::size_t count) {
    std::vector<std::size_t> places(count);
    for (std::size_t i = 0; i < count; ++i) places[i] = i;
    for (std::size_t i = count; i-- > 1;) std::swap(places[i], places[dice() % (i + 1)]);
    return places;
  };
  Model result = model;
  place = order(model.nodes.size());
  const std::vector<std::size_t> turn = order(model.springs.size());
  for (std::size_t i = 0; i < place.size(); ++i) result.nodes[place[i]] = model.nodes[i];
  for (std::size_t i = 0; i < turn.size(); ++i) {
    ModelSpring spring = model.springs[i];
    spring.a = static_cast<int>(place[static_cast<std::size_t>(spring.a)]);
    spring.b = static_cast<int>(place[static_cast<std::size_t>(spring.b)]);
    result.springs[turn[i]] = spring;
  }
  return result;
}

}  // namespace muelle::bench
