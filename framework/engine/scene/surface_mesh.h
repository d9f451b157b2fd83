#pragma once
#include "harness/types.h"

#include <array>
#include <vector>

namespace muelle::engine {

using Triangle = std::array<int, 3>;  ///< indices of vertices, anticlockwise seen from outside

using Line = std::array<int, 2>;  ///< indices of its ends, which differ

/// A surface of triangles, or the lines of a rope: a mesh has the one or the other.
struct SurfaceMesh {
  std::vector<Vec3> vertices;  ///< [m]
  std::vector<Triangle> triangles;
  std::vector<Line> lines = {};  ///< each once, in the order of the file
  int facesLeftOut = 0;          ///< faces of the file that have fewer than three different corners
  int linesLeftOut = 0;          ///< lines of the file from a vertex to itself, or that are there already
};

/// The edges of triangles, each once, as pairs of indices with the smaller first, ascending.
std::vector<std::array<int, 2>> edgesOf(const std::vector<Triangle>& triangles);

/// Pairs of triangles with a common edge, as (a, b, c, d): triangles (a, b, c) and (b, a, d). Edges that are not
/// between two triangles of the same sense of rotation are left out.
std::vector<std::array<int, 4>> hingesOf(const std::vector<Triangle>& triangles);

/// Whether every edge lies between two triangles that go along it in opposite directions.
bool isClosed(const SurfaceMesh& mesh);

/// The enclosed volume [m^3], positive when the triangles are anticlockwise seen from outside (closed meshes).
double signedVolume(const SurfaceMesh& mesh);

/// How often the surface winds about the point: the sum of its triangles' solid angles over 4 pi. 1 inside a closed
/// surface, 0 outside; with holes it changes smoothly between, and 1/2 is where the missing patch would be.
/// (Jacobson, Kavan, Sorkine-Hornung 2013; the solid angle after van Oosterom and Strackee 1983.)
double windingNumber(const SurfaceMesh& mesh, const Vec3& point);

}  // namespace muelle::engine
