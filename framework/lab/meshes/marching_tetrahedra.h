#pragma once
#include "engine/scene/surface_mesh.h"
#include "lab/meshes/implicit_surface.h"

namespace muelle::lab {

/// The surface of a body cut out of the tetrahedra of a grid of `spacing` [m], anticlockwise seen from outside; its
/// triangles are as uneven as the cuts are. Each cell is six tetrahedra about its diagonal, one for each order of the
/// axes (Kuhn): those of neighbours meet, so that the surface is closed whatever the samples are (marching tetrahedra:
/// Doi, Koide 1991).
engine::SurfaceMesh cutSurface(const ImplicitBody& body, double spacing);

}  // namespace muelle::lab
