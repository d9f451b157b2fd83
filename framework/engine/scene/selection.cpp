#include "engine/scene/selection.h"

#include "base/text/count.h"
#include "base/text/lists.h"
#include "base/text/nearest.h"
#include "base/text/printable.h"

#include <fmt/format.h>
#include <algorithm>
#include <limits>
#include <numeric>

namespace muelle::engine {

namespace {

const Vec3& positionOf(const Scene& scene, int node) { return scene.model.nodes[static_cast<std::size_t>(node)].x; }

/// First node and number of nodes among which a table chooses.
std::pair<int, int> chosenRange(const TableReader& table, const Scene& scene) {
  if (!table.has("object")) return {0, static_cast<int>(scene.model.nodes.size())};
  const std::string name = table.text("object");
  std::vector<std::string> names;
  for (const Part& part : scene.parts) {
    if (part.name == name) return {part.firstNode, part.nodeCount};
    names.push_back(part.name);
  }
  table.fail("object", fmt::format("no object '{}'{}", printableLine(name), suggestion(name, names)));
}

std::vector<int> range(int first, int count) {
  std::vector<int> nodes(static_cast<std::size_t>(count));
  std::iota(nodes.begin(), nodes.end(), first);
  return nodes;
}

/// Keeps the nodes at the least (sign -1) or greatest (+1) component, within 1e-9 of the extent.
std::vector<int> extremeNodes(const Scene& scene, const std::vector<int>& nodes, int axis, int sign) {
  double best = -std::numeric_limits<double>::infinity();
  double worst = std::numeric_limits<double>::infinity();
  for (const int node : nodes) {
    best = std::max(best, sign * positionOf(scene, node)[axis]);
    worst = std::min(worst, sign * positionOf(scene, node)[axis]);
  }
  std::vector<int> kept;
  for (const int node : nodes) {
    if (sign * positionOf(scene, node)[axis] >= best - 1e-9 * (best - worst)) kept.push_back(node);
  }
  return kept;
}

/// "-x +z": the nodes with the least x and the greatest z of all that are chosen from.
std::vector<int> cornerNodes(const TableReader& table, const Scene& scene, const std::vector<int>& from) {
  const std::string text = table.text("corner");
  const std::vector<std::string> axes = axisNames(table.space());
  std::vector<int> nodes = from;
  std::size_t words = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == ' ') continue;
    const bool isSigned = text[i] == '+' || text[i] == '-';
    const std::string axis = i + 1 < text.size() ? text.substr(i + 1, 1) : "";
    if (!isSigned || std::ranges::find(axes, axis) == axes.end()) {
      table.fail("corner", fmt::format("'{}' is no corner; expected signs with axes of {}, as in \"-{} +{}\"",
                                       printableLine(text), joined(axes, ", "), axes.front(), axes.back()));
    }
    // One after the other, each among those that all signs choose from: a corner, not a corner of a corner.
    const std::vector<int> extreme = extremeNodes(scene, from, axis[0] - 'x', text[i] == '+' ? 1 : -1);
    std::erase_if(nodes, [&](int node) { return !std::ranges::binary_search(extreme, node); });
    ++words;
    ++i;
  }
  if (words == 0) table.fail("corner", "names no axis");
  return nodes;
}

std::vector<int> nodesWithin(const TableReader& table, const Scene& scene, const std::vector<int>& from) {
  const auto [least, most] = table.corners("within");
  std::vector<int> nodes;
  const Space& space = table.space();
  for (const int node : from) {
    const Vec3& x = positionOf(scene, node);
    bool isInside = true;
    for (const std::string& axis : axisNames(space)) {
      const int i = axis[0] - 'x';
      isInside = isInside && x[i] >= least[i] && x[i] <= most[i];
    }
    if (isInside) nodes.push_back(node);
  }
  return nodes;
}

}  // namespace

const TableReader::Keys selectionKeys = {"object", "nodes", "within", "corner", "all"};

std::vector<std::string> axisNames(const Space& space) {
  static const std::vector<std::string> all = {"x", "y", "z"};
  if (space.dimension == 3) return all;
  if (space.dimension == 1) return {"x"};
  return {all[static_cast<std::size_t>(space.plane[0])], all[static_cast<std::size_t>(space.plane[1])]};
}

int readAxis(const TableReader& table, const std::string& key) {
  return table.choice(key, axisNames(table.space()))[0] - 'x';
}

std::vector<int> readNumbers(const TableReader& table, int count, int available, const std::string& whose) {
  using Limits = std::numeric_limits<int>;
  std::vector<int> nodes = table.integers("nodes", count, Limits::min(), Limits::max());
  for (const int node : nodes) {
    if (node >= 0 && node < available) continue;
    table.fail("nodes", fmt::format("there is no node {}; {} has {}, numbered from 0", node, whose,
                                    countedInGroups(available, "node")));
  }
  return nodes;
}

std::vector<int> selectNodes(const TableReader& table, const Scene& scene, int most) {
  const auto [first, count] = chosenRange(table, scene);
  if (count == 0) table.failHere("the scene has no nodes yet");
  const std::string key = table.oneKeyOf({"nodes", "within", "corner", "all"}, true);
  const std::vector<int> from = range(first, count);
  std::vector<int> nodes;
  if (key == "nodes") {
    const std::string whose =
        table.has("object") ? fmt::format("object '{}'", printableLine(table.text("object"))) : "the scene";
    for (const int index : readNumbers(table, 0, count, whose)) nodes.push_back(first + index);
    std::ranges::sort(nodes);
    if (std::ranges::adjacent_find(nodes) != nodes.end()) table.fail("nodes", "a node stands twice");
  } else if (key == "within") {
    nodes = nodesWithin(table, scene, from);
  } else if (key == "corner") {
    nodes = cornerNodes(table, scene, from);
  } else if (table.flag("all", false)) {
    nodes = from;
  }
  if (nodes.empty()) table.fail(key, "chooses no node");
  if (most > 0 && nodes.size() > static_cast<std::size_t>(most)) {
    table.fail(key, fmt::format("chooses {} nodes; at most {} here", nodes.size(), most));
  }
  return nodes;
}

}  // namespace muelle::engine
