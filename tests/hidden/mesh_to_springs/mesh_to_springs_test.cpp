#include "mesh_to_springs.h"

#include "course/testing/expect.h"
#include "course/testing/random.h"
#include "engine/scene/surface_mesh.h"
#include "grader/testing/of_use.h"
#include "grader/testing/plain_numbers.h"
#include "harness/triangle_mesh.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

using muelle::Mat3;
using muelle::Random;
using muelle::testRandom;
using muelle::threeDigits;
using muelle::TriangleMesh;
using muelle::VecX;
using muelle::grader::someTurn;
using muelle::grader::tidy;

namespace {

using Edges = std::vector<Edge>;
using Triangles = std::vector<Triangle>;

/// A tolerance for values: a length is some ten roundings of 1.1e-16 of its size, a mass those of its triangles, by any
/// formula for the area of a triangle that is not thin; single precision is off by 6e-8.
double inRounding(double scale) { return 1e-13 * scale; }

/// A tolerance for laws, which are about structure and not about digits.
double inStructure(double scale) { return 1e-6 * scale; }

std::size_t place(int i) { return static_cast<std::size_t>(i); }

// --- meshes ---------------------------------------------------------------------------------------------------------

const Triangles tetrahedron = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
const Triangles octahedron = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
const Triangles cube = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                        {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};

/// Two triangles a cell, all the same way round, each diagonal one way or the other.
Triangles sheet(int rows, int columns, Random& random) {
  Triangles triangles;
  for (int i = 0; i + 1 < rows; ++i) {
    for (int j = 0; j + 1 < columns; ++j) {
      const int a = i * columns + j, b = a + 1, c = a + columns, d = c + 1;
      const bool isFalling = random.integer(0, 1) == 0;
      triangles.push_back(isFalling ? Triangle{a, c, d} : Triangle{a, c, b});
      triangles.push_back(isFalling ? Triangle{a, d, b} : Triangle{b, c, d});
    }
  }
  return triangles;
}

/// A closed tyre of rows times columns nodes.
Triangles torus(int rows, int columns) {
  Triangles triangles;
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < columns; ++j) {
      const int down = (i + 1) % rows * columns, row = i * columns, right = (j + 1) % columns;
      triangles.push_back({row + j, down + j, down + right});
      triangles.push_back({row + j, down + right, row + right});
    }
  }
  return triangles;
}

/// A closed double cone over a polygon.
Triangles spindle(int corners) {
  Triangles triangles;
  for (int i = 0; i < corners; ++i) {
    const int next = (i + 1) % corners;
    triangles.push_back({i, next, corners});
    triangles.push_back({next, i, corners + 1});
  }
  return triangles;
}

const TriangleMesh& rabbit() {
  static const TriangleMesh mesh = muelle::readTriangleMesh(MUELLE_EXERCISE_FOLDER "/rabbit.off");
  return mesh;
}

int nodesOf(const Triangles& triangles) {
  int most = -1;
  for (const Triangle& t : triangles) most = std::max({most, t[0], t[1], t[2]});
  return most + 1;
}

template <class T>
void shuffle(std::vector<T>& list, Random& random) {
  for (int i = static_cast<int>(list.size()) - 1; i > 0; --i)
    std::swap(list[place(i)], list[place(random.integer(0, i))]);
}

/// The same surface: its nodes have other numbers, up to `numbers` less one, no triangle begins where it did, and they
/// come in another order; all go the same way round as before.
Triangles renumbered(Triangles triangles, int numbers, Random& random) {
  std::vector<int> names(place(numbers));
  std::iota(names.begin(), names.end(), 0);
  shuffle(names, random);
  for (Triangle& t : triangles) {
    for (int& i : t) i = names[place(i)];
    std::rotate(t.begin(), t.begin() + random.integer(0, 2), t.end());
  }
  shuffle(triangles, random);
  return triangles;
}

