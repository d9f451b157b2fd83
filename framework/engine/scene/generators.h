#pragma once
#include "engine/model/parts.h"
#include "engine/scene/surface_mesh.h"

#include <string>
#include <vector>

namespace muelle::engine {

/// Nodes that one generator made: consecutive in the model.
struct Part {
  std::string name;
  int firstNode = 0;
  int nodeCount = 0;
  std::vector<Triangle> triangles;  ///< its surface, in the model's numbering; empty: none
  double measure = 0.0;             ///< length [m], area [m^2] or volume [m^3] at rest: mass = density * measure
  std::vector<double> shares = {};  ///< of the mass, one a node, with sum 1; empty: all alike
};

// Each generator takes the name of what it makes. Its springs are the model's part "NAME.structural"; what a key adds
// is the part named after the first word of the key: "NAME.shear" of shear_stiffness, and so "NAME.bend", "NAME.angle",
// "NAME.dihedral", "NAME.area", "NAME.bulk"; of a lattice also "NAME.lattice" and "NAME.ties".

/// What the springs of a generator are made of.
struct SpringMaterial {
  double k = 100.0;  ///< [N/m] of each spring
  double dRelative = 0.0;
  double dProjected = 0.0;  ///< [kg/s]
  bool rod = false;         ///< of constant length: k does not count (ModelSpring::rod)
};

/// n nodes from one point to another, a spring between neighbours.
struct ChainShape {
  int n = 2;  ///< at least 2
  Vec3 from = Vec3::Zero();
  Vec3 to = Vec3::UnitX();
  double L0 = 0.0;   ///< rest length of each spring [m]; 0: at rest where the nodes are
  double sag = 0.0;  ///< [m] the middle starts so much lower, the chain along a parabola
  SpringMaterial spring = {};
  bool unilateral = false;      ///< the springs only push: blocks on each other
  double angleStiffness = 0.0;  ///< [J/rad^2] of every inner node; 0: none
};
Part addChain(Model& model, const ChainShape& shape, const std::string& name = "chain");

/// A rope, or a net of ropes: a node at each vertex, a spring along each line, at rest where they are.
struct RopeShape {
  SurfaceMesh mesh;  ///< its lines; in a scene of dimension 2 they lie in a plane parallel to the scene's
  SpringMaterial spring = {};
  bool unilateral = false;      ///< the springs only push
  double angleStiffness = 0.0;  ///< [J/rad^2] of every node between two lines, straight at rest; 0: none
};
/// Each node has half of the length of its lines as its share of the mass. Throws std::invalid_argument when a line has
/// length 0, when the lines leave the plane of a 2D scene, and in 1D.
Part addRope(Model& model, const RopeShape& shape, const std::string& name = "rope");

/// nu by nv nodes in a plane; node (i, j) has index j * nu + i within the part (as in the harness's grid).
struct GridShape {
  int nu = 2, nv = 2;  ///< at least 2 each
  Vec3 origin = Vec3::Zero();
  Vec3 across = Vec3::UnitX();     ///< unit vector along i
  Vec3 along = Vec3::UnitY();      ///< unit vector along j
  double spacing = 0.1;            ///< [m]
  SpringMaterial structural = {};  ///< rods leave shear and bend what they are, springs
  double shearStiffness = 0.0;     ///< [N/m] of both diagonals of each cell; 0: none
  double bendStiffness = 0.0;      ///< [N/m] of springs over two cells in both directions; 0: none
  double dihedralStiffness = 0.0;  ///< [J/rad^2] of each edge between two triangles; 0: none (3D only)
  double areaModulus = 0.0;        ///< [N/m] E = K A0/2 (A/A0 - 1)^2 of each of the two triangles of a cell; 0: none
};
Part addGrid(Model& model, const GridShape& shape, const std::string& name = "grid");

/// nx by ny by nz cells, each cut into five tetrahedra (mirrored from cell to cell, so that the diagonals of
/// neighbours meet), a spring along every edge. 3D only.
struct BoxShape {
  int nx = 1, ny = 1, nz = 1;
  Vec3 centre = Vec3::Zero();
  Vec3 size = Vec3::Ones();  ///< [m]
  SpringMaterial spring = {};
  double bulkModulus = 0.0;  ///< [Pa] E = K V0/2 (V/V0 - 1)^2 of each tetrahedron; 0: none
};
Part addBox(Model& model, const BoxShape& shape, const std::string& name = "box");

/// A surface as a shell: a node at each vertex, a spring along each edge. 3D only.
struct ShellShape {
  SurfaceMesh mesh;
  SpringMaterial spring = {};
};
Part addShell(Model& model, const ShellShape& shape, const std::string& name = "shell");

/// A solid: the shell, and inside it the nodes of a cubic lattice, each joined to its up to 26 neighbours in the
/// lattice; every vertex is tied to the inner nodes nearest to it. 3D only.
struct LatticeShape {
  SurfaceMesh mesh;      ///< holes are no harm: inside is where the surface winds about a point more than half
  double spacing = 0.1;  ///< [m] of the lattice
  int ties = 4;          ///< springs from each vertex to inner nodes
  SpringMaterial spring = {};
};
/// The part's measure is the volume of the surface; first come its vertices, then the inner nodes.
/// Throws std::invalid_argument when no lattice node lies inside, or the solid is in pieces.
Part addLattice(Model& model, const LatticeShape& shape, const std::string& name = "lattice");

/// Gives each node of the part its share of M, else M / n (slide "Masa/Inercia"), scaled in a geometric sequence so
/// that the last has `taper` times the mass of the first; the sum is M.
void lumpMass(Model& model, const Part& part, double M, double taper = 1.0);

/// Gives every spring of the part the damping ratio in place of a projected damping (projectedDamping()).
void setDampingRatio(Model& model, const Part& part, double ratio);

}  // namespace muelle::engine
