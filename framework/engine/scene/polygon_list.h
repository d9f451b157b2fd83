#pragma once
#include "engine/scene/mesh_file.h"
#include "engine/scene/mesh_text.h"

#include <cstdint>
#include <vector>

namespace muelle::engine {

/// The faces and lines of a file as they stand there, until all vertices are known: a file may name a vertex before it
/// gives it.
class PolygonList {
 public:
  /// Complains when the faces make more triangles than are read.
  void add(const std::vector<std::int64_t>& corners, const MeshText& at) { add(corners, at, false); }
  /// A line from corner to corner, open.
  void addLine(const std::vector<std::int64_t>& corners, const MeshText& at) { add(corners, at, true); }

  /// Gives the mesh what is wanted: all faces cut into triangles, or the lines, of which a face of two corners is one;
  /// and counts what is left out. Complains, with its line in the file, of a corner that is no vertex, and when there
  /// is none of what is wanted.
  /// \param counted from 0 or 1, as messages tell a vertex's number
  void cutInto(SurfaceMesh& mesh, const MeshText& at, int counted, MeshPart wanted) const;

 private:
  struct Polygon {
    std::size_t end = 0;  ///< of its corners
    int line = 0;         ///< of the file
    bool isLine = false;
  };
  void add(const std::vector<std::int64_t>& corners, const MeshText& at, bool isLine);
  std::vector<int> checkedCorners(const Polygon& polygon, std::size_t begin, std::int64_t count, const MeshText& at,
                                  int counted) const;

  std::vector<std::int64_t> corners_;
  std::vector<Polygon> polygons_;
};

}  // namespace muelle::engine
