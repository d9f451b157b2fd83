#include "drawing.h"
#include "tools.h"

#include <fmt/format.h>

namespace muelle::plots::triangle_forces {

namespace {

/// Nodes at these places, all springs 0.8 m at rest; only the springs named act.
std::unique_ptr<engine::ModelSystem> triangle(const std::vector<int>& acting) {
  engine::Model model;
  model.dimension = 2;
  model.nodes.resize(3);
  model.nodes[1].x = Vec3(1.6, 0.0, 0.1);
  model.nodes[2].x = Vec3(0.55, 0.0, 1.2);
  for (const int i : acting) model.springs.push_back({.a = i, .b = (i + 1) % 3, .k = 50.0, .L0 = 0.8});
  return engine::build(model);
}

}  // namespace

/// Slide "Formulación Multidimensional", exercise: the elastic force of a triangle of three nodes and three springs.
Figure triangle_forces() {
  const double metresPerNewton = 1.0 / 80.0;
  const int springColours[] = {0, 2, 3};
  Figure figure("triangle_forces", "A stretched triangle: two forces on each node, and their sums add up to zero",
                "x [m]");
  figure.slide(2);
  auto plane = figure.panel("z [m]");
  plane.heading("forces on the nodes: 1 m is 80 N");
  for (const int i : {0, 1, 2}) {
    const auto alone = triangle({i});
    const State state = alone->initialState();
    const Segments line = springsOf(*alone, state);
    plane.structure("", line.x, line.y);
    Arrows pair;
    for (const int node : {i, (i + 1) % 3}) {
      pair.add(alone->position(state, node), metresPerNewton * forceOn(*alone, state, node));
    }
    pair.addTo(plane, fmt::format("spring {}–{}", i, (i + 1) % 3), springColours[i]);
  }
  const auto whole = triangle({0, 1, 2});
  const State state = whole->initialState();
  std::vector<double> nodesX, nodesZ;
  Arrows sums, chain;
  Vec3 tip = Vec3::Zero();
  for (const int node : {0, 1, 2}) {
    const Vec3 sum = forceOn(*whole, state, node);
    sums.add(whole->position(state, node), metresPerNewton * sum);
    nodesX.push_back(whole->position(state, node).x());
    nodesZ.push_back(whole->position(state, node).z());
    chain.add(tip, sum);
    tip += sum;
  }
  sums.addTo(plane, "sum", 1);
  plane.nodes("", nodesX, nodesZ).equalAxes().xRange(-0.3, 1.9).yRange(-0.3, 1.5);
  plane.note(-0.2, -0.1, "node 0").note(1.55, -0.05, "node 1").note(0.45, 1.32, "node 2");

  auto sum = figure.panel("force along z [N]");
  sum.heading("the sums, tip to tail: they close").xLabel("force along x [N]");
  chain.addTo(sum, "", 1);
  for (std::size_t i = 0; i < 3; ++i) {
    sum.note(chain.x[i] + 0.5 * chain.dx[i] + (i == 2 ? 10.0 : 6.0),
             chain.y[i] + 0.5 * chain.dy[i] + (i == 0 ? -5.0 : 5.0), fmt::format("on node {}", i), true);
  }
  sum.equalAxes();
  return figure;
}

}  // namespace muelle::plots::triangle_forces
