#include "engine/scene/generators.h"
#include "engine/statics/equilibrium.h"
#include "tools.h"

#include <fmt/format.h>
#include <cmath>

namespace muelle::plots::bending_springs {

namespace {

const int springs = 20;
const double length = 1.0, spacing = length / springs, mass = 0.1, g = 9.81;

/// A strip held at its first two nodes, so that it leaves the wall level.
engine::Model strip(double angleStiffness) {
  engine::Model model;
  model.dimension = 2;
  model.gravity = Vec3(0.0, 0.0, -g);
  engine::ChainShape shape{.n = springs + 2, .from = Vec3(-spacing, 0.0, 0.0), .to = Vec3(length, 0.0, 0.0)};
  shape.spring.k = 1e5;
  shape.angleStiffness = angleStiffness;
  engine::addChain(model, shape);
  // The angle at the clamp stands for half a spring's length of beam: twice as stiff.
  if (!model.angles.empty()) model.angles.front().k *= 2.0;
  for (auto& node : model.nodes) node.m = mass / springs;
  model.nodes.back().m *= 0.5;  // a node stands for half a spring on each side
  model.nodes[0].pinned = model.nodes[1].pinned = true;
  return model;
}

struct Shape {
  std::vector<double> x, z;
};

Shape atRest(double angleStiffness) {
  const auto system = engine::build(strip(angleStiffness));
  const State state = engine::equilibrium(*system, system->initialState()).state;
  Shape shape;
  for (int i = 1; i < system->nodeCount(); ++i) {
    shape.x.push_back(system->position(state, i).x());
    shape.z.push_back(system->position(state, i).z());
  }
  return shape;
}

}  // namespace

/// Slide "Aplicaciones", generalised springs: springs between neighbours keep lengths and nothing else; an energy of
/// the turning angles makes a beam of them.
Figure bending_springs() {
  Figure figure("bending_springs", "An energy of the angles makes a beam of a chain", "x [m]");
  figure.slide(2);
  auto shapes = figure.panel("z [m]");
  shapes.heading("at rest under its weight, held at the left");
  for (const double k : {20.0, 2.0, 0.5, 0.0}) {
    const Shape shape = atRest(k);
    shapes.linePoints(k > 0.0 ? fmt::format("k = {} J/rad²", k) : "no angles", shape.x, shape.z);
  }
  shapes.equalAxes().xRange(-0.1, 1.1).yRange(-1.1, 0.1);

  std::vector<double> stiffness = logarithmic(0.1, 1000.0, 17), drop, theory;
  for (const double k : stiffness) {
    drop.push_back(-atRest(k).z.back());
    // Euler and Bernoulli: w L^4 / (8 E I) with E I = k spacing, for small slopes.
    theory.push_back(mass * g / length * std::pow(length, 4) / (8.0 * k * spacing));
  }
  figure.panel("drop of the free end [m]")
      .heading("a beam while it bends little")
      .xLabel("k of the angles [J/rad²]")
      .linePoints("chain", stiffness, drop)
      .reference("beam theory", stiffness, theory)
      .logX()
      .logY()
      .yRange(0.001, 30);
  return figure;
}

}  // namespace muelle::plots::bending_springs
