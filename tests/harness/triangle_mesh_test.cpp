#include "harness/triangle_mesh.h"

#include "base/file.h"
#include "support/temporary.h"

#include <gtest/gtest.h>

#include <fstream>
#include <string>

namespace muelle {
namespace {

/// The mesh of a text, by way of a file.
TriangleMesh meshOf(const std::string& text) {
  const TemporaryFolder folder(::testing::TempDir());
  std::ofstream(folder.path() / "mesh.off") << text;
  return readTriangleMesh(folder.path() / "mesh.off");
}

TEST(TriangleMesh, ReadsNodesAndTriangles) {
  const TriangleMesh mesh = meshOf("OFF\n# two\n4 2 0\n0 0 0\n1 0 0\n1 1 0.5\n0 1 0\n3 0 1 2\n3 0 2 3\n");
  ASSERT_EQ(mesh.nodes.size(), 4U);
  EXPECT_EQ(mesh.nodes[2], Vec3(1, 1, 0.5));
  EXPECT_EQ(mesh.triangles, (std::vector<std::array<int, 3>>{{0, 1, 2}, {0, 2, 3}}));
}

TEST(TriangleMesh, SaysWhatIsWrong) {
  const char* faults[] = {
      "OBJ\n1 0 0\n0 0 0\n",                                  // another format
      "OFF\n3 1 0\n0 0 0\n1 0 0\n",                           // a node is missing
      "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n",                    // a triangle is missing
      "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n",           // no such node
      "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n",  // a square
  };
  for (const char* text : faults) EXPECT_THROW(meshOf(text), std::runtime_error) << text;
  EXPECT_THROW(readTriangleMesh("no/such/file.off"), std::runtime_error);
}

}  // namespace
}  // namespace muelle
