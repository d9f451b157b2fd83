/// One pyramid (a quad and four triangles: 5 vertices, 6 triangles, 9 edges, volume 1/3) in every dialect of the three
/// formats that programs write.
#include "engine/scene/mesh_file.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

namespace muelle::engine {
namespace {

const std::array<std::array<double, 3>, 5> pyramidPlaces = {
    {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}}};
const std::vector<std::vector<int>> pyramidFaces = {{0, 3, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};

struct Sample {
  std::string name;
  SurfaceMesh (*parse)(std::string_view, const std::string&, MeshPart);
  std::string bytes;
};

void PrintTo(const Sample& sample, std::ostream* stream) { *stream << sample.name; }

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
  return text;
}

/// The text with every end of line, with and without a byte order mark.
void addTexts(std::vector<Sample>& samples, const std::string& name, decltype(Sample::parse) parse,
              const std::string& text) {
  const std::pair<const char*, const char*> ends[] = {{"lf", "\n"}, {"crlf", "\r\n"}, {"cr", "\r"}};
  for (const auto& [called, end] : ends) {
    samples.push_back({name + "_" + called, parse, replaced(text, "\n", end)});
    samples.push_back({name + "_bom_" + called, parse, "\xEF\xBB\xBF" + replaced(text, "\n", end)});
  }
}

std::string vertexLines(const std::string& before, const std::string& behind) {
  std::string text;
  for (const auto& [x, y, z] : pyramidPlaces) text += fmt::format("{}{} {} {}{}\n", before, x, y, z, behind);
  return text;
}

/// Faces with the index as `number` writes it, and `behind` at the end of each line.
template <class Number>
std::string faceLines(bool counts, const std::string& behind, const Number& number) {
  std::string text;
  for (const std::vector<int>& face : pyramidFaces) {
    text += counts ? std::to_string(face.size()) : "f";
    for (const int i : face) text += " " + number(i);
    text += behind + "\n";
  }
  return text;
}

std::string from1(int i) { return std::to_string(i + 1); }
std::string from0(int i) { return std::to_string(i); }

void addObj(std::vector<Sample>& samples) {
  const auto add = [&](const std::string& name, const std::string& text) { addTexts(samples, name, parseObj, text); };
  const std::string v = vertexLines("v ", "");
  add("obj_plain", "# made by a test\no thing\n" + v + "s off\n" + faceLines(false, "", from1));
  add("obj_normals", v + "vn 0 0 1\nvt 0 0\n" + faceLines(false, "", [](int i) { return from1(i) + "/1/1"; }));
  add("obj_backwards", v + faceLines(false, "", [](int i) { return std::to_string(i - 5); }));
  add("obj_faces_first", faceLines(false, "", from1) + v);
  add("obj_joined", v + replaced(faceLines(false, "", from1), "f ", "f \\\n"));
  add("obj_colours", "mtllib none.mtl\n" + vertexLines("v  ", " 0.5 0.5 0.5") + faceLines(false, "  # a face", from1));
  add("obj_closed", v + replaced(faceLines(false, "", from1), "f 1 4 3 2", "f 1 4 3 2 1"));
  add("obj_degenerate", v + "f 1 1 2\nf 3 3 3\nl 1 2\n" + faceLines(false, "", from1));
}

void addOff(std::vector<Sample>& samples) {
  const auto add = [&](const std::string& name, const std::string& text) { addTexts(samples, name, parseOff, text); };
  const std::string f = faceLines(true, "", from0);
  const std::string v = vertexLines("", "");
  add("off_plain", "OFF\n# a comment\n5 5 9\n\n" + v + f);
  add("off_glued", "OFF5 5 0\n" + v + f);
  add("off_one_line", "OFF 5 5 0\n" + v + f);
  add("off_no_word", "5 5 0\n" + v + f);
  add("off_no_edges", "OFF\n5 5\n" + v + f);
  add("off_counts_apart", "OFF\n5\n5\n0\n" + v + f);
  add("off_colours", "COFF\n5 5 0\n" + vertexLines("", " 255 0 0 255") + faceLines(true, " 0.5 0.5 0.5", from0));
  add("off_normals", "NOFF\n5 5 0\n" + vertexLines("", " 0 0 1") + f);
  add("off_texture", "STOFF\n5 5 0\n" + vertexLines("", " 0.5 0.5") + f);
  add("off_all", "STCNOFF\n5 5 0\n" + vertexLines("", " 0 0 1 255 0 0 255 0.5 0.5") + f);
}

std::string plyHeader(const std::string& format, const std::string& faceElement) {
  return fmt::format(
      "ply\nformat {} 1.0\ncomment made by a test\nelement vertex 5\nproperty float x\nproperty float y\n"
      "property float z\n{}end_header\n",
      format, faceElement);
}

const std::string faceElement = "element face 5\nproperty list uchar int vertex_indices\n";
const std::string stripElement = "element tristrips 1\nproperty list int int vertex_indices\n";
/// The sides as 0 1 4 2, 2 3 4 0, the base as 3 2 0 1: every second triangle of a strip is turned.
const std::vector<int> strip = {0, 1, 4, 2, -1, 2, 3, 4, 0, -1, 3, 2, 0, 1};

template <class T>
std::string raw(T value, bool bigEndian) {
  std::string bytes(sizeof(T), '\0');
  std::memcpy(bytes.data(), &value, sizeof(T));
  if (bigEndian) std::ranges::reverse(bytes);
  return bytes;
}

std::string binaryPly(bool bigEndian, bool strips) {
  std::string bytes =
      plyHeader(bigEndian ? "binary_big_endian" : "binary_little_endian", strips ? stripElement : faceElement);
  for (const auto& place : pyramidPlaces) {
    for (const double x : place) bytes += raw(static_cast<float>(x), bigEndian);
  }
  if (strips) {
    bytes += raw(static_cast<std::int32_t>(strip.size()), bigEndian);
    for (const std::int32_t i : strip) bytes += raw(i, bigEndian);
    return bytes;
  }
  for (const std::vector<int>& face : pyramidFaces) {
    bytes += static_cast<char>(face.size());
    for (const std::int32_t i : face) bytes += raw(i, bigEndian);
  }
  return bytes;
}

void addPly(std::vector<Sample>& samples) {
  const std::string v = vertexLines("", "");
  std::string stripLine = std::to_string(strip.size());
  for (const int i : strip) stripLine += " " + std::to_string(i);
  addTexts(samples, "ply_ascii", parsePly, plyHeader("ascii", faceElement) + v + faceLines(true, "", from0));
  addTexts(samples, "ply_strips", parsePly, plyHeader("ascii", stripElement) + v + stripLine + "\n");
  for (const bool strips : {false, true}) {
    samples.push_back({strips ? "ply_little_strips" : "ply_little", parsePly, binaryPly(false, strips)});
    samples.push_back({strips ? "ply_big_strips" : "ply_big", parsePly, binaryPly(true, strips)});
  }
}

std::vector<Sample> samples() {
  std::vector<Sample> all;
  addObj(all);
  addOff(all);
  addPly(all);
  return all;
}

class MeshDialect : public ::testing::TestWithParam<Sample> {};
INSTANTIATE_TEST_SUITE_P(, MeshDialect, ::testing::ValuesIn(samples()),
                         [](const auto& test) { return test.param.name; });

TEST_P(MeshDialect, HoldsThePyramid) {
  const SurfaceMesh mesh = GetParam().parse(GetParam().bytes, "mesh", MeshPart::Faces);
  ASSERT_EQ(mesh.vertices.size(), 5u);
  for (std::size_t i = 0; i < 5; ++i)
    EXPECT_EQ(mesh.vertices[i], Vec3(pyramidPlaces[i][0], pyramidPlaces[i][1], pyramidPlaces[i][2]));
  EXPECT_EQ(mesh.triangles.size(), 6u);
  EXPECT_EQ(edgesOf(mesh.triangles).size(), 9u);
  EXPECT_TRUE(isClosed(mesh));
  EXPECT_NEAR(signedVolume(mesh), 1.0 / 3.0, 1e-15);
  EXPECT_EQ(mesh.facesLeftOut, GetParam().name.starts_with("obj_degenerate") ? 2 : 0);
}

TEST(MeshDialects, AreAtLeastSixty) { EXPECT_GE(samples().size(), 60u); }

TEST(MeshDialects, AByteThatLooksLikeALineEndIsANumberWhereLinesEndWithCr) {
  std::string bytes = replaced(plyHeader("binary_little_endian", faceElement), "\n", "\r");
  const float first = std::bit_cast<float>(0x3f80000au);  // its first byte is an LF
  for (int i = 0; i < 15; ++i) bytes += raw(i == 0 ? first : static_cast<float>(i * i), false);
  for (const std::vector<int>& face : pyramidFaces) {
    bytes += static_cast<char>(face.size());
    for (const std::int32_t i : face) bytes += raw(i, false);
  }
  EXPECT_EQ(parsePly(bytes, "mesh").vertices[0][0], static_cast<double>(first));
}

}  // namespace
}  // namespace muelle::engine