/// One triangle in two turned over, so that neighbours go along their edge the same way.
Triangles turnedOver(Triangles triangles, Random& random) {
  for (Triangle& t : triangles) {
    if (random.integer(0, 1) == 0) std::swap(t[1], t[2]);
  }
  return triangles;
}

// --- edges as sets ---------------------------------------------------------------------------------------------------

/// The same edges in order: their order, and which end comes first, is a criterion of its own.
Edges inOrder(Edges edges) {
  for (Edge& edge : edges) std::ranges::sort(edge);
  std::ranges::sort(edges);
  return edges;
}

std::string nameOf(const Edge& edge) { return fmt::format("{}-{}", edge[0], edge[1]); }

/// The first of two edges that are the same in a list that is in order; nullopt where each is there once.
std::optional<Edge> twice(const Edges& edges) {
  const auto found = std::ranges::adjacent_find(edges);
  return found == edges.end() ? std::nullopt : std::optional(*found);
}

/// "12 edges", "1 edge"
std::string counted(std::size_t count, const std::string& thing) {
  return fmt::format("{} {}{}", count, thing, count == 1 ? "" : "s");
}

/// "the edge 2-3 is missing": the first difference of two lists, whatever their order. \param what "edge", "spring"
std::string difference(const Edges& got, const Edges& expected, const std::string& what) {
  const Edges own = inOrder(got);
  for (const Edge& edge : expected) {
    if (!std::ranges::binary_search(own, edge)) {
      return fmt::format("the {} {} is missing: you give {}, there are {}", what, nameOf(edge),
                         counted(own.size(), what), expected.size());
    }
  }
  for (const Edge& edge : own) {
    if (!std::ranges::binary_search(expected, edge)) return fmt::format("there is no {} {}", what, nameOf(edge));
  }
  if (const auto edge = twice(own)) return fmt::format("the {} {} is there more than once", what, nameOf(*edge));
  return "";
}

::testing::AssertionResult says(const std::string& complaint) {
  return complaint.empty() ? ::testing::AssertionSuccess() : ::testing::AssertionFailure() << complaint;
}

::testing::AssertionResult hasEdges(const char*, const char*, const char*, const Edges& got, const Edges& expected,
                                    const std::string& what) {
  return says(difference(got, expected, what));
}
#define EXPECT_EDGES(got, expected) EXPECT_PRED_FORMAT3(hasEdges, got, expected, std::string("edge"))
#define EXPECT_SPRINGS(got, expected) EXPECT_PRED_FORMAT3(hasEdges, got, expected, std::string("spring"))

::testing::AssertionResult isOnceEach(const char*, const Edges& got) {
  const auto edge = twice(inOrder(got));
  return says(edge ? fmt::format("the edge {} is there more than once", nameOf(*edge)) : "");
}

::testing::AssertionResult areSame(const char*, const char*, const char*, const Edges& got, const Edges& before,
                                   const std::string& change) {
  const Edges a = inOrder(before), b = inOrder(got);
  if (a == b) return ::testing::AssertionSuccess();
  Edges lost, come;
  std::ranges::set_difference(a, b, std::back_inserter(lost));
  std::ranges::set_difference(b, a, std::back_inserter(come));
  const bool isLost = !lost.empty();
  return ::testing::AssertionFailure() << fmt::format("when {}, your list {} the edge {}", change,
                                                      isLost ? "loses" : "gains",
                                                      nameOf((isLost ? lost : come).front()));
}
#define EXPECT_SAME_EDGES(got, before, change) EXPECT_PRED_FORMAT3(areSame, got, before, std::string(change))

::testing::AssertionResult isInOrder(const char*, const Edges& got) {
  for (std::size_t s = 0; s < got.size(); ++s) {
    const auto& [a, b] = got[s];
    if (a > b) return says(fmt::format("number {} of your list is {}-{}: the larger node is first", s, a, b));
    if (s > 0 && got[s] < got[s - 1]) {
      return says(fmt::format("number {} of your list is {}, after {}", s, nameOf(got[s]), nameOf(got[s - 1])));
    }
  }
  return says("");
}

