#include "engine/scene/mesh_file.h"

#include "base/file.h"
#include "base/toml/value.h"
#include "engine/scene/mesh_text.h"

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

/// The vertex of an OBJ corner "7", "7/1", "7//3", "-1/..": counted from 1, or backwards from the last.
std::int64_t objIndex(std::string_view word, std::size_t vertexCount, const MeshText& at) {
  const std::string_view text = word.substr(0, word.find('/'));
  std::int64_t index = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), index);
  if (error != std::errc() || end != text.data() + text.size() || index == 0) {
    at.fail(fmt::format("'{}' is no corner of a face; they are counted from 1", shownWord(word)));
  }
  return index > 0 ? index - 1 : static_cast<std::int64_t>(vertexCount) + index;
}

}  // namespace

SurfaceMesh parseObj(std::string_view bytes, const std::string& name) {
  MeshText text(bytes, name);
  SurfaceMesh mesh;
  std::vector<std::int64_t> corners;
  while (text.nextLine('#')) {
    const std::string_view kind = text.word();
    if (kind == "v") {
      if (mesh.vertices.size() >= static_cast<std::size_t>(mostVertices)) {
        text.fail(fmt::format("more than {} vertices; fewer are read", mostVertices));
      }
      mesh.vertices.push_back(readVertex(text));
    } else if (kind == "f") {
      corners.clear();
      while (text.hasWord()) {
        if (corners.size() == mostCorners) text.fail(fmt::format("a face has more than {} corners", mostCorners));
        corners.push_back(objIndex(text.word(), mesh.vertices.size(), text));
      }
      // A face may only name vertices above it: every OBJ writer keeps to that, and it needs no second pass.
      addPolygon(mesh, corners, static_cast<std::int64_t>(mesh.vertices.size()), text);
    }
  }
  if (mesh.triangles.empty()) text.fail("no face; is this an OBJ file?");
  return mesh;
}

SurfaceMesh parseOff(std::string_view bytes, const std::string& name) {
  MeshText text(bytes, name);
  if (!text.nextLine('#') || text.word() != "OFF") text.fail("an OFF file begins with the word OFF");
  const std::int64_t vertices = text.integerAnywhere('#');
  const std::int64_t faces = text.integerAnywhere('#');
  text.integerAnywhere('#');  // edges: often 0, never needed
  const std::size_t bytesLeft = text.rest().size();
  // The shortest vertex is "0 0 0" and the shortest face "3 0 1 2", each with its end of line.
  const int vertexCount = checkedCount(text, vertices, "vertices", mostVertices, bytesLeft + 1, 6);
  const int faceCount = checkedCount(text, faces, "faces", mostFaces, bytesLeft + 1, 8);
  SurfaceMesh mesh;
  mesh.vertices.reserve(static_cast<std::size_t>(vertexCount));
  for (int i = 0; i < vertexCount; ++i) {
    if (!text.nextLine('#')) text.fail(fmt::format("the file ends after {} of {} vertices", i, vertexCount));
    mesh.vertices.push_back(readVertex(text));
  }
  std::vector<std::int64_t> corners;
  for (int i = 0; i < faceCount; ++i) {
    if (!text.nextLine('#')) text.fail(fmt::format("the file ends after {} of {} faces", i, faceCount));
    const std::int64_t count = text.integer();
    if (count < 3 || count > static_cast<std::int64_t>(mostCorners)) {
      text.fail(fmt::format("a face has {} corners; 3 to {} are read", count, mostCorners));
    }
    corners.clear();
    for (std::int64_t j = 0; j < count; ++j) corners.push_back(text.integer());
    addPolygon(mesh, corners, vertexCount, text);
  }
  if (mesh.triangles.empty()) text.fail("no face");
  return mesh;
}

SurfaceMesh readMeshFile(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
  const std::string name = shownPath(file);
  if (extension != ".obj" && extension != ".ply" && extension != ".off") {
    throw std::runtime_error(fmt::format("{}: a mesh is a file .obj, .ply or .off", name));
  }
  std::error_code ignored;
  if (std::filesystem::is_regular_file(file) && std::filesystem::file_size(file, ignored) > largestFile) {
    throw std::runtime_error(fmt::format("{}: larger than 256 MiB", name));
  }
  const std::string bytes = readFile(file);
  if (extension == ".obj") return parseObj(bytes, name);
  return extension == ".ply" ? parsePly(bytes, name) : parseOff(bytes, name);
}

}  // namespace muelle::engine
