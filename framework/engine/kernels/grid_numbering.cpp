#include "engine/kernels/grid_numbering.h"

#include "engine/kernels/lattice.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace muelle::engine::kernels {

namespace {

std::vector<SpringData> between(std::span<const SpringData> springs, const std::vector<int>& place) {
  std::vector<SpringData> moved(springs.begin(), springs.end());
  for (SpringData& s : moved) {
    s.a = place[static_cast<std::size_t>(s.a)];
    s.b = place[static_cast<std::size_t>(s.b)];
  }
  return moved;
}

/// The at most two neighbours of each node, -1 for none; empty where a node has more.
std::vector<std::array<int, 2>> chainNeighbours(std::size_t nodes, std::span<const SpringData> springs) {
  std::vector<std::array<int, 2>> neighbours(nodes, {-1, -1});
  const auto join = [&](int node, int other) {
    std::array<int, 2>& own = neighbours[static_cast<std::size_t>(node)];
    if (own[0] == other || own[1] == other) return true;
    int* const free = own[0] < 0 ? &own[0] : own[1] < 0 ? &own[1] : nullptr;
    if (free) *free = other;
    return free != nullptr;
  };
  for (const SpringData& s : springs) {
    if (s.a != s.b && !(join(s.a, s.b) && join(s.b, s.a))) return {};
  }
  return neighbours;
}

/// Places along chains, from the end with the smaller number; then rings, from their smallest number.
std::vector<int> placesAlongChains(const std::vector<std::array<int, 2>>& neighbours) {
  std::vector<int> place(neighbours.size(), -1);
  int next = 0;
  const auto walk = [&](int node) {
    while (node >= 0 && place[static_cast<std::size_t>(node)] < 0) {
      place[static_cast<std::size_t>(node)] = next++;
      const std::array<int, 2>& own = neighbours[static_cast<std::size_t>(node)];
      const bool firstIsNew = own[0] >= 0 && place[static_cast<std::size_t>(own[0])] < 0;
      node = firstIsNew ? own[0] : own[1];
    }
  };
  for (std::size_t i = 0; i < neighbours.size(); ++i) {
    if (neighbours[i][1] < 0) walk(static_cast<int>(i));
  }
  for (std::size_t i = 0; i < neighbours.size(); ++i) walk(static_cast<int>(i));
  return place;
}

}  // namespace

GridNumbering findGrid(int dimension, std::span<const double> x, std::span<const SpringData> springs,
                       double sameMaterial) {
  const std::size_t nodes = x.size() / static_cast<std::size_t>(dimension);
  GridNumbering found;
  found.place.resize(nodes);
  std::iota(found.place.begin(), found.place.end(), 0);
  found.places = nodes;
  found.search = findRuns(dimension, nodes, springs, sameMaterial);
  if (found.search.isGrid()) {
    found.order = GridOrder::AsGiven;
    return found;
  }
  const auto tryPlaces = [&](GridOrder order, std::vector<int> place, std::size_t places) {
    if (place.empty()) return false;
    GridSearch search = findRuns(dimension, places, between(springs, place), sameMaterial);
    if (!search.isGrid()) return false;
    found = {order, std::move(place), places, std::move(search)};
    return true;
  };
  if (tryPlaces(GridOrder::AlongChains, placesAlongChains(chainNeighbours(nodes, springs)), nodes)) return found;
  LatticePlaces lattice = placesOnLattice(dimension, x, springs);
  tryPlaces(GridOrder::Lattice, std::move(lattice.place), lattice.places);
  return found;
}

}  // namespace muelle::engine::kernels
