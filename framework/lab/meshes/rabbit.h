#pragma once
#include "lab/meshes/implicit_surface.h"

#include <string>

namespace muelle::lab {

/// A rabbit that sits: ellipsoids that melt into each other, [m], its head towards +x, z up, its soles flat at z = 0,
/// `rabbitHeight` high. One ear stands, the other one leans back, so that both are seen from the side.
ImplicitBody rabbitBody();
constexpr double rabbitHeight = 0.19;

/// Its surface, closed, 1,500 to 2,500 vertices: exercises/mesh_to_springs/rabbit.off is this, and a test keeps it so.
engine::SurfaceMesh rabbitMesh();

/// A surface as the text of an OFF file, coordinates rounded to 1e-5 m. `title` is its comment.
std::string offText(const engine::SurfaceMesh& mesh, const std::string& title);

}  // namespace muelle::lab
