#include "engine/scene/connectivity.h"
#include "support/scene_text.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <Eigen/Geometry>

namespace muelle::engine {
namespace {

using ::testing::ElementsAre;

SurfaceMesh twoSquaresApart() {
  return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {9, 9, 9}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}},
          {{0, 1, 2}, {0, 2, 3}, {5, 6, 7}, {5, 7, 8}}};
}

TEST(ConnectivityOfMesh, CountsPiecesPlacesAndWhatNoFaceNames) {
  const Connectivity found = connectivityOf(twoSquaresApart());
  EXPECT_EQ(found.vertices, 8);
  EXPECT_EQ(found.unused, 1);
  EXPECT_EQ(found.places, 6);
  EXPECT_EQ(found.pieces, 2);
}

TEST(ConnectivityOfMesh, AWeldedMeshIsOnePieceWithTheSameArea) {
  SurfaceMesh mesh = twoSquaresApart();
  weld(mesh);
  dropUnused(mesh);
  EXPECT_EQ(mesh.vertices.size(), 6u);
  EXPECT_EQ(edgesOf(mesh.triangles).size(), 9u);  // 4 + 3 sides, 2 diagonals
  EXPECT_EQ(connectivityOf(mesh).pieces, 1);
  double area = 0.0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3& from = mesh.vertices[static_cast<std::size_t>(a)];
    area += (mesh.vertices[static_cast<std::size_t>(b)] - from)
                .cross(mesh.vertices[static_cast<std::size_t>(c)] - from)
                .norm() /
            2.0;
  }
  EXPECT_NEAR(area, 2.0, 1e-15);
}

/// A scene of one shell: two triangles side by side that share no vertex, a face that is none, a vertex of no face.
Scene shellOf(const TemporaryFolder& folder, const std::string& keys) {
  writeFile(folder.path() / "two.obj",
            "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 7 7 7\nf 1 2 3\nf 4 5 6\nf 1 1 2\n");
  writeFile(folder.path() / "test.toml",
            fmt::format("title = 'A test'\nshows = 'nothing'\nslide = 'Ley de Hooke'\ndimension = 3\n[[object]]\n"
                        "kind = 'shell'\nmesh = 'two.obj'\nk = 1.0\nmass = 1.0\n{}\n{}",
                        keys, run));
  return readScene(folder.path() / "test.toml");
}

TEST(ShellOfAMesh, TellsWhatIsPerhapsNotMeantAndHasNoNodeThatNothingHolds) {
  const TemporaryFolder folder(::testing::TempDir());
  const Scene scene = shellOf(folder, "");
  EXPECT_EQ(scene.model.nodes.size(), 6u);
  EXPECT_EQ(scene.model.springs.size(), 6u);
  EXPECT_THAT(scene.warnings,
              ElementsAre("mesh '" + (folder.path() / "two.obj").string() +
                          "': 1 face without three different corners is left out, 1 vertex of no face is "
                          "no node, 2 pieces that nothing joins, 6 vertices at 4 places; weld = true makes one node of "
                          "those at the same place"));
}

TEST(ShellOfAMesh, WeldedHasANodeAtEachPlace) {
  const TemporaryFolder folder(::testing::TempDir());
  const Scene scene = shellOf(folder, "weld = true");
  EXPECT_EQ(scene.model.nodes.size(), 4u);
  EXPECT_EQ(scene.model.springs.size(), 5u);
  EXPECT_EQ(scene.warnings.size(), 1u);  // of the face and the vertex alone
}

}  // namespace
}  // namespace muelle::engine
