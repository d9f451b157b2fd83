#include "drawing.h"
#include "engine/statics/equilibrium.h"
#include "tools.h"

#include <fmt/format.h>
#include <algorithm>

namespace muelle::plots::equilibrium_forces {

namespace {

const double metresPerNewton = 1.0 / 100.0;

/// A house of soft springs just above the ground, 1 kg a node and 2 kg the top one, braced by tight diagonals.
engine::Model house() {
  engine::Model model;
  model.dimension = 2;
  model.renumber = false;  // the parts below share the unknowns
  model.gravity = {0.0, 0.0, -9.81};
  for (const auto& [x, z] : {std::pair(-0.5, 0.0), {0.5, 0.0}, {0.5, 0.9}, {-0.5, 0.9}, {0.0, 1.4}}) {
    model.nodes.push_back({.x = {x, 0.0, z}});
  }
  model.nodes.back().m = 2.0;
  for (const auto& [a, b] : {std::pair(0, 1), {1, 2}, {2, 3}, {3, 0}, {0, 2}, {1, 3}, {2, 4}, {3, 4}}) {
    const double length =
        (model.nodes[static_cast<std::size_t>(a)].x - model.nodes[static_cast<std::size_t>(b)].x).norm();
    model.springs.push_back({.a = a, .b = b, .k = 250.0, .L0 = length});
  }
  for (const int diagonal : {4, 5}) model.springs[static_cast<std::size_t>(diagonal)].L0 *= 0.9;
  engine::Obstacle ground;
  ground.material.k = 1000.0;
  model.obstacles.push_back(ground);
  return model;
}

/// The model with a single kind of force left: gravity, the ground, or one spring.
engine::Model onlyGravity(engine::Model model) {
  model.springs.clear();
  model.obstacles.clear();
  return model;
}
engine::Model onlyGround(engine::Model model) {
  model.springs.clear();
  model.gravity = Vec3::Zero();
  return model;
}
engine::Model onlySpring(engine::Model model, std::size_t j) {
  model.springs = {model.springs[j]};
  model.obstacles.clear();
  model.gravity = Vec3::Zero();
  return model;
}

/// Adds an arrow for a force [N] at a point of the plane; none where it vanishes.
void addForce(Arrows& arrows, double x, double z, double forceX, double forceZ, double scale) {
  if (std::max(std::abs(forceX), std::abs(forceZ)) < 1e-9) return;
  arrows.add(Vec3(x, 0.0, z), scale * Vec3(forceX, 0.0, forceZ));
}

std::vector<double> forces(const engine::Model& part, const State& rest) {
  const auto system = engine::build(part);
  State state = system->initialState();
  std::vector<double> f(rest.x.size());
  system->force(0.0, rest.x, rest.v, state.z, f);
  return f;
}

}  // namespace

/// Slide "Contacto Externo", question 2: what is deformed and does not move has forces that sum to 0 at every node.
Figure equilibrium_forces() {
  const engine::Model model = house();
  const auto system = engine::build(model);
  const engine::StaticResult rest = engine::equilibrium(*system, system->initialState());
  const auto& x = rest.state.x;

  Figure figure("equilibrium_forces", "Deformed, but it does not move: the forces sum to 0 at every node", "x [m]");
  figure.slide(2);
  auto whole = figure.panel("z [m]");
  whole.heading("forces on each node: 1 m is 100 N").equalAxes().xRange(-1.0, 1.0).yRange(-0.4, 1.4);
  for (const auto& spring : model.springs) {
    const auto a = static_cast<std::size_t>(spring.a), b = static_cast<std::size_t>(spring.b);
    whole.structure("", {x[2 * a], x[2 * b]}, {x[2 * a + 1], x[2 * b + 1]});
  }
  auto polygon = figure.panel("upward force [N]");
  polygon.heading("left foot: the arrows close")
      .xLabel("force to the right [N]")
      .equalAxes()
      .xRange(-37.0, 9.0)
      .yRange(-42.0, 4.0);

  double penX = 0.0, penY = 0.0;
  const auto draw = [&](const std::string& name, const std::vector<engine::Model>& parts, int colour) {
    Arrows onNodes, chain;
    for (const engine::Model& part : parts) {
      const std::vector<double> f = forces(part, rest.state);
      for (std::size_t i = 0; i < x.size(); i += 2) addForce(onNodes, x[i], x[i + 1], f[i], f[i + 1], metresPerNewton);
      addForce(chain, penX, penY, f[0], f[1], 1.0);
      penX += f[0];
      penY += f[1];
    }
    onNodes.addTo(whole, name, colour);
    chain.addTo(polygon, "", colour);
  };
  std::vector<engine::Model> others;
  for (std::size_t j = 1; j < model.springs.size(); ++j) others.push_back(onlySpring(model, j));
  // In an order in which no arrow of the polygon lies on another.
  draw("springs", {onlySpring(model, 0)}, 0);
  draw("gravity", {onlyGravity(model)}, 2);
  draw("", others, 0);
  draw("contact", {onlyGround(model)}, 1);
  std::vector<double> nodesX, nodesZ;
  for (std::size_t i = 0; i < x.size(); i += 2) {
    nodesX.push_back(x[i]);
    nodesZ.push_back(x[i + 1]);
  }
  whole.nodes("", nodesX, nodesZ);
  polygon.note(-36.5, -18.0, "largest sum at")
      .note(-36.5, -20.5, fmt::format("any node: {} N", asPower(rest.residual)));
  return figure;
}

}  // namespace muelle::plots::equilibrium_forces
