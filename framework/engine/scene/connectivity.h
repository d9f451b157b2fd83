#pragma once
#include "engine/scene/surface_mesh.h"

namespace muelle::engine {

/// How the triangles, or the lines, of a mesh hang together.
struct Connectivity {
  int vertices = 0;  ///< of some triangle or line
  int unused = 0;    ///< of none: as nodes, nothing would hold them
  int places = 0;    ///< where those vertices lie, each place once
  int pieces = 0;    ///< of triangles, or lines, that share vertices
};

Connectivity connectivityOf(const SurfaceMesh& mesh);

/// Takes the vertices out that are of no triangle and no line; the order of the others stays.
void dropUnused(SurfaceMesh& mesh);

/// Makes one vertex of those that lie at exactly the same place, the first of them; triangles and lines that
/// lose a corner by it are left out and counted.
void weld(SurfaceMesh& mesh);

}  // namespace muelle::engine
