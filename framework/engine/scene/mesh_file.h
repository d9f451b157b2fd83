#pragma once
#include "engine/scene/surface_mesh.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace muelle::engine {

/// What a mesh file may hold at most; a header that claims more is refused before anything is allocated.
constexpr int mostVertices = 1'000'000;
constexpr int mostFaces = 2'000'000;

/// What is wanted of a mesh file; the other one is left out.
enum class MeshPart {
  Faces,  ///< the surface
  Lines,  ///< OBJ's "l", PLY's edges, faces of two corners
};

/// Reads a surface from a file, by its extension: .obj, .ply (ascii and binary of both byte orders, triangle strips,
/// too), .off (with any of the prefixes ST, C, N, or without its first word). Polygons are cut into triangles
/// (polygon.h); normals, colours and other properties are skipped; faces with fewer than three different corners are
/// left out and counted. Of lines each is kept once; those from a vertex to itself are left out and counted.
///
/// Throws std::runtime_error "FILE:LINE: what is wrong" (binary: the header's last line): counts beyond the limits,
/// indices out of range, coordinates that are not finite, files that end too early, other formats, files without what
/// is wanted.
SurfaceMesh readMeshFile(const std::filesystem::path& file, MeshPart wanted = MeshPart::Faces);

/// The formats alone, from text in memory; `name` is how messages call it.
SurfaceMesh parseObj(std::string_view text, const std::string& name, MeshPart wanted = MeshPart::Faces);
SurfaceMesh parsePly(std::string_view bytes, const std::string& name, MeshPart wanted = MeshPart::Faces);
SurfaceMesh parseOff(std::string_view text, const std::string& name, MeshPart wanted = MeshPart::Faces);

}  // namespace muelle::engine
