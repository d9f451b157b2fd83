/// \file
/// What the usual mistakes would return: each is a whole function, so that all calls must agree with it.

#include "mesh_to_springs.h"

#include "grader/testing/arguments.h"
#include "grader/testing/mistakes.h"

#include <map>
#include <numeric>
#include <set>

namespace {

using Edges = std::vector<Edge>;

std::size_t place(int i) { return static_cast<std::size_t>(i); }
Edge ordered(int i, int j) { return {std::min(i, j), std::max(i, j)}; }
Edges sorted(Edges edges) {
  std::ranges::sort(edges);
  return edges;
}
/// Of equal ones that stand next to each other the first.
Edges withoutRepeats(Edges edges) {
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}
Edges each(const std::set<Edge>& edges) { return {edges.begin(), edges.end()}; }

/// Every side of every triangle, as it stands there: (a, b), (b, c), (c, a) of one after the other.
Edges sidesOf(const std::vector<Triangle>& triangles) {
  Edges sides;
  for (const auto& [a, b, c] : triangles) {
    for (const Edge& side : {Edge{a, b}, Edge{b, c}, Edge{c, a}}) sides.push_back(side);
  }
  return sides;
}

Edges orderedSides(const std::vector<Triangle>& triangles) {
  Edges sides = sidesOf(triangles);
  for (Edge& side : sides) side = ordered(side[0], side[1]);
  return sides;
}

/// The first of each, in the order in which they come.
Edges firstOfEach(const Edges& edges) {
  std::set<Edge> seen;
  Edges kept;
  for (const Edge& edge : edges) {
    if (seen.insert(ordered(edge[0], edge[1])).second) kept.push_back(edge);
  }
  return kept;
}

/// Of the edges those that so many triangles have.
Edges sharedBy(const std::vector<Triangle>& triangles, int least, int most) {
  std::map<Edge, int> times;
  for (const Edge& side : orderedSides(triangles)) ++times[side];
  Edges kept;
  for (const auto& [edge, count] : times) {
    if (least <= count && count <= most) kept.push_back(edge);
  }
  return kept;
}

/// By one number an edge, a times the base and b: nodes of a larger number than the base come back as others.
Edges byKeys(const std::vector<Triangle>& triangles, int base) {
  std::set<int> keys;
  for (const Edge& side : orderedSides(triangles)) keys.insert(base * side[0] + side[1]);
  Edges edges;
  for (const int key : keys) edges.push_back({key / base, key % base});
  return edges;
}

}  // namespace

// --- meshEdges ------------------------------------------------------------------------------------------------------

using MeshOf = const std::vector<Triangle>&;

