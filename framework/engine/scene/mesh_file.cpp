#include "engine/scene/mesh_file.h"

#include "base/file.h"
#include "base/text/count.h"
#include "base/text/printable.h"
#include "engine/scene/mesh_text.h"
#include "engine/scene/polygon_list.h"

#include <fmt/format.h>
#include <algorithm>
#include <cctype>
#include <charconv>
#include <stdexcept>

namespace muelle::engine {

namespace {

constexpr std::uintmax_t largestFile = 256u << 20;
constexpr std::size_t mostCorners = 1000;  // of a polygon

Vec3 readVertex(MeshText& text) {
  Vec3 vertex;
  for (int i = 0; i < 3; ++i) vertex[i] = text.number();
  requireFinite(vertex, text);
  return vertex;
}

/// The vertex of an OBJ corner "7", "7/1", "7//3", "-1/..": counted from 1, or backwards from the last. `what` has it:
/// "face" or "line".
std::int64_t objIndex(std::string_view word, std::size_t vertexCount, const MeshText& at, const char* what) {
  const std::string_view text = word.substr(0, word.find('/'));
  std::int64_t index = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), index);
  if (error != std::errc() || end != text.data() + text.size() || index == 0) {
    at.fail(fmt::format("'{}' is no corner of a {}; they are counted from 1", shownWord(word), what));
  }
  if (index < -static_cast<std::int64_t>(vertexCount)) {
    at.fail(fmt::format("a {} names vertex {}, counted back from its line; {} above it", what, index,
                        vertexCount == 1 ? "1 stands" : fmt::format("{} stand", vertexCount)));
  }
  return index > 0 ? index - 1 : static_cast<std::int64_t>(vertexCount) + index;
}

/// The corners of a face or of a line, in what is left of the present line.
void readObjCorners(MeshText& text, std::size_t vertexCount, bool isLine, std::vector<std::int64_t>& corners) {
  const std::size_t most = isLine ? static_cast<std::size_t>(mostVertices) : mostCorners;
  const char* what = isLine ? "line" : "face";
  corners.clear();
  while (text.hasWord()) {
    if (corners.size() == most) text.fail(fmt::format("a {} has more than {} corners", what, most));
    corners.push_back(objIndex(text.word(), vertexCount, text, what));
  }
}

/// Reads "OFF" with its prefixes, be it missing or with the first count at its end, as some collections have it.
void readOffHeader(MeshText& text) {
  if (!text.nextLine('#')) text.fail("the file is empty");
  const std::string_view word = text.word();
  const std::size_t at = word.find("OFF");
  if (at == std::string_view::npos) {
    text.unread(word.size());
    if (word.find_first_not_of("0123456789") != std::string_view::npos) {
      text.fail("an OFF file begins with the word OFF, or with its counts");
    }
    return;
  }
  std::string_view prefix = word.substr(0, at);
  for (const std::string_view known : {"ST", "C", "N"}) {
    if (prefix.starts_with(known)) prefix.remove_prefix(known.size());
  }
  if (!prefix.empty()) {
    text.fail(fmt::format("'{}' is not read; OFF, with ST, C or N before it, is", shownWord(word)));
  }
  const std::string_view behind = word.substr(at + 3);
  text.unread(behind.size());
  if (behind.empty() && text.hasWord()) {
    const std::string_view next = text.word();
    if (next == "BINARY") text.fail("OFF as bytes is not read; save it as text, or as PLY");
    text.unread(next.size());
  }
}

/// The count of edges, which nothing needs: on the line of the others, alone on the next one, or missing.
void skipEdgeCount(MeshText& text) {
  if (!text.hasWord()) {
    MeshText ahead = text;
    if (!ahead.nextLine('#')) return;
    ahead.word();
    if (ahead.hasWord()) return;
    text.nextLine('#');
  }
  text.integer();
}

}  // namespace

SurfaceMesh parseObj(std::string_view bytes, const std::string& name, MeshPart wanted) {
  MeshText text(bytes, name);
  text.joinLines();
  SurfaceMesh mesh;
  PolygonList polygons;
  std::vector<std::int64_t> corners;
  while (text.nextLine('#')) {
    const std::string_view kind = text.word();
    if (kind == "v") {
      if (mesh.vertices.size() >= static_cast<std::size_t>(mostVertices)) {
        text.fail(fmt::format("more than {} vertices; fewer are read", mostVertices));
      }
      mesh.vertices.push_back(readVertex(text));
    } else if (kind == "f" || kind == "fo") {  // "fo": as the first writers called it
      readObjCorners(text, mesh.vertices.size(), false, corners);
      polygons.add(corners, text);
    } else if (kind == "l") {
      corners.clear();
      if (wanted == MeshPart::Lines) readObjCorners(text, mesh.vertices.size(), true, corners);
      polygons.addLine(corners, text);
    }
  }
  polygons.cutInto(mesh, text, 1, wanted);
  return mesh;
}

SurfaceMesh parseOff(std::string_view bytes, const std::string& name, MeshPart wanted) {
  MeshText text(bytes, name);
  readOffHeader(text);
  const std::int64_t vertices = text.integerAnywhere('#');
  const std::int64_t faces = text.integerAnywhere('#');
  skipEdgeCount(text);
  const std::size_t bytesLeft = text.rest().size();
  // The shortest vertex is "0 0 0" and the shortest face "3 0 1 2", each with its end of line.
  const int vertexCount = checkedCount(text, vertices, "vertex", mostVertices, bytesLeft + 1, 6);
  const int faceCount = checkedCount(text, faces, "face", mostFaces, bytesLeft + 1, 4);
  SurfaceMesh mesh;
  mesh.vertices.reserve(static_cast<std::size_t>(vertexCount));
  for (int i = 0; i < vertexCount; ++i) {
    if (!text.nextLine('#'))
      text.fail(fmt::format("the file ends after {} of {}", i, counted(vertexCount, "vertex", "vertices")));
    mesh.vertices.push_back(readVertex(text));
  }
  PolygonList polygons;
  std::vector<std::int64_t> corners;
  for (int i = 0; i < faceCount; ++i) {
    if (!text.nextLine('#')) text.fail(fmt::format("the file ends after {} of {}", i, counted(faceCount, "face")));
    const std::int64_t count = text.integer();
    if (count < 1 || count > static_cast<std::int64_t>(mostCorners)) {
      text.fail(fmt::format("a face has {} corners; up to {} are read", count, mostCorners));
    }
    corners.clear();
    for (std::int64_t j = 0; j < count; ++j) corners.push_back(text.integer());
    polygons.add(corners, text);
  }
  polygons.cutInto(mesh, text, 0, wanted);
  return mesh;
}

SurfaceMesh readMeshFile(const std::filesystem::path& file, MeshPart wanted) {
  std::string extension = file.extension().string();
  std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
  const std::string name = printableLine(file.string());
  if (extension != ".obj" && extension != ".ply" && extension != ".off") {
    throw std::runtime_error(fmt::format("{}: a mesh is a file .obj, .ply or .off", name));
  }
  std::error_code ignored;
  if (std::filesystem::is_regular_file(file) && std::filesystem::file_size(file, ignored) > largestFile) {
    throw std::runtime_error(fmt::format("{}: larger than 256 MiB", name));
  }
  const std::string bytes = readFile(file);
  if (extension == ".obj") return parseObj(bytes, name, wanted);
  return extension == ".ply" ? parsePly(bytes, name, wanted) : parseOff(bytes, name, wanted);
}

}  // namespace muelle::engine