VecX vectorOf(const std::vector<double>& values) {
  return Eigen::Map<const VecX>(values.data(), static_cast<Eigen::Index>(values.size()));
}

double sumOf(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

}  // namespace

// --- MeshEdges ------------------------------------------------------------------------------------------------------

namespace {

/// Small meshes first: one triangle, two, a fan, a book of three pages on one edge, and surfaces with a border and
/// without, some with all triangles the same way round and some not.
std::vector<Triangles> someMeshes(Random& random) {
  std::vector<Triangles> meshes = {{{0, 1, 2}},
                                   {{5, 2, 9}},
                                   {{0, 1, 2}, {2, 1, 3}},
                                   {{4, 1, 3}, {4, 1, 6}},
                                   {{3, 7, 0}, {3, 7, 1}, {7, 3, 4}},
                                   {{6, 0, 2}, {6, 2, 3}, {6, 3, 5}, {6, 5, 1}},
                                   {{8, 3, 1}, {2, 0, 7}},
                                   tetrahedron};
  for (const auto& [rows, columns] : {std::pair(2, 3), std::pair(3, 3), std::pair(4, 5)}) {
    const Triangles plain = renumbered(sheet(rows, columns, random), rows * columns + 3, random);
    meshes.push_back(plain);
    meshes.push_back(turnedOver(plain, random));
  }
  meshes.push_back(renumbered(octahedron, 6, random));
  meshes.push_back(renumbered(torus(4, 5), 20, random));
  return meshes;
}

}  // namespace

TEST(MeshEdges, AreTheSidesOfTheTriangles) {
  MUELLE_PROPERTY("the edges are the sides of all triangles, and no others");
  Random random = testRandom();
  for (const Triangles& mesh : someMeshes(random)) EXPECT_EDGES(submission::meshEdges(mesh), oracle::meshEdges(mesh));
}

TEST(MeshEdges, OfNoTrianglesAreNone) {
  MUELLE_PROPERTY("no triangles have no edges");
  MUELLE_EXPECT_ANSWERS(meshEdges);
  EXPECT_EDGES(submission::meshEdges({}), {});
}

TEST(MeshEdges, OfManyTriangles) {
  MUELLE_PROPERTY("of large meshes, the rabbit and one of 5000 triangles, each side is there, too");
  Random random = testRandom();
  const Triangles large = renumbered(torus(50, 50), 2500, random);
  EXPECT_EDGES(submission::meshEdges(large), muelle::engine::edgesOf(large));
  EXPECT_EDGES(submission::meshEdges(rabbit().triangles), muelle::engine::edgesOf(rabbit().triangles));
}

// --- EachEdgeOnce: a law of the student's own list, whatever it holds
// -------------------------------------------------

namespace {

/// With one of many nodes.
std::vector<Triangles> smallAndLarge(Random& random) {
  std::vector<Triangles> meshes = someMeshes(random);
  meshes.push_back(renumbered(torus(12, 30), 360, random));
  return meshes;
}

}  // namespace

TEST(EachEdgeOnce, IsThereOnce) {
  MUELLE_PROPERTY("no edge is twice in the list, in one direction or in both");
  MUELLE_EXPECT_OF_USE(meshEdges);
  Random random = testRandom();
  for (const Triangles& mesh : smallAndLarge(random)) EXPECT_PRED_FORMAT1(isOnceEach, submission::meshEdges(mesh));
}

TEST(EachEdgeOnce, WhateverWayRoundTheTrianglesGo) {
  MUELLE_PROPERTY("turning triangles over changes no edge, at the border and inside");
  MUELLE_EXPECT_OF_USE(meshEdges);
  Random random = testRandom();
  for (const Triangles& mesh : smallAndLarge(random)) {
    Triangles all = mesh;
    for (Triangle& t : all) std::swap(t[1], t[2]);
    const Edges before = submission::meshEdges(mesh);
    EXPECT_SAME_EDGES(submission::meshEdges(all), before, "all triangles go the other way round");
    EXPECT_SAME_EDGES(submission::meshEdges(turnedOver(mesh, random)), before, "some triangles go the other way round");
  }
}