MUELLE_MISTAKE(meshEdges, shared_edges_twice, [](MeshOf triangles) { return sorted(orderedSides(triangles)); });
namespace in_order_of_triangles {
MUELLE_MISTAKE(meshEdges, shared_edges_twice, [](MeshOf triangles) { return orderedSides(triangles); });
}
namespace as_they_stand {
MUELLE_MISTAKE(meshEdges, shared_edges_twice, [](MeshOf triangles) { return sidesOf(triangles); });
}
/// What lies behind the end that std::unique returns is left there.
MUELLE_MISTAKE(meshEdges, not_erased, [](MeshOf triangles) {
  Edges sides = sorted(orderedSides(triangles));
  (void)std::unique(sides.begin(), sides.end());
  return sides;
});
MUELLE_MISTAKE(meshEdges, both_ways_round, [](MeshOf triangles) {
  const Edges sides = sidesOf(triangles);
  return each({sides.begin(), sides.end()});
});
namespace first_seen {
MUELLE_MISTAKE(meshEdges, both_ways_round, [](MeshOf triangles) {
  std::set<Edge> seen;
  Edges kept;
  for (const Edge& side : sidesOf(triangles)) {
    if (seen.insert(side).second) kept.push_back(side);
  }
  return kept;
});
}
/// Repeats are taken out before the smaller node goes first.
namespace compared_too_early {
MUELLE_MISTAKE(meshEdges, both_ways_round, [](MeshOf triangles) {
  const Edges sides = sidesOf(triangles);
  Edges kept;
  for (const auto& [a, b] : std::set<Edge>(sides.begin(), sides.end())) kept.push_back(ordered(a, b));
  return sorted(kept);
});
}
MUELLE_MISTAKE(meshEdges, closing_edge_missing, [](MeshOf triangles) {
  std::set<Edge> edges;
  for (const auto& [a, b, c] : triangles) edges.insert({ordered(a, b), ordered(b, c)});
  return each(edges);
});
MUELLE_MISTAKE(meshEdges, trusts_the_neighbour, [](MeshOf triangles) {
  std::set<Edge> edges;
  for (const Edge& side : sidesOf(triangles)) {
    if (side[0] < side[1]) edges.insert(side);
  }
  return each(edges);
});
MUELLE_MISTAKE(meshEdges, border_only, [](MeshOf triangles) { return sharedBy(triangles, 1, 1); });
/// Met again, an edge is taken out: what two triangles share is gone, what three share is there again.
namespace taken_out_again {
MUELLE_MISTAKE(meshEdges, border_only, [](MeshOf triangles) {
  std::set<Edge> found;
  for (const Edge& side : orderedSides(triangles)) {
    if (!found.insert(side).second) found.erase(side);
  }
  return each(found);
});
}
MUELLE_MISTAKE(meshEdges, pairs_only, [](MeshOf triangles) {
  const Edges sides = sorted(orderedSides(triangles));
  Edges kept;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    kept.push_back(sides[i]);
    if (i + 1 < sides.size() && sides[i + 1] == sides[i]) ++i;
  }
  return kept;
});
MUELLE_MISTAKE(meshEdges, keys_too_small, [](MeshOf triangles) { return byKeys(triangles, 1000); });
namespace of_a_hundred {
MUELLE_MISTAKE(meshEdges, keys_too_small, [](MeshOf triangles) { return byKeys(triangles, 100); });
}
MUELLE_MISTAKE(meshEdges, inside_only, [](MeshOf triangles) { return sharedBy(triangles, 2, 1 << 20); });
MUELLE_MISTAKE(meshEdges, not_sorted, [](MeshOf triangles) { return firstOfEach(orderedSides(triangles)); });
namespace by_second_node {
MUELLE_MISTAKE(meshEdges, not_sorted, [](MeshOf triangles) {
  Edges edges = oracle::meshEdges(triangles);
  std::ranges::sort(edges, {}, [](const Edge& e) { return Edge{e[1], e[0]}; });
  return edges;
});
}
namespace by_first_node_only {
MUELLE_MISTAKE(meshEdges, not_sorted, [](MeshOf triangles) {
  Edges edges = firstOfEach(orderedSides(triangles));
  std::ranges::stable_sort(edges, {}, [](const Edge& e) { return e[0]; });
  return edges;
});
}
namespace descending {
MUELLE_MISTAKE(meshEdges, not_sorted, [](MeshOf triangles) {
  Edges edges = oracle::meshEdges(triangles);
  std::ranges::reverse(edges);
  return edges;
});
}
MUELLE_MISTAKE(meshEdges, larger_node_first, [](MeshOf triangles) { return sorted(firstOfEach(sidesOf(triangles))); });
namespace as_found {
MUELLE_MISTAKE(meshEdges, larger_node_first, [](MeshOf triangles) { return firstOfEach(sidesOf(triangles)); });
}
namespace always {
MUELLE_MISTAKE(meshEdges, larger_node_first, [](MeshOf triangles) {
  Edges edges = oracle::meshEdges(triangles);
  for (Edge& edge : edges) std::swap(edge[0], edge[1]);
  return sorted(edges);
});
}
MUELLE_MISTAKE(meshEdges, node_0_left_out, [](MeshOf triangles) {
  Edges edges = oracle::meshEdges(triangles);
  std::erase_if(edges, [](const Edge& edge) { return edge[0] == 0; });
  return edges;
});
MUELLE_MISTAKE(meshEdges, all_pairs, [](MeshOf triangles) {
  std::set<int> nodes;
  for (const Triangle& t : triangles) nodes.insert(t.begin(), t.end());
  Edges pairs;
  if (nodes.size() > 500) return pairs;  // millions: nobody's answer arrives
  for (const int i : nodes) {
    for (const int j : nodes) {
      if (i < j) pairs.push_back({i, j});
    }
  }
  return pairs;
});
MUELLE_MISTAKE(meshEdges, neighbours_in_list_only,
               [](MeshOf triangles) { return withoutRepeats(orderedSides(triangles)); });
