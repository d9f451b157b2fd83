#pragma once
#include "harness/types.h"

#include <array>
#include <filesystem>
#include <vector>

namespace muelle {

/// A surface of triangles, as data: where its nodes are, and which three of them each triangle has, by index from 0,
/// anticlockwise seen from outside. What its edges, springs and masses are is an exercise, so nothing here tells.
struct TriangleMesh {
  std::vector<Vec3> nodes;  ///< [m]
  std::vector<std::array<int, 3>> triangles;
};

/// Reads a plain OFF file: the word, lines that begin with # (left out), the numbers of nodes, triangles and edges, the
/// nodes, and the triangles as "3 a b c". No more than that on purpose: it is for the meshes that the course hands out,
/// and short enough to be read. What other programs write (polygons, prefixes, other formats, a million vertices) is
/// the reader's of the scenes, which students do not get. Throws std::runtime_error "FILE: what is wrong".
TriangleMesh readTriangleMesh(const std::filesystem::path& file);

}  // namespace muelle