TEST(EachEdgeOnce, WhereverTheTrianglesBegin) {
  MUELLE_PROPERTY("neither the corner that a triangle begins with nor the order of the triangles changes an edge");
  MUELLE_EXPECT_OF_USE(meshEdges);
  Random random = testRandom();
  for (const Triangles& mesh : smallAndLarge(random)) {
    const Edges before = submission::meshEdges(mesh);
    Triangles turned = mesh;
    for (Triangle& t : turned) std::rotate(t.begin(), t.begin() + 1, t.end());
    EXPECT_SAME_EDGES(submission::meshEdges(turned), before, "each triangle begins with its next corner");
    Triangles backwards = mesh;
    std::ranges::reverse(backwards);
    EXPECT_SAME_EDGES(submission::meshEdges(backwards), before, "the triangles come in the other order");
  }
}

// --- EulersFormula --------------------------------------------------------------------------------------------------

namespace {

/// V - E + F with the edges of the submission.
void expectEuler(const std::string& name, const Triangles& triangles, int expected) {
  const Edges edges = submission::meshEdges(triangles);
  MUELLE_LABEL(fmt::format("V - E + F of {}, with V = {}, F = {} and E the length of your list", name,
                           nodesOf(triangles), triangles.size()));
  EXPECT_NUMBER_NEAR(nodesOf(triangles) - static_cast<double>(edges.size()) + static_cast<double>(triangles.size()),
                     expected, 0);
}

}  // namespace

TEST(EulersFormula, HoldsForBodiesWithoutHoles) {
  MUELLE_PROPERTY("V - E + F = 2 for a closed surface without a hole through it, as Euler found");
  Random random = testRandom();
  expectEuler("a tetrahedron", renumbered(tetrahedron, 4, random), 2);
  expectEuler("a cube of 12 triangles", renumbered(cube, 8, random), 2);
  expectEuler("an octahedron", renumbered(octahedron, 6, random), 2);
  for (const int corners : {3, 7, 19}) {
    expectEuler(fmt::format("a double cone over {} corners", corners),
                renumbered(spindle(corners), corners + 2, random), 2);
  }
  expectEuler("the rabbit", rabbit().triangles, 2);
}

TEST(EulersFormula, IsZeroWithAHole) {
  MUELLE_PROPERTY("V - E + F = 0 for a tyre, which has one hole through it");
  Random random = testRandom();
  for (const auto& [rows, columns] : {std::pair(3, 3), std::pair(4, 7), std::pair(13, 9)}) {
    expectEuler(fmt::format("a tyre of {} x {} nodes", rows, columns),
                renumbered(torus(rows, columns), rows * columns, random), 0);
  }
}

// --- GridSprings ----------------------------------------------------------------------------------------------------

namespace {

/// Wide ones and high ones, small and large, and those that have no room for a spring.
constexpr std::pair<int, int> grids[] = {{2, 2}, {2, 3},   {3, 2},  {3, 3},  {3, 5},   {5, 3},   {4, 7},  {7, 4},
                                         {1, 1}, {1, 2},   {2, 1},  {1, 3},  {3, 1},   {1, 6},   {6, 1},  {2, 9},
                                         {9, 2}, {11, 10}, {40, 1}, {1, 40}, {40, 40}, {40, 13}, {13, 40}};

}  // namespace

TEST(GridSprings, Structural) {
  MUELLE_PROPERTY("structural springs join neighbours in a row and neighbours in a column, and nothing else");
  MUELLE_EXPECT_ANSWERS(structuralSprings);
  for (const auto& [rows, columns] : grids) {
    EXPECT_SPRINGS(submission::structuralSprings(rows, columns), oracle::structuralSprings(rows, columns));
  }
}

