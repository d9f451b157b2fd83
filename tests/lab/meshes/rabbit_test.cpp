#include "lab/meshes/rabbit.h"
#include "engine/scene/connectivity.h"
#include "engine/scene/mesh_file.h"
#include "mesh_shape.h"

#include <gtest/gtest.h>

namespace muelle::lab {
namespace {

using engine::SurfaceMesh;

SurfaceMesh committedRabbit() { return engine::readMeshFile(MUELLE_MESHES "/rabbit.off"); }

TEST(Rabbit, IsWhatItsProgramMakes) {
  const SurfaceMesh there = committedRabbit();
  const SurfaceMesh made = rabbitMesh();
  const char* again = "write it again: build/bin/muelle-rabbit exercises/mesh_to_springs/rabbit.off";
  EXPECT_EQ(there.triangles, made.triangles) << again;
  ASSERT_EQ(there.vertices.size(), made.vertices.size()) << again;
  // The file's coordinates are rounded to 1e-5 m, on either side of a half by the machine's round-off.
  for (std::size_t i = 0; i < made.vertices.size(); ++i) {
    ASSERT_LT((there.vertices[i] - made.vertices[i]).lpNorm<Eigen::Infinity>(), 0.51e-5) << i << "; " << again;
  }
}

TEST(Rabbit, IsOnePieceWithoutHolesOrHandlesAndTurnedOutwards) {
  const SurfaceMesh mesh = committedRabbit();
  EXPECT_GE(mesh.vertices.size(), 1500u);
  EXPECT_LE(mesh.vertices.size(), 2500u);
  EXPECT_TRUE(engine::isClosed(mesh));
  EXPECT_EQ(engine::connectivityOf(mesh).pieces, 1);
  EXPECT_EQ(engine::connectivityOf(mesh).unused, 0);
  EXPECT_EQ(eulerCharacteristic(mesh), 2);
  // Between the body's ellipsoid alone, 4/3 pi 0.058 0.040 0.047 = 4.6e-4, and the box about the whole, 3.6e-3 m^3.
  EXPECT_GT(engine::signedVolume(mesh), 4.6e-4);
  EXPECT_LT(engine::signedVolume(mesh), 3.6e-3);
}

TEST(Rabbit, HasNoSlivers) {
  const auto [least, most] = angleRange(committedRabbit());
  EXPECT_GT(least, 25.0);
  EXPECT_LT(most, 115.0);
}

TEST(Rabbit, StandsOnItsFeetAndIsAsHighAsItSays) {
  double low = 1.0;
  double high = 0.0;
  int soles = 0;
  for (const Vec3& x : committedRabbit().vertices) {
    low = std::min(low, x.z());
    high = std::max(high, x.z());
    soles += x.z() < 1e-3 ? 1 : 0;
  }
  EXPECT_EQ(low, 0.0);
  EXPECT_NEAR(high, rabbitHeight, 1e-9);
  EXPECT_GE(soles, 40);  // flat soles: it rests on many vertices, and does not tip
}

}  // namespace
}  // namespace muelle::lab
