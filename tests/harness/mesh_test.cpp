#include "harness/mesh.h"

#include <gtest/gtest.h>
#include <cmath>
#include <set>
#include <utility>

namespace muelle {
namespace {

const Material material{.M = 3.0, .k = 50.0};

double totalMass(const Mesh& mesh) {
  double total = 0;
  for (const Node& node : mesh.nodes) total += node.m;
  return total;
}

double lengthOf(const Mesh& mesh, const Spring& spring) {
  return (mesh.nodes[static_cast<std::size_t>(spring.a)].x - mesh.nodes[static_cast<std::size_t>(spring.b)].x).norm();
}

/// Springs join two different nodes of the mesh, each pair once, at rest, with the material's stiffness.
void expectSound(const Mesh& mesh) {
  const int n = static_cast<int>(mesh.nodes.size());
  std::set<std::pair<int, int>> pairs;
  for (const Spring& spring : mesh.springs) {
    ASSERT_TRUE(spring.a >= 0 && spring.a < n && spring.b >= 0 && spring.b < n && spring.a != spring.b);
    EXPECT_TRUE(pairs.insert(std::minmax(spring.a, spring.b)).second);
    EXPECT_EQ(spring.L0, lengthOf(mesh, spring));
    EXPECT_EQ(spring.k, material.k);
  }
  EXPECT_NEAR(totalMass(mesh), material.M, 1e-14);
  for (const Node& node : mesh.nodes) {
    EXPECT_EQ(node.m, material.M / n);
    EXPECT_EQ(node.v, Vec3::Zero());
    EXPECT_FALSE(node.pinned);
  }
}

TEST(Chain, RunsFromStartToEndInEqualPieces) {
  const Vec3 start(1, 2, 3), end(1, 6, 6);
  const Mesh mesh = chain(6, start, end, material);
  expectSound(mesh);
  ASSERT_EQ(mesh.nodes.size(), 6u);
  ASSERT_EQ(mesh.springs.size(), 5u);
  EXPECT_EQ(mesh.nodes.front().x, start);
  EXPECT_EQ(mesh.nodes.back().x, end);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(mesh.springs[i].a, static_cast<int>(i));
    EXPECT_EQ(mesh.springs[i].b, static_cast<int>(i) + 1);
    EXPECT_NEAR(mesh.springs[i].L0, 1.0, 1e-14);
  }
}

TEST(Grid, HasTheSpringsOfItsEdges) {
  const int nx = 4, ny = 3;
  const Mesh mesh = grid(nx, ny, 0.5, false, material);
  expectSound(mesh);
  EXPECT_EQ(mesh.nodes.size(), 12u);
  EXPECT_EQ(mesh.springs.size(), static_cast<std::size_t>((nx - 1) * ny + nx * (ny - 1)));
  EXPECT_EQ(mesh.nodes[2 * nx + 3].x, Vec3(1.5, 1.0, 0));
  for (const Spring& spring : mesh.springs) EXPECT_DOUBLE_EQ(spring.L0, 0.5);
}

TEST(Grid, HasBothDiagonalsOfEachCellWithShear) {
  const int nx = 4, ny = 3;
  const Mesh mesh = grid(nx, ny, 0.5, true, material);
  expectSound(mesh);
  EXPECT_EQ(mesh.springs.size(), static_cast<std::size_t>((nx - 1) * ny + nx * (ny - 1) + 2 * (nx - 1) * (ny - 1)));
  int diagonals = 0;
  for (const Spring& spring : mesh.springs) diagonals += std::abs(spring.L0 - 0.5 * std::sqrt(2.0)) < 1e-14 ? 1 : 0;
  EXPECT_EQ(diagonals, 2 * (nx - 1) * (ny - 1));
}

TEST(Triangle, HasTheSpringsInTheOrderOfTheExercise) {
  const Mesh mesh = triangle(Vec3(0, 0, 0), Vec3(3, 0, 0), Vec3(3, 4, 0), material);
  expectSound(mesh);
  ASSERT_EQ(mesh.springs.size(), 3u);
  const std::pair<int, int> ends[] = {{0, 1}, {1, 2}, {2, 0}};
  const double lengths[] = {3, 4, 5};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(mesh.springs[i].a, ends[i].first);
    EXPECT_EQ(mesh.springs[i].b, ends[i].second);
    EXPECT_DOUBLE_EQ(mesh.springs[i].L0, lengths[i]);
  }
}

TEST(Generators, RefuseWhatMakesNoMesh) {
  const Vec3 o = Vec3::Zero(), x = Vec3::UnitX(), y = Vec3::UnitY();
  EXPECT_THROW(chain(1, o, x, material), std::invalid_argument);
  EXPECT_THROW(chain(3, o, o, material), std::invalid_argument);
  EXPECT_THROW(chain(3, o, Vec3(NAN, 0, 0), material), std::invalid_argument);
  EXPECT_THROW(chain(3, o, x, {.M = 0.0}), std::invalid_argument);
  EXPECT_THROW(chain(3, o, x, {.k = -1.0}), std::invalid_argument);
  EXPECT_THROW(grid(1, 3, 1.0, true, material), std::invalid_argument);
  EXPECT_THROW(grid(3, 1, 1.0, true, material), std::invalid_argument);
  EXPECT_THROW(grid(3, 3, 0.0, true, material), std::invalid_argument);
  EXPECT_THROW(grid(3, 3, 1.0, true, {.k = NAN}), std::invalid_argument);
  EXPECT_THROW(triangle(o, x, x, material), std::invalid_argument);
  EXPECT_THROW(triangle(o, x, y, {.M = HUGE_VAL}), std::invalid_argument);
}

}  // namespace
}  // namespace muelle
