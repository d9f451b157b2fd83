#pragma once
#include "engine/scene/mesh_text.h"

#include <cstdint>
#include <vector>

namespace muelle::engine {

/// The faces of a file as they stand there, until all vertices are known: a file may name a vertex before it gives it.
class PolygonList {
 public:
  /// Complains when the faces make more triangles than are read.
  void add(const std::vector<std::int64_t>& corners, const MeshText& at);

  /// Cuts all faces into triangles of the mesh and counts those that are left out for want of three different corners.
  /// Complains, with the face's line, of a corner that is no vertex, and when there is no triangle at all.
  /// \param counted from 0 or 1, as messages tell a vertex's number   \param hasLines the file has lines, too
  void cutInto(SurfaceMesh& mesh, const MeshText& at, int counted, bool hasLines = false) const;

 private:
  struct Polygon {
    std::size_t end = 0;  ///< of its corners
    int line = 0;
  };
  std::vector<std::int64_t> corners_;
  std::vector<Polygon> polygons_;
};

}  // namespace muelle::engine