TEST(GridSprings, Shear) {
  MUELLE_PROPERTY("shear springs are both diagonals of each cell, and nothing else");
  MUELLE_EXPECT_ANSWERS(shearSprings);
  for (const auto& [rows, columns] : grids) {
    EXPECT_SPRINGS(submission::shearSprings(rows, columns), oracle::shearSprings(rows, columns));
  }
}

TEST(GridSprings, Bending) {
  MUELLE_PROPERTY(
      "bending springs join each node with the next but one in its row and in its column, and nothing else");
  MUELLE_EXPECT_ANSWERS(bendingSprings);
  for (const auto& [rows, columns] : grids) {
    EXPECT_SPRINGS(submission::bendingSprings(rows, columns), oracle::bendingSprings(rows, columns));
  }
}

// --- SortedEdges: of the student's own lists, whatever they hold ----------------------------------------------------

TEST(SortedEdges, OfTheMesh) {
  MUELLE_PROPERTY("in the edges of a mesh the smaller node comes first, and the list is sorted");
  MUELLE_EXPECT_OF_USE(meshEdges);
  Random random = testRandom();
  for (const Triangles& mesh : someMeshes(random)) EXPECT_PRED_FORMAT1(isInOrder, submission::meshEdges(mesh));
}

#define EXPECT_SORTED(function)   \
  MUELLE_EXPECT_OF_USE(function); \
  for (const auto& [rows, columns] : grids) EXPECT_PRED_FORMAT1(isInOrder, submission::function(rows, columns))

TEST(SortedEdges, OfStructuralSprings) {
  MUELLE_PROPERTY("in structural springs the smaller node comes first, and the list is sorted");
  EXPECT_SORTED(structuralSprings);
}

TEST(SortedEdges, OfShearSprings) {
  MUELLE_PROPERTY("in shear springs the smaller node comes first, and the list is sorted");
  EXPECT_SORTED(shearSprings);
}

TEST(SortedEdges, OfBendingSprings) {
  MUELLE_PROPERTY("in bending springs the smaller node comes first, and the list is sorted");
  EXPECT_SORTED(bendingSprings);
}

// --- RestLengths ----------------------------------------------------------------------------------------------------

namespace {

std::vector<Vec3> someNodes(Random& random, int count, double scale = 1.0) {
  std::vector<Vec3> nodes;
  for (int i = 0; i < count; ++i) nodes.push_back(threeDigits(random.vector3(scale)));
  return nodes;
}

Edges someEdges(Random& random, int count, int nodes) {
  Edges edges;
  for (int i = 0; i < count; ++i) {
    const int a = random.integer(0, nodes - 1), b = (a + random.integer(1, nodes - 1)) % nodes;
    edges.push_back({std::min(a, b), std::max(a, b)});
  }
  return edges;
}

void expectRestLengths(const std::vector<Vec3>& nodes, const Edges& edges) {
  double scale = 0;
  for (const auto& [a, b] : edges) scale = std::max(scale, (nodes[place(a)] - nodes[place(b)]).stableNorm());
  EXPECT_VECTOR_NEAR(vectorOf(submission::restLengths(nodes, edges)), vectorOf(oracle::restLengths(nodes, edges)),
                     inRounding(scale));
}

}  // namespace

TEST(RestLengths, AreTheDistancesOfTheNodes) {
  MUELLE_PROPERTY("the rest length of a spring is the distance of its nodes, in the order of the list");
  Random random = testRandom();
  for (const int count : {1, 2, 3, 7}) expectRestLengths(someNodes(random, 5), someEdges(random, count, 5));
  for (const double scale : {0.01, 10.0, 1000.0}) {
    expectRestLengths(someNodes(random, 9, scale), someEdges(random, 12, 9));
  }
}