namespace sorted_too_late {
MUELLE_MISTAKE(meshEdges, neighbours_in_list_only,
               [](MeshOf triangles) { return sorted(withoutRepeats(orderedSides(triangles))); });
}

// --- grids ----------------------------------------------------------------------------------------------------------

namespace {

/// A kind of springs as steps of so many rows down and columns to the right.
using Steps = std::vector<std::pair<int, int>>;

/// From each node by each step, as far as the grid goes.
Edges springsOf(int rows, int columns, const Steps& steps) {
  std::set<Edge> edges;
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < columns; ++j) {
      for (const auto& [down, right] : steps) {
        const int row = i + down, column = j + right;
        if (row >= rows || column < 0 || column >= columns) continue;
        edges.insert(ordered(i * columns + j, row * columns + column));
      }
    }
  }
  return each(edges);
}

/// The same by numbers alone: what leaves a row at its end comes in again in the next one.
Edges wrapped(int rows, int columns, const Steps& steps) {
  std::set<Edge> edges;
  for (int from = 0; from < rows * columns; ++from) {
    for (const auto& [down, right] : steps) {
      const int to = from + down * columns + right;
      if (to < rows * columns && to != from) edges.insert(ordered(from, to));
    }
  }
  return each(edges);
}

/// Node numbers as if they went down the columns first.
Edges byColumns(int rows, int columns, const Edges& right) {
  Edges edges;
  for (const Edge& edge : right) {
    const auto number = [&](int node) { return node / columns + node % columns * rows; };
    edges.push_back(ordered(number(edge[0]), number(edge[1])));
  }
  return sorted(edges);
}

/// Row i, column j has the number i * rows + j.
Edges rowsForColumns(int rows, int columns, const Edges& right) {
  Edges edges;
  for (const Edge& edge : right) {
    const auto number = [&](int node) { return node / columns * rows + node % columns; };
    edges.push_back(ordered(number(edge[0]), number(edge[1])));
  }
  return sorted(edges);
}

/// Nothing for a single row or column.
Edges ofRealGrids(int rows, int columns, const Edges& right) { return rows < 2 || columns < 2 ? Edges() : right; }

Edges oneAfterTheOther(Edges first, const Edges& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

Edges eachFromBothEnds(const Edges& right) {
  Edges edges = right;
  for (const Edge& edge : right) edges.push_back({edge[1], edge[0]});
  return sorted(edges);
}

const Steps along = {{0, 1}}, down = {{1, 0}}, structural = {{0, 1}, {1, 0}}, shear = {{1, 1}, {1, -1}},
            bending = {{0, 2}, {2, 0}};

/// Each node with the next one, in whatever row that is, and with the one below.
Edges onInTheNextRow(int rows, int columns) {
  Edges edges;
  for (int node = 0; node + 1 < rows * columns; ++node) {
    edges.push_back({node, node + 1});
    if (node + columns < rows * columns) edges.push_back({node, node + columns});
  }
  return edges;
}

/// Only from the nodes that have a neighbour both to the right and below.
Edges fromInnerOnly(int rows, int columns, int reach) {
  std::set<Edge> edges;
  for (int i = 0; i + reach < rows; ++i) {
    for (int j = 0; j + reach < columns; ++j) {
      edges.insert({i * columns + j, i * columns + j + reach});
      edges.insert({i * columns + j, (i + reach) * columns + j});
    }
  }
  return each(edges);
}

}  // namespace

