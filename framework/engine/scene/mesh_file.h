#pragma once
#include "engine/scene/surface_mesh.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace muelle::engine {

/// What a mesh file may hold at most; a header that claims more is refused before anything is allocated.
constexpr int mostVertices = 1'000'000;
constexpr int mostFaces = 2'000'000;

/// Reads a surface from a file, by its extension: .obj, .ply (ascii and binary of both byte orders, triangle strips,
/// too), .off (with any of the prefixes ST, C, N, or without its first word). Polygons are cut into triangles
/// (polygon.h); normals, colours and other properties are skipped; faces with fewer than three different corners are
/// left out and counted.
///
/// Throws std::runtime_error "FILE:LINE: what is wrong" (binary: the header's last line): counts beyond the limits,
/// indices out of range, coordinates that are not finite, files that end too early, other formats.
SurfaceMesh readMeshFile(const std::filesystem::path& file);

/// The formats alone, from text in memory; `name` is how messages call it.
SurfaceMesh parseObj(std::string_view text, const std::string& name);
SurfaceMesh parsePly(std::string_view bytes, const std::string& name);
SurfaceMesh parseOff(std::string_view text, const std::string& name);

}  // namespace muelle::engine
