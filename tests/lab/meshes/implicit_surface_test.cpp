#include "lab/meshes/implicit_surface.h"
#include "mesh_shape.h"

#include <gtest/gtest.h>
#include <cmath>
#include <Eigen/Geometry>
#include <numbers>

namespace muelle::lab {
namespace {

using engine::SurfaceMesh;

const ImplicitBody ball = {[](const Vec3& x) { return x.norm() - 1.0; }, Vec3::Constant(-1.31), Vec3::Constant(1.37)};

TEST(ImplicitSurface, ABallHasItsVertexesOnTheSphereAndNearlyItsVolume) {
  const double size = 0.15;
  const SurfaceMesh mesh = triangulate(ball, size);
  EXPECT_TRUE(engine::isClosed(mesh));
  EXPECT_EQ(eulerCharacteristic(mesh), 2);
  for (const Vec3& x : mesh.vertices) ASSERT_NEAR(x.norm(), 1.0, 1e-12);
  // A triangle with edges a under a sphere leaves out a sagitta of up to a^2/6 of the radius; edges go up to 4/3 size.
  const double volume = 4.0 / 3.0 * std::numbers::pi;
  EXPECT_LT(engine::signedVolume(mesh), volume);
  EXPECT_GT(engine::signedVolume(mesh), volume * (1.0 - 3.0 * std::pow(4.0 / 3.0 * size, 2) / 6.0));
}

TEST(ImplicitSurface, LeavesNoSlivers) {
  const auto [least, most] = angleRange(triangulate(ball, 0.15));
  // With six edges at nearly every vertex angles lie about 60 degrees, at the few with five about 72, with seven 51.
  EXPECT_GT(least, 30.0);
  EXPECT_LT(most, 110.0);
}

TEST(ImplicitSurface, ARingKeepsItsHole) {
  const auto value = [](const Vec3& x) { return std::hypot(std::hypot(x[0], x[1]) - 1.0, x[2]) - 0.4; };
  const SurfaceMesh mesh = triangulate({value, {-1.61, -1.63, -0.63}, {1.71, 1.67, 0.61}}, 0.15);
  EXPECT_TRUE(engine::isClosed(mesh));
  EXPECT_EQ(eulerCharacteristic(mesh), 0);
}

TEST(ImplicitSurface, ThinPartsNeverOpenIt) {
  // Two balls that touch in a neck thinner than the triangles: whatever becomes of the neck, no edge has one side.
  const auto value = [](const Vec3& x) {
    return std::min((x - Vec3::UnitX()).norm(), (x + Vec3::UnitX()).norm()) - 1.003;
  };
  const SurfaceMesh mesh = triangulate({value, {-2.31, -1.33, -1.37}, {2.33, 1.31, 1.35}}, 0.2);
  EXPECT_TRUE(engine::isClosed(mesh));
}

}  // namespace
}  // namespace muelle::lab