#define GRID_MISTAKE(function, id, ...) \
  MUELLE_MISTAKE(function, id, []([[maybe_unused]] int rows, [[maybe_unused]] int columns) { return __VA_ARGS__; })
#define NUMBERING_MISTAKES(function)                                                                        \
  GRID_MISTAKE(function, numbered_by_columns, byColumns(rows, columns, oracle::function(rows, columns)));   \
  GRID_MISTAKE(function, rows_for_columns, rowsForColumns(rows, columns, oracle::function(rows, columns))); \
  GRID_MISTAKE(function, each_from_both_ends, eachFromBothEnds(oracle::function(rows, columns)))

#define REPEATS_TAKEN_OUT(function)        \
  GRID_MISTAKE(function, rows_for_columns, \
               withoutRepeats(rowsForColumns(rows, columns, oracle::function(rows, columns))))

NUMBERING_MISTAKES(structuralSprings);
NUMBERING_MISTAKES(shearSprings);
NUMBERING_MISTAKES(bendingSprings);

namespace without_repeats {
REPEATS_TAKEN_OUT(structuralSprings);
REPEATS_TAKEN_OUT(shearSprings);
REPEATS_TAKEN_OUT(bendingSprings);
}  // namespace without_repeats

GRID_MISTAKE(structuralSprings, no_chain, ofRealGrids(rows, columns, oracle::structuralSprings(rows, columns)));
GRID_MISTAKE(bendingSprings, no_chain, ofRealGrids(rows, columns, oracle::bendingSprings(rows, columns)));
GRID_MISTAKE(structuralSprings, in_rows_only, springsOf(rows, columns, along));
GRID_MISTAKE(structuralSprings, in_columns_only, springsOf(rows, columns, down));
GRID_MISTAKE(structuralSprings, round_the_end, wrapped(rows, columns, structural));
namespace to_the_next_row {
GRID_MISTAKE(structuralSprings, round_the_end, onInTheNextRow(rows, columns));
namespace without_repeats {
GRID_MISTAKE(structuralSprings, round_the_end, withoutRepeats(onInTheNextRow(rows, columns)));
}
}  // namespace to_the_next_row
GRID_MISTAKE(structuralSprings, last_row_and_column, fromInnerOnly(rows, columns, 1));
GRID_MISTAKE(structuralSprings, not_sorted,
             oneAfterTheOther(springsOf(rows, columns, along), springsOf(rows, columns, down)));
namespace columns_first {
GRID_MISTAKE(structuralSprings, not_sorted,
             oneAfterTheOther(springsOf(rows, columns, down), springsOf(rows, columns, along)));
}
GRID_MISTAKE(structuralSprings, diagonals_too, springsOf(rows, columns, {{0, 1}, {1, 0}, {1, 1}, {1, -1}}));

GRID_MISTAKE(shearSprings, one_diagonal, springsOf(rows, columns, {{1, 1}}));
namespace other_diagonal {
GRID_MISTAKE(shearSprings, one_diagonal, springsOf(rows, columns, {{1, -1}}));
}
GRID_MISTAKE(shearSprings, round_the_end, wrapped(rows, columns, shear));
namespace {
/// At the left border the column before the first is taken for the last of the row above.
Edges backIntoTheRow(int rows, int columns) {
  Edges edges = springsOf(rows, columns, shear);
  for (int i = 0; i + 1 < rows; ++i) edges.push_back({i * columns, (i + 1) * columns - 1});
  return sorted(edges);
}
}  // namespace
namespace at_the_left_border {
GRID_MISTAKE(shearSprings, round_the_end, backIntoTheRow(rows, columns));
}
GRID_MISTAKE(shearSprings, structural_too, springsOf(rows, columns, {{0, 1}, {1, 0}, {1, 1}, {1, -1}}));
GRID_MISTAKE(shearSprings, not_sorted,
             oneAfterTheOther(springsOf(rows, columns, {{1, 1}}), springsOf(rows, columns, {{1, -1}})));

