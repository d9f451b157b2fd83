#pragma once
#include "engine/scene/surface_mesh.h"

namespace muelle::lab {

// Passes over a closed surface that make its triangles more even (Botsch, Kobbelt 2004).

/// Puts a vertex into the middle of edges longer than `most` [m]; each triangle is parted at most once in one pass.
void splitLongEdges(engine::SurfaceMesh& mesh, double most);

/// Makes one vertex of the ends of edges shorter than `least` [m] where no edge becomes longer than `most` and no
/// triangle turns away; near one that has gone none goes in the same pass.
void mergeShortEdges(engine::SurfaceMesh& mesh, double least, double most);

/// Turns edges towards six at each vertex.
void evenValences(engine::SurfaceMesh& mesh);

/// Turns edges towards the larger of the smallest angles (Delaunay).
void openAngles(engine::SurfaceMesh& mesh);

}  // namespace muelle::lab