TEST(RestLengths, OfAListOfAnyLength) {
  MUELLE_PROPERTY("no edges have no lengths, and 7500 have 7500");
  MUELLE_EXPECT_ANSWERS(restLengths);
  Random random = testRandom();
  expectRestLengths({}, {});
  expectRestLengths(someNodes(random, 4), {});
  expectRestLengths(someNodes(random, 2500), someEdges(random, 7500, 2500));
  expectRestLengths(rabbit().nodes, oracle::meshEdges(rabbit().triangles));
}

TEST(RestLengths, OfShortEdges) {
  MUELLE_PROPERTY("a short edge has its length, and one whose nodes coincide has the length 0");
  // (2, -3, 6) 2^-k is 7 * 2^-k long, exactly, beside any node of few digits.
  for (const Vec3& at : {Vec3(0, 0, 0), Vec3(1.25, -1.75, 1.5), Vec3(-768, 512.5, 640)}) {
    std::vector<Vec3> nodes = {at, at};
    for (const int k : {1, 4, 9, 13, 20, 27}) nodes.push_back(at + std::ldexp(1.0, -k) * Vec3(2, -3, 6));
    // One by one, so that each has a tolerance of its own size.
    for (int i = 1; i < static_cast<int>(nodes.size()); ++i) expectRestLengths(nodes, {{0, i}});
  }
}

// --- EqualMasses ----------------------------------------------------------------------------------------------------

TEST(EqualMasses, AreMOverN) {
  MUELLE_PROPERTY("each of n nodes has the mass M/n");
  Random random = testRandom();
  for (const int n : {1, 2, 3, 7, 40, 2500}) {
    for (const double M : {1e-6, 0.37, threeDigits(random.positive(1.1, 90.0)), 1e6}) {
      EXPECT_VECTOR_NEAR(vectorOf(submission::equalMasses(M, n)), vectorOf(oracle::equalMasses(M, n)),
                         inRounding(M / n));
    }
  }
}

// --- MassesByArea ---------------------------------------------------------------------------------------------------

namespace {

/// A sheet that is bent and somewhere in space, with nodes beside it that are in no triangle.
TriangleMesh bentSheet(Random& random, int rows, int columns) {
  TriangleMesh mesh;
  const Vec3 corner = tidy(random.vector3(2.0));
  const Mat3 turn = someTurn(random.integer(0, 2));
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < columns; ++j) {
      const Vec3 plain(0.31 * i + random.number(0, 0.09), 0.43 * j + random.number(0, 0.12), random.number(0, 0.21));
      mesh.nodes.push_back(tidy(Vec3(corner + turn * plain)));
    }
  }
  for (int i = 0; i < 2; ++i) mesh.nodes.push_back(tidy(random.vector3(2.0)));
  mesh.triangles = turnedOver(sheet(rows, columns, random), random);
  return mesh;
}

std::vector<double> submittedMasses(const TriangleMesh& mesh, double density) {
  return submission::massesByArea(mesh.nodes, mesh.triangles, density);
}

void expectMasses(const TriangleMesh& mesh, double density) {
  const std::vector<double> expected = oracle::massesByArea(mesh.nodes, mesh.triangles, density);
  double squares = 0;  // an area may be made of positions in place of differences
  for (const Vec3& x : mesh.nodes) squares = std::max(squares, x.squaredNorm());
  const double largest = expected.empty() ? 0.0 : *std::ranges::max_element(expected);
  EXPECT_VECTOR_NEAR(vectorOf(submittedMasses(mesh, density)), vectorOf(expected),
                     inRounding(largest + density * squares));
}

/// A tyre of 2500 nodes and 5000 triangles, in space.
TriangleMesh largeTyre() {
  TriangleMesh mesh;
  for (int i = 0; i < 50; ++i) {
    for (int j = 0; j < 50; ++j) {
      const double u = 2 * M_PI * i / 50, v = 2 * M_PI * j / 50, r = 3.1 + 1.3 * std::cos(v);
      mesh.nodes.push_back(tidy(Vec3(r * std::cos(u), r * std::sin(u), 1.3 * std::sin(v)), 1000));
    }
  }
  mesh.triangles = torus(50, 50);
  return mesh;
}

}  // namespace

