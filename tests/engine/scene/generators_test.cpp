#include "engine/scene/generators.h"
#include "engine/model/damping.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <cmath>
#include <Eigen/Geometry>
#include <set>

namespace muelle::engine {
namespace {

double totalMass(const Model& model) {
  double sum = 0.0;
  for (const ModelNode& node : model.nodes) sum += node.m;
  return sum;
}

/// Every spring joins two different nodes that exist, once, and is at rest.
void expectSoundSprings(const Model& model) {
  std::set<std::pair<int, int>> seen;
  for (const ModelSpring& spring : model.springs) {
    ASSERT_NE(spring.a, spring.b);
    ASSERT_LT(std::max(spring.a, spring.b), std::ssize(model.nodes));
    ASSERT_TRUE(seen.insert(std::minmax(spring.a, spring.b)).second) << spring.a << " " << spring.b;
    const double L =
        (model.nodes[static_cast<std::size_t>(spring.a)].x - model.nodes[static_cast<std::size_t>(spring.b)].x).norm();
    ASSERT_EQ(spring.L0, L);
  }
}

TEST(Chain, HasItsCountsMassAndLength) {
  Model model;
  ChainShape shape;
  shape.n = 11;
  shape.to = {0.3, 0.4, 0.0};
  shape.angleStiffness = 1.0;
  const Part part = addChain(model, shape);
  lumpMass(model, part, 2.2);
  EXPECT_EQ(model.nodes.size(), 11u);
  EXPECT_EQ(model.springs.size(), 10u);
  EXPECT_EQ(model.angles.size(), 9u);
  EXPECT_NEAR(part.measure, 0.5, 1e-16);
  EXPECT_NEAR(totalMass(model), 2.2, 1e-15);
  EXPECT_NEAR(model.nodes[4].m, 0.2, 1e-16);
  expectSoundSprings(model);
}

TEST(Chain, TaperKeepsTheMassAndItsRatioIsThatOfTheEnds) {
  Model model;
  ChainShape shape;
  shape.n = 5;
  lumpMass(model, addChain(model, shape), 3.0, 1.0 / 16.0);
  EXPECT_NEAR(totalMass(model), 3.0, 1e-15);
  EXPECT_NEAR(model.nodes[0].m / model.nodes[4].m, 16.0, 1e-13);
  EXPECT_NEAR(model.nodes[1].m / model.nodes[2].m, 2.0, 1e-14);
}

TEST(Chain, SagLowersTheMiddleAndKeepsTheEnds) {
  Model model;
  ChainShape shape;
  shape.n = 3;
  shape.sag = 0.25;
  shape.L0 = 0.7;
  addChain(model, shape);
  EXPECT_EQ(model.nodes[0].x, Vec3(0, 0, 0));
  EXPECT_EQ(model.nodes[1].x, Vec3(0.5, 0, -0.25));
  EXPECT_EQ(model.springs[0].L0, 0.7);
}

TEST(Chain, DampingRatioIsThatOfTwoMassesOnOneSpring) {
  Model model;
  ChainShape shape;
  shape.spring.k = 100.0;
  const Part part = addChain(model, shape);
  lumpMass(model, part, 4.0);
  setDampingRatio(model, part, 1.0);
  // Two masses of 2 kg swing against each other as 1 kg on the spring: critical at 2 sqrt(100 * 1).
  EXPECT_DOUBLE_EQ(projectedDamping(model, model.springs[0]), 20.0);
}

TEST(Grid, HasPartsNamedAfterWhatTheyResist) {
  Model model;
  GridShape shape;
  shape.nu = shape.nv = 3;
  shape.shearStiffness = shape.bendStiffness = shape.dihedralStiffness = shape.areaModulus = 1.0;
  addGrid(model, shape, "cloth");
  std::vector<std::pair<std::string, long long>> parts;
  for (const ModelPart& part : partsOf(model)) parts.emplace_back(part.name, part.elements);
  // 2 (3 2) edges, two diagonals in each of 4 cells, 2 * 3 springs over two cells; 8 inner edges of 8 triangles.
  const std::vector<std::pair<std::string, long long>> expected = {
      {"cloth.structural", 12}, {"cloth.shear", 8}, {"cloth.bend", 6}, {"cloth.dihedral", 8}, {"cloth.area", 8}};
  EXPECT_EQ(parts, expected);
}

TEST(Grid, IsTheClothOfTheHardCases) {
  Model model;
  GridShape shape;
  shape.nu = shape.nv = 10;
  shape.shearStiffness = 1000.0;
  const Part part = addGrid(model, shape);
  EXPECT_EQ(part.nodeCount, 100);
  EXPECT_EQ(model.springs.size(), 180u + 162u);
  EXPECT_NEAR((model.nodes[47].x - Vec3(0.7, 0.4, 0)).norm(), 0.0, 1e-15);
  EXPECT_NEAR(part.measure, 0.81, 1e-15);
  expectSoundSprings(model);
}

TEST(Grid, BendsAreOverTwoCellsAndEveryInnerEdgeIsAHinge) {
  Model model;
  GridShape shape;
  shape.nu = 4;
  shape.nv = 3;
  shape.bendStiffness = 1.0;
  shape.dihedralStiffness = 1.0;
  shape.areaModulus = 2.0;
  addGrid(model, shape);
  EXPECT_EQ(model.springs.size(), (3u * 3u + 4u * 2u) + (2u * 3u + 4u * 1u));
  // 12 triangles have 36 sides; 10 edges of the rim are sides once: (36 - 10) / 2 edges are between two triangles.
  EXPECT_EQ(model.dihedrals.size(), 13u);
  ASSERT_EQ(model.areas.size(), 12u);
  for (const ModelArea& area : model.areas) {
    EXPECT_NEAR(area.A0, 0.005, 1e-17);
    EXPECT_NEAR(area.k, 2.0 / 0.005, 1e-10);
    EXPECT_EQ(area.normal, Vec3::UnitZ());
  }
}

TEST(Grid, AreasInThePlaneAreSignedAsTheModelMeasuresThem) {
  Model model;
  model.dimension = 2;
  GridShape shape;
  shape.along = Vec3::UnitZ();
  shape.areaModulus = 1.0;
  addGrid(model, shape);
  EXPECT_NEAR(model.areas[0].A0, 0.005, 1e-17);
  EXPECT_GT(model.areas[0].k, 0.0);
}

TEST(Box, TetrahedraFillItAndFaceOutwards) {
  Model model;
  BoxShape shape;
  shape.nx = 3;
  shape.ny = 2;
  shape.nz = 2;
  shape.size = {0.6, 0.5, 0.4};
  shape.bulkModulus = 1.0;
  const Part part = addBox(model, shape);
  EXPECT_EQ(part.nodeCount, 4 * 3 * 3);
  EXPECT_EQ(model.volumes.size(), 5u * 12u);
  double volume = 0.0;
  for (const ModelVolume& tetrahedron : model.volumes) {
    EXPECT_GT(tetrahedron.V0, 0.0);
    volume += tetrahedron.V0;
  }
  EXPECT_NEAR(volume, 0.12, 1e-15);
  // The outer triangles are two a face of a cell, and enclose the box: only if the diagonals of neighbours meet.
  EXPECT_EQ(part.triangles.size(), 2u * 2u * (3u * 2u + 3u * 2u + 2u * 2u));
  SurfaceMesh surface;
  for (const ModelNode& node : model.nodes) surface.vertices.push_back(node.x);
  surface.triangles = part.triangles;
  EXPECT_TRUE(isClosed(surface));
  EXPECT_NEAR(signedVolume(surface), 0.12, 1e-15);
  // Cell edges, and one diagonal a face of a cell, shared between neighbours.
  const std::size_t edges = 3 * 3 * 3 + 4 * 2 * 3 + 4 * 3 * 2;
  const std::size_t faces = 3 * 2 * 3 + 3 * 2 * 3 + 4 * 2 * 2;
  EXPECT_EQ(model.springs.size(), edges + faces);
  expectSoundSprings(model);
}

/// A sphere's octahedron, each face cut into four `depth` times, with the vertices moved onto the sphere.
SurfaceMesh ball(double radius, int depth) {
  SurfaceMesh mesh{{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
                   {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
  for (int d = 0; d < depth; ++d) {
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int a, int b) {
      const auto [at, isNew] = middles.emplace(std::minmax(a, b), static_cast<int>(mesh.vertices.size()));
      if (isNew) {
        const Vec3 sum = mesh.vertices[static_cast<std::size_t>(a)] + mesh.vertices[static_cast<std::size_t>(b)];
        mesh.vertices.push_back(sum.normalized());
      }
      return at->second;
    };
    std::vector<Triangle> finer;
    for (const auto& [a, b, c] : mesh.triangles) {
      const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    mesh.triangles = finer;
  }
  for (Vec3& x : mesh.vertices) x *= radius;
  return mesh;
}

TEST(Lattice, FillsABall) {
  Model model;
  LatticeShape shape;
  shape.mesh = ball(1.0, 3);
  shape.spacing = 0.2;
  const Part part = addLattice(model, shape);
  const int vertices = static_cast<int>(shape.mesh.vertices.size());
  for (int i = vertices; i < part.nodeCount; ++i) {
    EXPECT_LT(model.nodes[static_cast<std::size_t>(i)].x.norm(), 1.0);
  }
  // Inner nodes: the lattice points of a ball that ends 0.35 spacings inside at the least, at most at its surface.
  const auto points = [](double radius) { return 4.0 / 3.0 * M_PI * std::pow(radius / 0.2, 3); };
  EXPECT_GT(part.nodeCount - vertices, points(0.85));
  EXPECT_LT(part.nodeCount - vertices, points(1.0));
  EXPECT_NEAR(part.measure, 4.0 / 3.0 * M_PI, 0.03 * 4.0 / 3.0 * M_PI);
  expectSoundSprings(model);
}

TEST(Lattice, RefusesASpacingThatLeavesNothingInside) {
  Model model;
  LatticeShape shape;
  shape.mesh = ball(1.0, 1);
  shape.spacing = 1e-4;
  EXPECT_THROW(addLattice(model, shape), std::invalid_argument);
  for (Triangle& t : shape.mesh.triangles) std::swap(t[0], t[1]);  // inside out
  shape.spacing = 0.2;
  Model other;
  EXPECT_THROW(addLattice(other, shape), std::invalid_argument);
}

TEST(Generators, RefuseWhatMakesNoSense) {
  Model model;
  EXPECT_THROW(addChain(model, {.n = 1}), std::invalid_argument);
  EXPECT_THROW(addChain(model, {.n = 3, .to = Vec3::Zero()}), std::invalid_argument);
  EXPECT_THROW(addGrid(model, {.nu = 1, .nv = 5}), std::invalid_argument);
  EXPECT_THROW(addGrid(model, {.along = Vec3::UnitX()}), std::invalid_argument);
  EXPECT_THROW(addBox(model, {.nx = 0}), std::invalid_argument);
  model.dimension = 2;
  EXPECT_THROW(addBox(model, {}), std::invalid_argument);
  EXPECT_TRUE(model.nodes.empty());
}

}  // namespace
}  // namespace muelle::engine
