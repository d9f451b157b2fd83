#include "engine/model/numbering.h"

#include <algorithm>

namespace muelle::engine {

namespace {

struct Graph {
  std::vector<int> start;
  std::vector<int> neighbour;

  int degree(int node) const { return start[std::size_t(node) + 1] - start[std::size_t(node)]; }
  std::span<const int> neighbours(int node) const {
    return {neighbour.data() + start[std::size_t(node)], static_cast<std::size_t>(degree(node))};
  }
};

Graph makeGraph(int nodes, std::span<const std::pair<int, int>> edges) {
  std::vector<std::pair<int, int>> both;
  both.reserve(2 * edges.size());
  for (const auto& [a, b] : edges) {
    both.emplace_back(a, b);
    both.emplace_back(b, a);
  }
  std::sort(both.begin(), both.end());
  both.erase(std::unique(both.begin(), both.end()), both.end());
  Graph graph;
  graph.start.assign(static_cast<std::size_t>(nodes) + 1, 0);
  graph.neighbour.reserve(both.size());
  for (const auto& [a, b] : both) {
    ++graph.start[static_cast<std::size_t>(a) + 1];
    graph.neighbour.push_back(b);
  }
  for (std::size_t i = 1; i < graph.start.size(); ++i) graph.start[i] += graph.start[i - 1];
  return graph;
}

/// Appends the part of the graph that holds `root` in breadth-first order, fewer neighbours first; marks it.
/// Returns where the last level starts in `order`.
std::size_t sweep(const Graph& graph, int root, std::vector<int>& mark, int stamp, std::vector<int>& order) {
  std::size_t next = order.size(), level = next, levelEnd = next + 1;
  order.push_back(root);
  mark[static_cast<std::size_t>(root)] = stamp;
  while (next < order.size()) {
    if (next == levelEnd) {
      level = levelEnd;
      levelEnd = order.size();
    }
    const std::size_t first = order.size();
    for (const int other : graph.neighbours(order[next])) {
      if (mark[static_cast<std::size_t>(other)] == stamp) continue;
      mark[static_cast<std::size_t>(other)] = stamp;
      order.push_back(other);
    }
    std::sort(order.begin() + static_cast<std::ptrdiff_t>(first), order.end(),
              [&](int a, int b) { return std::pair(graph.degree(a), a) < std::pair(graph.degree(b), b); });
    ++next;
  }
  return level;
}

}  // namespace

std::vector<int> reverseCuthillMcKee(int nodes, std::span<const std::pair<int, int>> edges) {
  const Graph graph = makeGraph(nodes, edges);
  constexpr int searches = 4;  // sweeps that look for a far end; more change little
  std::vector<int> order, trial, mark(static_cast<std::size_t>(nodes), 0);
  order.reserve(static_cast<std::size_t>(nodes));
  std::vector<char> done(static_cast<std::size_t>(nodes), 0);
  int stamp = 0;
  for (int seed = 0; seed < nodes; ++seed) {
    if (done[static_cast<std::size_t>(seed)]) continue;
    int root = seed;
    for (int i = 0; i < searches; ++i) {
      trial.clear();
      const std::size_t last = sweep(graph, root, mark, ++stamp, trial);
      root = *std::min_element(trial.begin() + static_cast<std::ptrdiff_t>(last), trial.end(),
                               [&](int a, int b) { return graph.degree(a) < graph.degree(b); });
    }
    const std::size_t first = order.size();
    sweep(graph, root, mark, ++stamp, order);
    for (std::size_t i = first; i < order.size(); ++i) done[static_cast<std::size_t>(order[i])] = 1;
  }
  std::reverse(order.begin(), order.end());
  return order;
}

}  // namespace muelle::engine