TEST(MassesByArea, AreThirdsOfTheTriangles) {
  MUELLE_PROPERTY("each node has a third of the mass of each of its triangles");
  Random random = testRandom();
  const TriangleMesh one{{Vec3(0.3, -0.2, 0.7), Vec3(1.1, 0.4, -0.3), Vec3(-0.6, 0.9, 0.2)}, {{0, 1, 2}}};
  expectMasses(one, 1.7);
  for (const auto& [rows, columns] : {std::pair(2, 2), std::pair(2, 3), std::pair(3, 3), std::pair(4, 3)}) {
    expectMasses(bentSheet(random, rows, columns), threeDigits(random.positive(0.2, 5.0)));
  }
}

TEST(MassesByArea, HoldForEveryDensityAndSize) {
  MUELLE_PROPERTY("light and heavy surfaces, none and many triangles follow the same rule");
  MUELLE_EXPECT_ANSWERS(massesByArea);
  Random random = testRandom();
  for (const double density : {1e-6, 0.034, 730.0, 1e6}) expectMasses(bentSheet(random, 3, 2), density);
  expectMasses({}, 0.43);
  expectMasses({someNodes(random, 3), {}}, 0.43);
  expectMasses(largeTyre(), 1.3);
  expectMasses(rabbit(), 0.21);
}

// --- TotalMass ------------------------------------------------------------------------------------------------------

TEST(TotalMass, OfEqualMassesIsM) {
  MUELLE_PROPERTY("the masses of all n nodes add up to M");
  Random random = testRandom();
  for (const int n : {1, 3, 7, 2054}) {
    const double M = threeDigits(random.positive(0.3, 30.0));
    MUELLE_LABEL(fmt::format("sum of your {} masses with M = {} kg", n, M), "kg");
    EXPECT_NUMBER_NEAR(sumOf(submission::equalMasses(M, n)), M, inStructure(M));
  }
}

TEST(TotalMass, ByAreaIsThatOfTheSurface) {
  MUELLE_PROPERTY("the masses by area add up to the density times the area of the surface");
  Random random = testRandom();
  // The sides of a box of 0.7 x 0.9 x 1.1 m have 2 (0.63 + 0.77 + 0.99) = 4.78 m^2.
  TriangleMesh box;
  for (int i = 0; i < 8; ++i) box.nodes.push_back(Vec3((i & 1) * 0.7, (i >> 1 & 1) * 0.9, (i >> 2 & 1) * 1.1));
  box.triangles = cube;
  const double density = threeDigits(random.positive(0.2, 5.0));
  {
    MUELLE_LABEL(fmt::format("sum of your masses of a box of 4.78 m^2 with {} kg/m^2", density), "kg");
    EXPECT_NUMBER_NEAR(sumOf(submittedMasses(box, density)), 4.78 * density, inStructure(density));
  }
  // Three and four times (0.3, 0.4) make right angles: 6 triangles of 0.125 m^2 on a strip in space.
  TriangleMesh strip;
  for (int j = 0; j < 4; ++j) {
    strip.nodes.push_back(Vec3(0.3 * j, 0.4 * j, 0.31));
    strip.nodes.push_back(Vec3(0.3 * j, 0.4 * j, 0.81));
  }
  for (int j = 0; j < 6; ++j) strip.triangles.push_back({j, j + 1, j + 2});
  MUELLE_LABEL(fmt::format("sum of your masses of a strip of 0.75 m^2 with {} kg/m^2", density), "kg");
  EXPECT_NUMBER_NEAR(sumOf(submittedMasses(strip, density)), 0.75 * density, inStructure(density));
}
