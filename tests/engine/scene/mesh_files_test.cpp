#include "base/file.h"
#include "engine/scene/mesh_file.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <cstring>
#include <random>

namespace muelle::engine {
namespace {

using ::testing::HasSubstr;

/// A tetrahedron, anticlockwise seen from outside, volume 1/6; and coordinates that need all their digits.
SurfaceMesh tetrahedron() {
  const double a = 0.1 + 0.2;
  return {{{a, 0, 0}, {1 + a, 0, 0}, {a, 1, 0}, {a, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
}

std::string asOff(const SurfaceMesh& mesh) {
  std::string text = fmt::format("OFF\n# a comment\n{} {} 0\n", mesh.vertices.size(), mesh.triangles.size());
  for (const Vec3& x : mesh.vertices) text += fmt::format("{} {} {}\n", x[0], x[1], x[2]);
  for (const Triangle& t : mesh.triangles) text += fmt::format("3 {} {} {}\n", t[0], t[1], t[2]);
  return text;
}

std::string asObj(const SurfaceMesh& mesh) {
  std::string text = "# a comment\no thing\n";
  for (const Vec3& x : mesh.vertices) text += fmt::format("v {} {} {}\n", x[0], x[1], x[2]);
  text += "vn 0 0 1\nusemtl none\n";
  for (const Triangle& t : mesh.triangles) text += fmt::format("f {}//1 {}//1 {}//1\n", t[0] + 1, t[1] + 1, t[2] + 1);
  return text;
}

std::string plyHeader(const char* format, std::size_t vertices, std::size_t faces) {
  return fmt::format(
      "ply\nformat {} 1.0\ncomment made by a test\nelement vertex {}\nproperty double x\nproperty double y\n"
      "property uchar red\nproperty double z\nelement face {}\nproperty list uchar int vertex_indices\nend_header\n",
      format, vertices, faces);
}

std::string asPly(const SurfaceMesh& mesh) {
  std::string text = plyHeader("ascii", mesh.vertices.size(), mesh.triangles.size());
  for (const Vec3& x : mesh.vertices) text += fmt::format("{} {} 255 {}\n", x[0], x[1], x[2]);
  for (const Triangle& t : mesh.triangles) text += fmt::format("3 {} {} {}\n", t[0], t[1], t[2]);
  return text;
}

template <class T>
void append(std::string& bytes, T value) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  bytes.append(raw, sizeof(T));
}

std::string asBinaryPly(const SurfaceMesh& mesh) {
  std::string bytes = plyHeader("binary_little_endian", mesh.vertices.size(), mesh.triangles.size());
  for (const Vec3& x : mesh.vertices) {
    append(bytes, x[0]);
    append(bytes, x[1]);
    append<std::uint8_t>(bytes, 255);
    append(bytes, x[2]);
  }
  for (const Triangle& t : mesh.triangles) {
    append<std::uint8_t>(bytes, 3);
    for (const int i : t) append<std::int32_t>(bytes, i);
  }
  return bytes;
}

struct Format {
  std::string name;
  std::string extension;
  std::string (*write)(const SurfaceMesh&);
  SurfaceMesh (*parse)(std::string_view, const std::string&, MeshPart);
};

const Format formats[] = {{"Off", ".off", asOff, parseOff},
                          {"Obj", ".obj", asObj, parseObj},
                          {"Ply", ".ply", asPly, parsePly},
                          {"BinaryPly", ".ply", asBinaryPly, parsePly}};

class MeshFile : public ::testing::TestWithParam<Format> {};
INSTANTIATE_TEST_SUITE_P(, MeshFile, ::testing::ValuesIn(formats), [](const auto& test) { return test.param.name; });

TEST_P(MeshFile, ReadsBackEveryDigit) {
  const TemporaryFolder folder(::testing::TempDir());
  const auto file = folder.path() / ("mesh" + GetParam().extension);
  writeFile(file, GetParam().write(tetrahedron()));
  const SurfaceMesh mesh = readMeshFile(file);
  EXPECT_EQ(mesh.vertices, tetrahedron().vertices);
  EXPECT_EQ(mesh.triangles, tetrahedron().triangles);
}

/// Whatever the bytes, a reader returns a mesh with indices in range and finite vertices, or throws a runtime_error of
/// one line; under the sanitizers this also shows that no byte outside is read.
void expectMeshOrComplaint(const Format& format, const std::string& bytes) {
  try {
    const SurfaceMesh mesh = format.parse(bytes, "x", MeshPart::Faces);
    for (const Triangle& t : mesh.triangles) {
      for (const int i : t) ASSERT_TRUE(i >= 0 && i < std::ssize(mesh.vertices));
    }
    for (const Vec3& x : mesh.vertices) ASSERT_TRUE(x.allFinite());
  } catch (const std::runtime_error& error) {
    ASSERT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
  }
}

TEST_P(MeshFile, CutShortAnywhereIsNoCrash) {
  const std::string whole = GetParam().write(tetrahedron());
  for (std::size_t length = 0; length < whole.size(); ++length) {
    expectMeshOrComplaint(GetParam(), whole.substr(0, length));
  }
}

TEST_P(MeshFile, ChangedBytesAreNoCrash) {
  const std::string whole = GetParam().write(tetrahedron());
  std::mt19937 random(7);
  for (int trial = 0; trial < 2000; ++trial) {
    std::string bytes = whole;
    for (int i = 0; i < 3; ++i) bytes[random() % bytes.size()] = static_cast<char>(random());
    expectMeshOrComplaint(GetParam(), bytes);
  }
}

std::string complaint(const Format& format, const std::string& bytes) {
  try {
    format.parse(bytes, "mesh", MeshPart::Faces);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(MeshFiles, AHeaderThatClaimsABillionIsRefusedAtOnce) {
  EXPECT_EQ(complaint(formats[0], "OFF\n1000000000 1 0\n0 0 0\n"),
            "mesh:2: 1000000000 vertices: at most 1000000 are read");
  EXPECT_EQ(complaint(formats[2], plyHeader("ascii", 1'000'000'000, 1)),
            "mesh:4: 1000000000 elements 'vertex': 0 to 1000000 are read");
  EXPECT_EQ(complaint(formats[3], plyHeader("binary_little_endian", 4, 3'000'000'000)),
            "mesh:9: 3000000000 elements 'face': 0 to 2000000 are read");
}

TEST(MeshFiles, AHeaderThatClaimsMoreThanTheFileHoldsIsRefusedAtOnce) {
  EXPECT_THAT(complaint(formats[0], "OFF\n900000 1 0\n0 0 0\n"), HasSubstr("do not fit into the 7 bytes that follow"));
  EXPECT_THAT(complaint(formats[3], plyHeader("binary_little_endian", 900'000, 1)), HasSubstr("do not fit into"));
}

TEST(MeshFiles, FaultsAreNamedWithTheirLine) {
  EXPECT_EQ(complaint(formats[0], "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"),
            "mesh:6: a face names vertex 3 (counted from 0); there are 3");
  EXPECT_EQ(complaint(formats[0], "OFF\n3 1 0\n0 0 0\n1 0 nan\n0 1 0\n3 0 1 2\n"),
            "mesh:4: a vertex lies at (1, 0, nan); coordinates are finite and below 1e100");
  EXPECT_EQ(complaint(formats[0], "OFF\n3 1 0\n0 0 0\n1 0 1e200\n0 1 0\n3 0 1 2\n"),
            "mesh:4: a vertex lies at (1, 0, 1e+200); coordinates are finite and below 1e100");
  EXPECT_EQ(complaint(formats[0], "OFF\n3 1 0\n0.000000 0 0\n1.0000 0 0\n"),
            "mesh:4: the file ends after 2 of 3 vertices");
  EXPECT_EQ(complaint(formats[0], "OFF\n3 1 0\n0 0 0\n1 zero 0\n0 1 0\n3 0 1 2\n"), "mesh:4: 'zero' is no number");
  EXPECT_EQ(complaint(formats[1], "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 2\n"),
            "mesh:4: no face that has three different corners");
  EXPECT_EQ(complaint(formats[1], "v 0 0 0\nf 1 0 1\n"), "mesh:2: '0' is no corner of a face; they are counted from 1");
  EXPECT_EQ(complaint(formats[1], "hello\n"), "mesh:1: no face");
  EXPECT_EQ(
      complaint(formats[2], "ply\nformat binary_middle_endian 1.0\nend_header\n"),
      "mesh:2: 'binary_middle_endian' is no format of PLY: ascii, binary_little_endian and binary_big_endian are");
  EXPECT_EQ(complaint(formats[1], "f 1 2 9\nv 0 0 0\nv 1 0 0\nv 0 1 0\n"),
            "mesh:1: a face names vertex 9 (counted from 1); there are 3");
  EXPECT_EQ(complaint(formats[1], "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -1 -2 -4\n"),
            "mesh:4: a face names vertex -4, counted back from its line; 3 stand above it");
  EXPECT_EQ(complaint(formats[1], "v 0 0 0\nv 1 0 0\nl 1 2\n"),
            "mesh:3: only lines and no face: 'shell' and 'lattice' need faces; a 'rope' takes lines");
  EXPECT_EQ(complaint(formats[0], "4OFF\n3 1 0\n"), "mesh:1: '4OFF' is not read; OFF, with ST, C or N before it, is");
  EXPECT_EQ(complaint(formats[2], "solid\n"), "mesh:1: a PLY file begins with the word ply");
}

TEST(MeshFiles, ControlCharactersOfAFileDoNotReachTheTerminal) {
  EXPECT_EQ(complaint(formats[0], "OFF\n3 1 0\n0 0 \x1b[31m\n1 0 0\n0 1 0\n3 0 1 2\n"),
            "mesh:3: '\\x1b[31m' is no number");
}

TEST(MeshFiles, PolygonsAreCutIntoTrianglesAndObjCountsBackwards) {
  const SurfaceMesh mesh = parseObj("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf -4 -3/7 -2//1 -1\n", "mesh");
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
}

TEST(MeshFiles, OtherExtensionsAreRefused) {
  EXPECT_THROW(readMeshFile("a/mesh.stl"), std::runtime_error);
  EXPECT_THROW(readMeshFile("a/missing.off"), std::runtime_error);
}

TEST(Surface, TetrahedronHasItsVolumeAndWindsOnceAboutItsInside) {
  const SurfaceMesh mesh = tetrahedron();
  EXPECT_TRUE(isClosed(mesh));
  EXPECT_NEAR(signedVolume(mesh), 1.0 / 6.0, 1e-15);
  EXPECT_NEAR(windingNumber(mesh, {0.5, 0.2, 0.2}), 1.0, 1e-14);
  EXPECT_NEAR(windingNumber(mesh, {2.0, 0.2, 0.2}), 0.0, 1e-14);
  EXPECT_EQ(edgesOf(mesh.triangles).size(), 6u);
  EXPECT_EQ(hingesOf(mesh.triangles).size(), 6u);
}

TEST(Surface, InsideIsStillInsideWhenATriangleIsMissing) {
  SurfaceMesh mesh = tetrahedron();
  mesh.triangles.pop_back();
  EXPECT_FALSE(isClosed(mesh));
  EXPECT_GT(windingNumber(mesh, {0.4, 0.1, 0.1}), 0.5);
  EXPECT_LT(windingNumber(mesh, {1.5, 1.2, 1.2}), 0.5);
}

TEST(Surface, HingesAreTwoTrianglesWithOppositeSense) {
  const auto hinges = hingesOf({{0, 1, 2}, {1, 0, 3}});
  ASSERT_EQ(hinges.size(), 1u);
  EXPECT_EQ(hinges[0], (std::array<int, 4>{0, 1, 2, 3}));
  EXPECT_TRUE(hingesOf({{0, 1, 2}, {0, 1, 3}}).empty());  // the second faces the other way
}

}  // namespace
}  // namespace muelle::engine