namespace {
/// The diagonal that goes to the left starts at the node below.
Edges upwards(int rows, int columns) {
  Edges edges = springsOf(rows, columns, {{1, 1}});
  for (const Edge& edge : springsOf(rows, columns, {{1, -1}})) edges.push_back({edge[1], edge[0]});
  return sorted(edges);
}
}  // namespace
GRID_MISTAKE(shearSprings, larger_node_first, upwards(rows, columns));

GRID_MISTAKE(bendingSprings, in_rows_only, springsOf(rows, columns, {{0, 2}}));
GRID_MISTAKE(bendingSprings, in_columns_only, springsOf(rows, columns, {{2, 0}}));
GRID_MISTAKE(bendingSprings, round_the_end, wrapped(rows, columns, bending));
GRID_MISTAKE(bendingSprings, last_row_and_column, fromInnerOnly(rows, columns, 2));
GRID_MISTAKE(bendingSprings, diagonals_too, springsOf(rows, columns, {{0, 2}, {2, 0}, {2, 2}, {2, -2}}));
GRID_MISTAKE(bendingSprings, next_neighbour, springsOf(rows, columns, structural));
GRID_MISTAKE(bendingSprings, structural_too, springsOf(rows, columns, {{0, 1}, {1, 0}, {0, 2}, {2, 0}}));
GRID_MISTAKE(bendingSprings, not_sorted,
             oneAfterTheOther(springsOf(rows, columns, {{0, 2}}), springsOf(rows, columns, {{2, 0}})));

// --- restLengths ----------------------------------------------------------------------------------------------------

namespace {

template <class Length>
std::vector<double> lengthsBy(const std::vector<Vec3>& nodes, const Edges& edges, const Length& length) {
  std::vector<double> lengths;
  for (const auto& [a, b] : edges) lengths.push_back(length(nodes.at(place(a)), nodes.at(place(b))));
  return lengths;
}

}  // namespace

#define LENGTH_MISTAKE(id, ...)                                                            \
  MUELLE_MISTAKE(restLengths, id, [](const std::vector<Vec3>& nodes, const Edges& edges) { \
    return lengthsBy(nodes, edges, __VA_ARGS__);                                           \
  })

LENGTH_MISTAKE(squared_length, [](const Vec3& a, const Vec3& b) { return (a - b).squaredNorm(); });
LENGTH_MISTAKE(seen_from_above, [](const Vec3& a, const Vec3& b) { return (a - b).head<2>().norm(); });
LENGTH_MISTAKE(length_of_components, [](const Vec3& a, const Vec3& b) { return (a - b).lpNorm<1>(); });
LENGTH_MISTAKE(difference_of_norms, [](const Vec3& a, const Vec3& b) { return std::abs(a.norm() - b.norm()); });
LENGTH_MISTAKE(whole_numbers, [](const Vec3& a, const Vec3& b) { return std::trunc((a - b).norm()); });
/// A sum of squares in an int is cut at each of its terms.
namespace summed {
LENGTH_MISTAKE(whole_numbers, [](const Vec3& a, const Vec3& b) {
  double sum = 0.0;
  for (const double d : Vec3(a - b)) sum = std::trunc(sum + d * d);
  return std::sqrt(sum);
});
}
MUELLE_MISTAKE(restLengths, mean_length, [](const std::vector<Vec3>& nodes, const Edges& edges) {
  const std::vector<double> right = oracle::restLengths(nodes, edges);
  const double sum = std::accumulate(right.begin(), right.end(), 0.0);
  return std::vector<double>(right.size(), sum / static_cast<double>(right.size()));
});
MUELLE_MISTAKE(restLengths, first_for_all_springs, [](const std::vector<Vec3>& nodes, const Edges& edges) {
  std::vector<double> right = oracle::restLengths(nodes, edges);
  if (!right.empty()) std::ranges::fill(right, double(right.front()));
  return right;
});
MUELLE_MISTAKE(restLengths, edges_ignored, [](const std::vector<Vec3>& nodes, const Edges&) {
  std::vector<double> lengths;
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) lengths.push_back((nodes[i] - nodes[i + 1]).norm());
  return lengths;
});

