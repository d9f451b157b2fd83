#pragma once
/// \file
/// Exercise mesh_to_springs: the nodes, springs and masses of a mesh. Implement these functions in mesh_to_springs.cpp;
/// README.md has the mathematics. (Slides "Masa-Muelle: Propiedades" and "Mallado".)
///
/// Units are SI: positions and lengths [m], masses [kg]. Nodes are numbered from 0. Coordinates lie between -1000 m and
/// 1000 m; no side of a triangle is shorter than 0.001 m and no angle in it smaller than 5 degrees. All indices are
/// those of nodes that are there, and the nodes of a triangle, or of an edge, are different ones: nothing else is
/// passed, so nothing else needs a check. Between which numbers the others lie is stated below. Numbers are double, and
/// answers exact to its round-off.

#include "harness/exercise.h"

#include <Eigen/Geometry>  // a.cross(b)

using muelle::Vec3;

/// The numbers of the three nodes of a triangle, from any of them, either way round.
using Triangle = std::array<int, 3>;

/// The numbers of the two nodes of an edge, the smaller one first: edge[0] < edge[1]. Two edges can be compared with
/// == and <, so that std::sort(edges.begin(), edges.end()) puts a list in order.
using Edge = std::array<int, 2>;

MUELLE_RANGE(triangles, 0, 5000)  // so many
MUELLE_RANGE(nodes, 0, 2500)      // so many
MUELLE_RANGE(edges, 0, 7500)      // so many
MUELLE_RANGE(rows, 1, 40)         // nodes in a column (a count, dimensionless)
MUELLE_RANGE(columns, 1, 40)      // nodes in a row (a count, dimensionless)
MUELLE_RANGE(M, 1e-6, 1e6)        // kg
MUELLE_RANGE(n, 1, 2500)          // nodes
MUELLE_RANGE(density, 1e-6, 1e6)  // kg/m^2

// Every list of edges below has one order, the one of std::sort: by the first node, and where that is the same by the
// second. So there is one right answer, and the edge number s is the same for everybody.

/// The edges (pairs of indices, dimensionless) of a triangle mesh, each once, however many triangles have it: one at
/// the border, two inside, or more. No triangles, no edges.
///
/// \param triangles in any order; neighbours need not go the same way round
std::vector<Edge> meshEdges(const std::vector<Triangle>& triangles);

// A grid of rows times columns nodes is numbered row by row: row i, column j has the number i * columns + j, both
// counted from 0. A grid that is too small for a kind of spring has none of it.

/// Structural springs of a grid, as edges (dimensionless): between neighbours in a row and between neighbours in a
/// column. \param rows, columns  how many nodes (dimensionless)
std::vector<Edge> structuralSprings(int rows, int columns);

/// Shear springs of a grid, as edges (dimensionless): both diagonals of each cell.
std::vector<Edge> shearSprings(int rows, int columns);

/// Bending springs of a grid, as edges (dimensionless): between each node and the next but one in its row and in its
/// column.
std::vector<Edge> bendingSprings(int rows, int columns);

/// Rest lengths [m] of springs that are at rest where the nodes are: entry s is the length of edges[s].
///
/// \param nodes positions of the nodes [m]; the nodes of an edge may coincide: its length is 0 then
/// \param edges one spring each, in any order
std::vector<double> restLengths(const std::vector<Vec3>& nodes, const std::vector<Edge>& edges);

/// Masses [kg] of n nodes that share the mass M equally: the lecture's m = M/n.
///
/// \param M mass of the whole body [kg]   \param n how many nodes
std::vector<double> equalMasses(double M, int n);

/// Masses [kg] of the nodes of a surface: each triangle weighs its area times the density, and gives a third of that to
/// each of its nodes. A node that is in no triangle has the mass 0.
///
/// \param nodes positions of the nodes [m]; as many masses are returned
/// \param triangles of the surface
/// \param density mass of the surface by its area [kg/m^2]
std::vector<double> massesByArea(const std::vector<Vec3>& nodes, const std::vector<Triangle>& triangles,
                                 double density);

MUELLE_FUNCTIONS(meshEdges, structuralSprings, shearSprings, bendingSprings, restLengths, equalMasses, massesByArea)
