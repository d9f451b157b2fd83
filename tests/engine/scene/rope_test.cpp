/// Ropes: lines of mesh files as nodes and springs.

#include "engine/model/model_system.h"
#include "engine/scene/generators.h"
#include "engine/scene/mesh_file.h"
#include "support/scene_text.h"

#include <gtest/gtest.h>

namespace muelle::engine {
namespace {

/// A Y of four vertices: 1 m up from the foot, then two arms of 0.5 m; vertex 4 is of no line.
const std::string yShape = "v 0 0 0\nv 0 0 1\nv 0.3 0 1.4\nv -0.3 0 1.4\nv 9 9 9\nl 1 2 3\nl 2 4\n";

const std::string ropeHead = "title = 'A test'\nshows = 'nothing'\nslide = 'Ley de Hooke'\ngravity = 0.0\n";
const std::string rope = "[[object]]\nkind = 'rope'\nmesh = 'rope.obj'\nk = 100.0\n";

/// The scene of an object with a mesh file beside it.
Scene ropeScene(const std::string& mesh, const std::string& object, const std::string& more = "") {
  const TemporaryFolder folder(::testing::TempDir());
  writeFile(folder.path() / "rope.obj", mesh);
  writeFile(folder.path() / "test.toml", ropeHead + more + object + run);
  return readScene(folder.path() / "test.toml");
}

std::string ropeComplaint(const std::string& mesh, const std::string& object, const std::string& more = "") {
  try {
    ropeScene(mesh, object, more);
  } catch (const std::runtime_error& error) {
    const std::string text = error.what();
    const std::size_t slash = text.find("rope.obj:");
    return slash == std::string::npos ? text : text.substr(slash);
  }
  return "";
}

TEST(Rope, HasANodeAtEachVertexAndASpringAlongEachLine) {
  const Scene scene = ropeScene(yShape, rope + "mass = 4.0\n");
  ASSERT_EQ(scene.model.nodes.size(), 4u);
  ASSERT_EQ(scene.model.springs.size(), 3u);
  EXPECT_EQ(scene.model.springs[0].L0, 1.0);
  EXPECT_NEAR(scene.model.springs[2].L0, 0.5, 1e-15);
  EXPECT_EQ(scene.parts[0].measure, scene.model.springs[0].L0 + scene.model.springs[1].L0 + scene.model.springs[2].L0);
  ASSERT_EQ(scene.warnings.size(), 1u);
  EXPECT_NE(scene.warnings[0].find("1 vertex of no line is no node"), std::string::npos) << scene.warnings[0];
}

TEST(Rope, SharesItsMassByTheLengthOfItsLines) {
  // 4 kg on 2 m: each node half of the length of its lines, 0.5, 1, 0.25 and 0.25 m, times 2 kg/m.
  for (const char* mass : {"mass = 4.0\n", "density = 2.0\n"}) {
    const Scene scene = ropeScene(yShape, rope + mass);
    const double expected[] = {1.0, 2.0, 0.5, 0.5};
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(scene.model.nodes[i].m, expected[i], 1e-14) << i;
  }
}

TEST(Rope, TakesTheKeysOfAChain) {
  const Scene scene = ropeScene(yShape, rope +
                                            "mass = 1.0\nangle_stiffness = 0.5\nunilateral = true\nscale = 2.0\n"
                                            "projected_damping = 3.0\nrelative_damping = 0.25\n");
  EXPECT_TRUE(scene.model.angles.empty());  // the knot has three lines
  EXPECT_TRUE(scene.model.springs[0].unilateral);
  EXPECT_EQ(scene.model.springs[0].L0, 2.0);
  EXPECT_EQ(scene.model.springs[0].dProjected, 3.0);
  EXPECT_EQ(scene.model.springs[0].dRelative, 0.25);
  const Scene line = ropeScene("v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\nl 1 2 3 4\n",
                               rope + "mass = 1.0\nangle_stiffness = 0.5\ndamping_ratio = 0.1\n");
  EXPECT_EQ(line.model.angles.size(), 2u);
  EXPECT_EQ(line.model.springs[1].dampingRatio, 0.1);
}

TEST(Rope, IsAChainWhereItsLinesAreOne) {
  const Scene chain = ropeScene("",
                                "[[object]]\nkind = 'chain'\nnodes = 5\nfrom = [0.0, 0.0, 0.0]\n"
                                "to = [2.0, 0.0, 0.0]\nmass = 5.0\nk = 100.0\n");
  const Scene line = ropeScene("v 0 0 0\nv .5 0 0\nv 1 0 0\nv 1.5 0 0\nv 2 0 0\nl 1 2 3 4 5\n", rope + "mass = 4.0\n");
  ASSERT_EQ(line.model.springs.size(), chain.model.springs.size());
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(line.model.springs[i].a, chain.model.springs[i].a);
    EXPECT_EQ(line.model.springs[i].b, chain.model.springs[i].b);
    EXPECT_EQ(line.model.springs[i].L0, chain.model.springs[i].L0);
  }
  EXPECT_EQ(line.model.nodes[1].m, chain.model.nodes[1].m);
  EXPECT_EQ(line.model.nodes[0].m,
            0.5 * line.model.nodes[1].m);  // a chain's end has a whole share, a rope's half a one
  EXPECT_EQ(build(line.model)->size(), 15);
}

TEST(Rope, LeavesOutLinesThatAreNoneAndSaysSo) {
  const Scene scene = ropeScene("v 0 0 0\nv 1 0 0\nl 1 2\nl 2 1\nl 1 1 2\n", rope + "mass = 1.0\n");
  EXPECT_EQ(scene.model.springs.size(), 1u);
  ASSERT_EQ(scene.warnings.size(), 1u);
  EXPECT_NE(scene.warnings[0].find("3 lines from a node to itself, or given before, are left out"), std::string::npos)
      << scene.warnings[0];
}

TEST(Rope, IsWeldedWhereItsLinesMeet) {
  const std::string parted = "v 0 0 0\nv 1 0 0\nv 1 0 0\nv 2 0 0\nl 1 2\nl 3 4\n";
  const Scene loose = ropeScene(parted, rope + "mass = 1.0\n");
  ASSERT_EQ(loose.warnings.size(), 1u);
  EXPECT_NE(loose.warnings[0].find("2 pieces that nothing joins, 4 vertices at 3 places"), std::string::npos);
  const Scene whole = ropeScene(parted, rope + "mass = 1.0\nweld = true\n");
  EXPECT_EQ(whole.model.nodes.size(), 3u);
  EXPECT_TRUE(whole.warnings.empty());
}

TEST(Rope, ReadsLinesOfEveryFormat) {
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
      "property float z\nelement edge 2\nproperty int vertex1\nproperty uchar red\n"
      "property int vertex2\nend_header\n0 0 0\n1 0 0\n2 0 0\n0 255 1\n1 255 2\n";
  const std::vector<Line> expected = {{0, 1}, {1, 2}};
  EXPECT_EQ(parsePly(ply, "x", MeshPart::Lines).lines, expected);
  EXPECT_EQ(parseOff("OFF\n3 3 0\n0 0 0\n1 0 0\n2 0 0\n2 0 1\n3 0 1 2\n2 1 2\n", "x", MeshPart::Lines).lines, expected);
  EXPECT_EQ(parseObj("l 1/1 2/4 3//\nv 0 0 0\nv 1 0 0\nv 2 0 0\nl -1 -2\n", "x", MeshPart::Lines).lines, expected);
}

TEST(Rope, ComplaintsSayWhatIsWrong) {
  const std::string object = rope + "mass = 1.0\n";
  EXPECT_EQ(ropeComplaint("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", object),
            "rope.obj:4: only faces and no line: a 'rope' needs lines; 'shell' and 'lattice' take faces");
  EXPECT_EQ(ropeComplaint("v 0 0 0\n", object), "rope.obj:1: no line");
  EXPECT_EQ(ropeComplaint("v 0 0 0\nl 1 1\n", object), "rope.obj:2: no line that has two different ends");
  EXPECT_EQ(ropeComplaint("v 0 0 0\nl 1 3\n", object),
            "rope.obj:2: a line names vertex 3 (counted from 1); there is 1");
  EXPECT_NE(ropeComplaint("v 0 0 0\nv 0 0 0\nl 1 2\n", object).find("has length 0; weld = true"), std::string::npos);
  EXPECT_NE(ropeComplaint("v 0 0 0\nv 1 1 0\nl 1 2\n", object, "dimension = 2\n").find("leave the plane of the scene"),
            std::string::npos);
  EXPECT_NE(ropeComplaint("v 0 0 0\nv 1 1 0\nl 1 2\n", object, "dimension = 1\n").find("dimension 2 or 3"),
            std::string::npos);
  EXPECT_NE(ropeComplaint(yShape, "[[object]]\nkind = 'shell'\nmesh = 'rope.obj'\nk = 1.0\nmass = 1.0\n")
                .find("a 'rope' takes lines"),
            std::string::npos);
}

}  // namespace
}  // namespace muelle::engine
