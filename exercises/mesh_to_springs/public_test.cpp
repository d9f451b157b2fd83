#include "course/testing/expect.h"
#include "harness/triangle_mesh.h"
#include "mesh_to_springs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

// A square of the nodes 0, 1, 2, 3 at (0, 0, 0), (3, 0, 0), (3, 4, 0), (0, 4, 0), cut along its diagonal 0-2, and a
// grid of two rows and three columns:
//
//     0 - 1 - 2
//     |   |   |
//     3 - 4 - 5

namespace {

const std::vector<Vec3> corners = {{0, 0, 0}, {3, 0, 0}, {3, 4, 0}, {0, 4, 0}};
const std::vector<Triangle> square = {{0, 1, 2}, {0, 2, 3}};

/// The nodes of all edges, one row an edge.
muelle::MatX table(const std::vector<Edge>& edges) {
  muelle::MatX rows(static_cast<Eigen::Index>(edges.size()), 2);
  Eigen::Index row = 0;
  for (const Edge& edge : edges) {
    rows(row, 0) = edge[0];
    rows(row++, 1) = edge[1];
  }
  return rows;
}

/// The edges with the smaller node first, sorted.
std::vector<Edge> inOrder(std::vector<Edge> edges) {
  for (Edge& edge : edges) std::ranges::sort(edge);
  std::ranges::sort(edges);
  return edges;
}

muelle::VecX vectorOf(const std::vector<double>& values) {
  return Eigen::Map<const muelle::VecX>(values.data(), static_cast<Eigen::Index>(values.size()));
}

TEST(MeshEdges, OfASquare) {
  MUELLE_PROPERTY("two triangles that share the diagonal 0-2 have five edges: 0-1, 0-2, 0-3, 1-2 and 2-3");
  MUELLE_LABEL("edges of {0, 1, 2} and {0, 2, 3}, sorted, one row an edge");
  EXPECT_MATRIX_NEAR(table(inOrder(submission::meshEdges(square))), table({{0, 1}, {0, 2}, {0, 3}, {1, 2}, {2, 3}}), 0);
}

TEST(EachEdgeOnce, WhicheverWayRoundANeighbourGoes) {
  MUELLE_PROPERTY("the same five edges when the second triangle is given as {0, 3, 2}");
  MUELLE_LABEL("edges of {0, 1, 2} and {0, 3, 2}, sorted, one row an edge");
  EXPECT_MATRIX_NEAR(table(inOrder(submission::meshEdges({{0, 1, 2}, {0, 3, 2}}))),
                     table({{0, 1}, {0, 2}, {0, 3}, {1, 2}, {2, 3}}), 0);
}

TEST(EulersFormula, HoldsForATetrahedron) {
  MUELLE_PROPERTY("a tetrahedron has 4 nodes, 6 edges and 4 triangles: 4 - 6 + 4 = 2");
  MUELLE_LABEL("edges of a tetrahedron");
  const std::vector<Triangle> tetrahedron = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  EXPECT_NUMBER_NEAR(static_cast<double>(submission::meshEdges(tetrahedron).size()), 6, 0);
}

TEST(EulersFormula, HoldsForTheRabbit) {
  MUELLE_PROPERTY("the rabbit has 2054 nodes and 4104 triangles, so 6156 edges: 2054 - 6156 + 4104 = 2");
  MUELLE_LABEL("edges of the rabbit");
  const muelle::TriangleMesh rabbit = muelle::readTriangleMesh(MUELLE_EXERCISE_FOLDER "/rabbit.off");
  EXPECT_NUMBER_NEAR(static_cast<double>(submission::meshEdges(rabbit.triangles).size()), 6156, 0);
}

TEST(GridSprings, Structural) {
  MUELLE_PROPERTY("a grid of 2 x 3 nodes has seven structural springs: four in its rows, three in its columns");
  MUELLE_LABEL("structural springs of 2 x 3 nodes, sorted, one row a spring");
  EXPECT_MATRIX_NEAR(table(inOrder(submission::structuralSprings(2, 3))),
                     table({{0, 1}, {0, 3}, {1, 2}, {1, 4}, {2, 5}, {3, 4}, {4, 5}}), 0);
}

TEST(GridSprings, Shear) {
  MUELLE_PROPERTY("a grid of 2 x 3 nodes has four shear springs, two a cell");
  MUELLE_LABEL("shear springs of 2 x 3 nodes, sorted, one row a spring");
  EXPECT_MATRIX_NEAR(table(inOrder(submission::shearSprings(2, 3))), table({{0, 4}, {1, 3}, {1, 5}, {2, 4}}), 0);
}

TEST(GridSprings, Bending) {
  MUELLE_PROPERTY("a grid of 2 x 3 nodes has two bending springs, one a row");
  MUELLE_LABEL("bending springs of 2 x 3 nodes, sorted, one row a spring");
  EXPECT_MATRIX_NEAR(table(inOrder(submission::bendingSprings(2, 3))), table({{0, 2}, {3, 5}}), 0);
}

TEST(SortedEdges, OfASquare) {
  MUELLE_PROPERTY("the smaller node first, and sorted: 0-1, 0-2, 0-3, 1-2, 2-3, whatever the triangles begin with");
  MUELLE_LABEL("edges of {3, 2, 0} and {2, 1, 0}, one row an edge");
  EXPECT_MATRIX_NEAR(table(submission::meshEdges({{3, 2, 0}, {2, 1, 0}})),
                     table({{0, 1}, {0, 2}, {0, 3}, {1, 2}, {2, 3}}), 0);
}

TEST(RestLengths, OfTheSquare) {
  MUELLE_PROPERTY("the edges 0-1, 1-2 and 0-2 of the square are 3, 4 and 5 m long");
  const std::vector<Edge> edges = {{0, 1}, {1, 2}, {0, 2}};
  EXPECT_VECTOR_NEAR(vectorOf(submission::restLengths(corners, edges)), Vec3(3, 4, 5), 1e-12);
}

TEST(EqualMasses, OfFourNodes) {
  MUELLE_PROPERTY("6 kg on four nodes are 1.5 kg each");
  EXPECT_VECTOR_NEAR(vectorOf(submission::equalMasses(6, 4)), Eigen::Vector4d(1.5, 1.5, 1.5, 1.5), 1e-12);
}

TEST(MassesByArea, OfTheSquare) {
  MUELLE_PROPERTY(
      "both triangles have 6 m^2 and, with 0.5 kg/m^2, weigh 3 kg: nodes 0 and 2 belong to both, 1 and 3 to one");
  EXPECT_VECTOR_NEAR(vectorOf(submission::massesByArea(corners, square, 0.5)), Eigen::Vector4d(2, 1, 2, 1), 1e-12);
}

TEST(TotalMass, OfTheSquare) {
  MUELLE_PROPERTY("the square has 12 m^2 and, with 0.5 kg/m^2, weighs 6 kg");
  const std::vector<double> masses = submission::massesByArea(corners, square, 0.5);
  MUELLE_LABEL("sum of your masses", "kg");
  EXPECT_NUMBER_NEAR(std::accumulate(masses.begin(), masses.end(), 0.0), 6, 1e-12);
}

}  // namespace
