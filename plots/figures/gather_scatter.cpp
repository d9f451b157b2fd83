#include "engine/scene/generators.h"
#include "tools.h"

#include <fmt/format.h>

namespace muelle::plots::gather_scatter {

namespace {

/// Springs at each node, as the first program of the slides keeps them.
std::vector<std::vector<int>> springsOfNodes(const engine::Model& model) {
  std::vector<std::vector<int>> lists(model.nodes.size());
  for (std::size_t s = 0; s < model.springs.size(); ++s) {
    for (const int node : {model.springs[s].a, model.springs[s].b}) {
      lists[static_cast<std::size_t>(node)].push_back(static_cast<int>(s));
    }
  }
  return lists;
}

engine::Model cloth(int n) {
  engine::GridShape shape;
  shape.nu = shape.nv = n;
  shape.shearStiffness = 10.0;
  engine::Model model;
  engine::addGrid(model, shape);
  return model;
}

/// Node against spring: who calculates, and who is handed the result.
struct Table {
  std::vector<double> calculatedSpring, calculatedNode, handedSpring, handedNode;
};

}  // namespace

/// Slides "Código Object-Oriented" (1) and (2): nodes that gather from their springs calculate each spring twice;
/// springs that scatter to their nodes, once.
Figure gather_scatter() {
  const engine::Model small = cloth(2);
  Table gather, scatter;
  const auto lists = springsOfNodes(small);
  for (std::size_t node = 0; node < lists.size(); ++node) {
    for (const int spring : lists[node]) {
      gather.calculatedSpring.push_back(spring);
      gather.calculatedNode.push_back(static_cast<double>(node));
    }
  }
  for (std::size_t s = 0; s < small.springs.size(); ++s) {
    scatter.calculatedSpring.push_back(static_cast<double>(s));
    scatter.calculatedNode.push_back(small.springs[s].a);
    scatter.handedSpring.push_back(static_cast<double>(s));
    scatter.handedNode.push_back(small.springs[s].b);
  }
  std::vector<std::string> nodeNames, springNames;
  for (std::size_t i = 0; i < small.nodes.size(); ++i) nodeNames.push_back(fmt::format("node {}", i));
  for (const auto& s : small.springs) springNames.push_back(fmt::format("{}–{}", s.a, s.b));

  std::vector<double> nodes, gathered, scattered;
  for (const int n : {2, 5, 8, 11, 14, 17, 20}) {
    const engine::Model model = cloth(n);
    std::size_t calls = 0;
    for (const auto& springs : springsOfNodes(model)) calls += springs.size();
    nodes.push_back(n * n);
    gathered.push_back(static_cast<double>(calls));
    scattered.push_back(static_cast<double>(model.springs.size()));
  }

  Figure figure("gather_scatter",
                "Gathering in the nodes calculates every spring twice, scattering from the springs once",
                "spring between nodes");
  figure.slide(3);
  figure.panel("")
      .heading("gather: for each node, its springs")
      .cells(fmt::format("calculated ({})", gather.calculatedNode.size()), gather.calculatedSpring,
             gather.calculatedNode)
      .colour(1)
      .xNames(springNames)
      .yNames(nodeNames);
  figure.panel("")
      .heading("scatter: for each spring, its nodes")
      .cells(fmt::format("calculated ({})", scatter.calculatedNode.size()), scatter.calculatedSpring,
             scatter.calculatedNode)
      .colour(1)
      .cells("handed −F", scatter.handedSpring, scatter.handedNode)
      .colour(5)
      .xNames(springNames)
      .yNames(nodeNames);
  figure.panel("spring forces per step")
      .heading("a cloth with diagonals")
      .xLabel("nodes")
      .linePoints("gather", nodes, gathered)
      .linePoints("scatter", nodes, scattered)
      .xRange(0, 400)
      .yRange(0, 3200);
  return figure;
}

}  // namespace muelle::plots::gather_scatter