// --- masses ---------------------------------------------------------------------------------------------------------

namespace {

/// Each triangle gives each of its nodes what `share` says of corner 0, 1, 2.
template <class Share>
std::vector<double> lumped(const std::vector<Vec3>& nodes, const std::vector<Triangle>& triangles, double density,
                           const Share& share) {
  std::vector<double> masses(nodes.size());
  for (const Triangle& t : triangles) {
    const Vec3 u = nodes.at(place(t[1])) - nodes.at(place(t[0])), v = nodes.at(place(t[2])) - nodes.at(place(t[0]));
    for (std::size_t corner = 0; corner < 3; ++corner)
      share(masses[place(t[corner])], density * 0.5 * u.cross(v).norm(), corner);
  }
  return masses;
}

using NodesOf = const std::vector<Vec3>&;

double sumOf(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

}  // namespace

MUELLE_MISTAKE(equalMasses, whole_mass_each, [](double M, int n) { return std::vector<double>(place(n), M); });
MUELLE_MISTAKE(equalMasses, one_node_too_few,
               [](double M, int n) { return std::vector<double>(place(n), M / (n - 1)); });
MUELLE_MISTAKE(equalMasses, one_node_too_many,
               [](double M, int n) { return std::vector<double>(place(n), M / (n + 1)); });
MUELLE_MISTAKE(equalMasses, whole_numbers,
               [](double M, int n) { return std::vector<double>(place(n), std::trunc(M) / n); });
namespace cut_quotient {
MUELLE_MISTAKE(equalMasses, whole_numbers,
               [](double M, int n) { return std::vector<double>(place(n), std::trunc(std::trunc(M) / n)); });
}

#define AREA_MISTAKE(id, ...)                                                                     \
  MUELLE_MISTAKE(massesByArea, id, [](NodesOf nodes, MeshOf triangles, double density) {          \
    return lumped(nodes, triangles, density, [](double& mass, double whole, std::size_t corner) { \
      (void)corner;                                                                               \
      __VA_ARGS__;                                                                                \
    });                                                                                           \
  })

AREA_MISTAKE(whole_triangle_each, mass += whole);
AREA_MISTAKE(missing_half, mass += 2 * whole / 3);
AREA_MISTAKE(overwrites, mass = whole / 3);
AREA_MISTAKE(first_node_only, if (corner == 0) mass += whole);
namespace a_third_of_it {
AREA_MISTAKE(first_node_only, if (corner == 0) mass += whole / 3);
}
MUELLE_MISTAKE(massesByArea, shared_alike, [](NodesOf nodes, MeshOf triangles, double density) {
  const double sum = sumOf(oracle::massesByArea(nodes, triangles, density));
  return std::vector<double>(nodes.size(), sum / static_cast<double>(nodes.size()));
});
MUELLE_MISTAKE(massesByArea, mean_of_triangles, [](NodesOf nodes, MeshOf triangles, double density) {
  std::vector<double> masses =
      lumped(nodes, triangles, density, [](double& mass, double whole, std::size_t) { mass += whole; });
  std::vector<int> count(nodes.size());
  for (const Triangle& t : triangles) {
    for (const int i : t) ++count[place(i)];
  }
  for (std::size_t i = 0; i < masses.size(); ++i) masses[i] /= std::max(count[i], 1);
  return masses;
});
namespace a_third_of_the_mean {
MUELLE_MISTAKE(massesByArea, mean_of_triangles, [](NodesOf nodes, MeshOf triangles, double density) {
  std::vector<double> masses = oracle::massesByArea(nodes, triangles, density);
  std::vector<int> count(nodes.size());
  for (const Triangle& t : triangles) {
    for (const int i : t) ++count[place(i)];
  }
  for (std::size_t i = 0; i < masses.size(); ++i) masses[i] /= std::max(count[i], 1);
  return masses;
});
}
MUELLE_MISTAKE(massesByArea, seen_from_above, [](NodesOf nodes, MeshOf triangles, double density) {
  std::vector<double> masses(nodes.size());
  for (const auto& [a, b, c] : triangles) {
    const Vec3 u = nodes.at(place(b)) - nodes.at(place(a)), v = nodes.at(place(c)) - nodes.at(place(a));
    for (const int i : {a, b, c}) masses[place(i)] += density * std::abs(u[0] * v[1] - u[1] * v[0]) / 6;
  }
  return masses;
});
MUELLE_MISTAKE(massesByArea, right_angles, [](NodesOf nodes, MeshOf triangles, double density) {
  std::vector<double> masses(nodes.size());
  for (const auto& [a, b, c] : triangles) {
    const Vec3 u = nodes.at(place(b)) - nodes.at(place(a)), v = nodes.at(place(c)) - nodes.at(place(a));
    for (const int i : {a, b, c}) masses[place(i)] += density * u.norm() * v.norm() / 6;
  }
  return masses;
});

// --- general position
// -------------------------------------------------------------------------------------------------

namespace {

using muelle::Random;
using muelle::threeDigits;

constexpr int someNodes = 8;

/// Three different nodes of so many.
Triangle someTriangle(Random& random, int nodes) {
  const int a = random.integer(0, nodes - 1);
  const int b = (a + random.integer(1, nodes - 2)) % nodes;
  int c = (b + 1) % nodes;
  while (c == a) c = (c + 1) % nodes;
  return {a, b, c};
}

std::vector<Triangle> someTriangles(Random& random, int nodes) {
  std::vector<Triangle> triangles;
  for (int i = 0; i < 6; ++i) triangles.push_back(someTriangle(random, nodes));
  return triangles;
}

std::vector<Vec3> somePlaces(Random& random) {
  std::vector<Vec3> nodes;
  for (int i = 0; i < someNodes; ++i) nodes.push_back(threeDigits(random.vector3(1.0)));
  return nodes;
}

}  // namespace

MUELLE_ARGUMENTS(meshEdges, [](Random& random) {
  const std::vector<Triangle> triangles = someTriangles(random, 40);
  return std::tuple(triangles);
});
MUELLE_ARGUMENTS(structuralSprings, [](Random& random) {
  const int rows = random.integer(3, 9), columns = random.integer(3, 9);
  return std::tuple(rows, columns);
});
MUELLE_ARGUMENTS(shearSprings, [](Random& random) {
  const int rows = random.integer(3, 9), columns = random.integer(3, 9);
  return std::tuple(rows, columns);
});
MUELLE_ARGUMENTS(bendingSprings, [](Random& random) {
  const int rows = random.integer(3, 9), columns = random.integer(3, 9);
  return std::tuple(rows, columns);
});
MUELLE_ARGUMENTS(restLengths, [](Random& random) {
  const std::vector<Vec3> nodes = somePlaces(random);
  Edges edges;
  for (const auto& [a, b, c] : someTriangles(random, someNodes)) edges.push_back(ordered(a, b));
  return std::tuple(nodes, edges);
});
MUELLE_ARGUMENTS(massesByArea, [](Random& random) {
  const std::vector<Vec3> nodes = somePlaces(random);
  const std::vector<Triangle> triangles = someTriangles(random, someNodes);
  const double density = threeDigits(random.positive(0.2, 5.0));
  return std::tuple(nodes, triangles, density);
});
