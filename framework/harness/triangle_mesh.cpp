#include "harness/triangle_mesh.h"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

namespace muelle {

namespace {

std::istringstream withoutComments(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream) throw std::runtime_error(file.string() + ": cannot be read");
  std::string text;
  for (std::string line; std::getline(stream, line);) {
    if (!line.starts_with('#')) text += line + '\n';
  }
  return std::istringstream(text);
}

bool isOfMesh(const std::array<int, 3>& triangle, std::size_t nodes) {
  return std::ranges::all_of(triangle, [nodes](int i) { return i >= 0 && static_cast<std::size_t>(i) < nodes; });
}

}  // namespace

TriangleMesh readTriangleMesh(const std::filesystem::path& file) {
  std::istringstream text = withoutComments(file);
  std::string head;
  std::size_t nodes = 0, triangles = 0, edges = 0;
  if (!(text >> head >> nodes >> triangles >> edges) || head != "OFF") {
    throw std::runtime_error(file.string() + ": begins with no OFF and three numbers");
  }
  TriangleMesh mesh;
  for (Vec3 x; mesh.nodes.size() < nodes && text >> x[0] >> x[1] >> x[2];) mesh.nodes.push_back(x);
  std::array<int, 3> t{};
  for (int corners = 0; mesh.triangles.size() < triangles && text >> corners >> t[0] >> t[1] >> t[2];) {
    if (corners != 3 || !isOfMesh(t, nodes)) throw std::runtime_error(file.string() + ": a face is no triangle of it");
    mesh.triangles.push_back(t);
  }
  const bool isWhole = mesh.nodes.size() == nodes && mesh.triangles.size() == triangles;
  if (!isWhole) throw std::runtime_error(file.string() + ": ends before its last node or triangle");
  return mesh;
}

}  // namespace muelle
