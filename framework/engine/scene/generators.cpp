#include "engine/scene/generators.h"

#include "base/text/count.h"
#include "engine/model/axes.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <Eigen/Geometry>
#include <numeric>
#include <stdexcept>

namespace muelle::engine {

namespace {

constexpr std::size_t mostNodes = 2'000'000;  // of a model

const Vec3& positionOf(const Model& model, int node) { return model.nodes[static_cast<std::size_t>(node)].x; }

/// The nodes of a new part.
Part beginPart(Model& model, const std::string& name, std::size_t count) {
  if (model.nodes.size() + count > mostNodes) {
    throw std::invalid_argument(fmt::format("{} nodes; at most {} are built", model.nodes.size() + count, mostNodes));
  }
  Part part;
  part.name = name;
  part.firstNode = static_cast<int>(model.nodes.size());
  part.nodeCount = static_cast<int>(count);
  model.nodes.reserve(model.nodes.size() + count);
  return part;
}

void addNode(Model& model, const Vec3& x) {
  ModelNode node;
  node.x = x;
  model.nodes.push_back(node);
}

int partOf(Model& model, const Part& part, const char* what) { return partNamed(model, part.name + "." + what); }

/// A spring at rest where its nodes are.
void connect(Model& model, int a, int b, const SpringMaterial& material, int part) {
  ModelSpring spring;
  spring.part = part;
  spring.a = a;
  spring.b = b;
  spring.rod = material.rod;
  if (!material.rod) spring.k = material.k;
  spring.L0 = (positionOf(model, a) - positionOf(model, b)).norm();
  spring.dRelative = material.dRelative;
  spring.dProjected = material.dProjected;
  model.springs.push_back(spring);
}

SpringMaterial withStiffness(SpringMaterial material, double k) {
  material.k = k;
  material.rod = false;
  return material;
}

Vec3 up(const Model& model) { return Vec3::Unit(upAxisOf(model)); }

void requireSpace(const Model& model, const char* what) {
  if (model.dimension != 3) throw std::invalid_argument(fmt::format("{} needs a scene of dimension 3", what));
}

/// An area that wants to be as it is, seen along its own normal.
void addArea(Model& model, const Triangle& t, double modulus, int part) {
  ModelArea area{.nodes = t, .part = part};
  if (model.dimension == 3) area.normal = area.normalIn(model);
  area.A0 = area.areaIn(model);
  area.k = modulus / std::abs(area.A0);
  model.areas.push_back(area);
}

void addVolume(Model& model, const std::array<int, 4>& t, double modulus, int part) {
  ModelVolume volume{.nodes = t, .part = part};
  volume.V0 = volume.volumeIn(model);
  volume.k = modulus / std::abs(volume.V0);
  model.volumes.push_back(volume);
}

/// The triangles of a grid, anticlockwise seen from across x along.
std::vector<Triangle> gridTriangles(int firstNode, int nu, int nv) {
  std::vector<Triangle> triangles;
  for (int j = 0; j + 1 < nv; ++j) {
    for (int i = 0; i + 1 < nu; ++i) {
      const int q = firstNode + j * nu + i;
      triangles.push_back({q, q + 1, q + nu + 1});
      triangles.push_back({q, q + nu + 1, q + nu});
    }
  }
  return triangles;
}

void addGridSprings(Model& model, const Part& part, const GridShape& shape) {
  const auto node = [&](int i, int j) { return part.firstNode + j * shape.nu + i; };
  const int structuralPart = partOf(model, part, "structural");
  for (int j = 0; j < shape.nv; ++j) {
    for (int i = 0; i < shape.nu; ++i) {
      if (i + 1 < shape.nu) connect(model, node(i, j), node(i + 1, j), shape.structural, structuralPart);
      if (j + 1 < shape.nv) connect(model, node(i, j), node(i, j + 1), shape.structural, structuralPart);
    }
  }
  const SpringMaterial shear = withStiffness(shape.structural, shape.shearStiffness);
  const int shearPart = shear.k > 0.0 ? partOf(model, part, "shear") : partOfItsKind;
  for (int j = 0; j + 1 < shape.nv && shear.k > 0.0; ++j) {
    for (int i = 0; i + 1 < shape.nu; ++i) {
      connect(model, node(i, j), node(i + 1, j + 1), shear, shearPart);
      connect(model, node(i + 1, j), node(i, j + 1), shear, shearPart);
    }
  }
  const SpringMaterial bend = withStiffness(shape.structural, shape.bendStiffness);
  const int bendPart = bend.k > 0.0 ? partOf(model, part, "bend") : partOfItsKind;
  for (int j = 0; j < shape.nv && bend.k > 0.0; ++j) {
    for (int i = 0; i < shape.nu; ++i) {
      if (i + 2 < shape.nu) connect(model, node(i, j), node(i + 2, j), bend, bendPart);
      if (j + 2 < shape.nv) connect(model, node(i, j), node(i, j + 2), bend, bendPart);
    }
  }
}

/// The five tetrahedra of a cell, corners numbered x + 2 y + 4 z; positive volumes. The mirrored kind has the
/// diagonals of its faces the other way.
constexpr std::array<std::array<int, 4>, 5> evenCell = {{
    {0, 1, 2, 4},
    {1, 3, 2, 7},
    {1, 7, 4, 5},
    {2, 4, 7, 6},
    {1, 2, 4, 7},
}};
constexpr std::array<std::array<int, 4>, 5> oddCell = {{
    {1, 3, 0, 5},
    {0, 3, 2, 6},
    {0, 5, 6, 4},
    {3, 6, 5, 7},
    {0, 3, 6, 5},
}};

std::vector<std::array<int, 4>> boxTetrahedra(const BoxShape& shape, int firstNode) {
  const auto node = [&](int i, int j, int k) { return firstNode + (k * (shape.ny + 1) + j) * (shape.nx + 1) + i; };
  std::vector<std::array<int, 4>> tetrahedra;
  for (int k = 0; k < shape.nz; ++k) {
    for (int j = 0; j < shape.ny; ++j) {
      for (int i = 0; i < shape.nx; ++i) {
        for (const auto& corners : (i + j + k) % 2 == 0 ? evenCell : oddCell) {
          std::array<int, 4> t{};
          for (std::size_t c = 0; c < 4; ++c) {
            t[c] = node(i + (corners[c] & 1), j + (corners[c] >> 1 & 1), k + (corners[c] >> 2));
          }
          tetrahedra.push_back(t);
        }
      }
    }
  }
  return tetrahedra;
}

/// The faces of tetrahedra that belong to one of them alone, anticlockwise seen from outside.
std::vector<Triangle> outerFaces(const std::vector<std::array<int, 4>>& tetrahedra) {
  struct Face {
    Triangle sorted;
    Triangle face;
  };
  std::vector<Face> faces;
  for (const auto& [a, b, c, d] : tetrahedra) {
    for (const Triangle& face : {Triangle{a, c, b}, Triangle{a, b, d}, Triangle{a, d, c}, Triangle{b, c, d}}) {
      Triangle sorted = face;
      std::ranges::sort(sorted);
      faces.push_back({sorted, face});
    }
  }
  std::ranges::sort(faces, {}, &Face::sorted);
  std::vector<Triangle> outer;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const bool twin = (i > 0 && faces[i - 1].sorted == faces[i].sorted) ||
                      (i + 1 < faces.size() && faces[i + 1].sorted == faces[i].sorted);
    if (!twin) outer.push_back(faces[i].face);
  }
  return outer;
}

void connectTetrahedra(Model& model, const std::vector<std::array<int, 4>>& tetrahedra, const SpringMaterial& material,
                       int part) {
  std::vector<std::array<int, 2>> edges;
  for (const auto& t : tetrahedra) {
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = i + 1; j < 4; ++j) edges.push_back({std::min(t[i], t[j]), std::max(t[i], t[j])});
    }
  }
  std::ranges::sort(edges);
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  for (const auto& [a, b] : edges) connect(model, a, b, material, part);
}

/// Straightens every node that lies between two lines and no more.
void addAngles(Model& model, const Part& part, const SurfaceMesh& mesh, double stiffness) {
  const int firstNode = part.firstNode, angles = partOf(model, part, "angle");
  std::vector<std::vector<int>> neighbours(mesh.vertices.size());
  for (const auto& [a, b] : mesh.lines) {
    neighbours[static_cast<std::size_t>(a)].push_back(firstNode + b);
    neighbours[static_cast<std::size_t>(b)].push_back(firstNode + a);
  }
  for (std::size_t i = 0; i < neighbours.size(); ++i) {
    if (neighbours[i].size() != 2) continue;
    model.angles.push_back(
        {{neighbours[i][0], firstNode + static_cast<int>(i), neighbours[i][1]}, stiffness, 0.0, angles});
  }
}

/// Throws when the vertices do not lie in a plane parallel to that of a 2D scene.
void requireFlat(const Model& model, const SurfaceMesh& mesh) {
  if (model.dimension == 1) throw std::invalid_argument("a rope needs a scene of dimension 2 or 3");
  if (model.dimension == 3) return;
  const int across = 3 - model.plane[0] - model.plane[1];
  const Vec3& first = mesh.vertices.front();
  for (const Vec3& x : mesh.vertices) {
    if (std::abs(x[across] - first[across]) <= 1e-9 * (x - first).norm()) continue;
    throw std::invalid_argument(
        "the rope's lines leave the plane of the scene; give dimension = 3, or another 'plane'");
  }
}

double areaOf(const SurfaceMesh& mesh) {
  double area = 0.0;
  for (const Triangle& t : mesh.triangles) {
    const Vec3& a = mesh.vertices[static_cast<std::size_t>(t[0])];
    const Vec3& b = mesh.vertices[static_cast<std::size_t>(t[1])];
    const Vec3& c = mesh.vertices[static_cast<std::size_t>(t[2])];
    area += 0.5 * (b - a).cross(c - a).norm();
  }
  return area;
}

}  // namespace

Part addChain(Model& model, const ChainShape& shape, const std::string& name) {
  if (shape.n < 2)
    throw std::invalid_argument(fmt::format("a chain of {}; at least 2 are needed", counted(shape.n, "node")));
  if (!((shape.to - shape.from).norm() > 0.0)) throw std::invalid_argument("a chain begins and ends at one point");
  Part part = beginPart(model, name, static_cast<std::size_t>(shape.n));
  for (int i = 0; i < shape.n; ++i) {
    const double s = static_cast<double>(i) / (shape.n - 1);
    addNode(model, (1.0 - s) * shape.from + s * shape.to - 4.0 * shape.sag * s * (1.0 - s) * up(model));
  }
  const int springs = partOf(model, part, "structural");
  for (int i = 0; i + 1 < shape.n; ++i) {
    connect(model, part.firstNode + i, part.firstNode + i + 1, shape.spring, springs);
    if (shape.L0 > 0.0) model.springs.back().L0 = shape.L0;
    model.springs.back().unilateral = shape.unilateral;
  }
  const int angles = shape.angleStiffness > 0.0 && shape.n > 2 ? partOf(model, part, "angle") : partOfItsKind;
  for (int i = part.firstNode; i + 2 < part.firstNode + shape.n && shape.angleStiffness > 0.0; ++i) {
    model.angles.push_back({{i, i + 1, i + 2}, shape.angleStiffness, 0.0, angles});
  }
  part.measure = (shape.to - shape.from).norm();
  return part;
}

Part addRope(Model& model, const RopeShape& shape, const std::string& name) {
  requireFlat(model, shape.mesh);
  Part part = beginPart(model, name, shape.mesh.vertices.size());
  for (const Vec3& x : shape.mesh.vertices) addNode(model, x);
  part.shares.assign(shape.mesh.vertices.size(), 0.0);
  const int springs = partOf(model, part, "structural");
  for (const auto& [a, b] : shape.mesh.lines) {
    connect(model, part.firstNode + a, part.firstNode + b, shape.spring, springs);
    model.springs.back().unilateral = shape.unilateral;
    const double L = model.springs.back().L0;
    if (!(L > 0.0)) {
      throw std::invalid_argument(fmt::format(
          "the line between vertices {} and {} (counted from 0) has length 0; weld = true makes one node of them", a,
          b));
    }
    part.measure += L;
    part.shares[static_cast<std::size_t>(a)] += 0.5 * L;
    part.shares[static_cast<std::size_t>(b)] += 0.5 * L;
  }
  for (double& share : part.shares) share /= part.measure;
  if (shape.angleStiffness > 0.0) addAngles(model, part, shape.mesh, shape.angleStiffness);
  return part;
}

Part addGrid(Model& model, const GridShape& shape, const std::string& name) {
  if (shape.nu < 2 || shape.nv < 2) {
    throw std::invalid_argument(fmt::format("a grid of {} x {} nodes; at least 2 x 2", shape.nu, shape.nv));
  }
  if (model.dimension == 1) throw std::invalid_argument("a grid needs a scene of dimension 2 or 3");
  if (!(shape.across.cross(shape.along).norm() > 1e-9)) {
    throw std::invalid_argument("a grid's directions across and along are parallel");
  }
  Part part = beginPart(model, name, static_cast<std::size_t>(shape.nu) * static_cast<std::size_t>(shape.nv));
  for (int j = 0; j < shape.nv; ++j) {
    for (int i = 0; i < shape.nu; ++i) {
      addNode(model, shape.origin + shape.spacing * i * shape.across + shape.spacing * j * shape.along);
    }
  }
  addGridSprings(model, part, shape);
  part.triangles = gridTriangles(part.firstNode, shape.nu, shape.nv);
  if (shape.areaModulus > 0.0) {
    const int areas = partOf(model, part, "area");
    for (const Triangle& t : part.triangles) addArea(model, t, shape.areaModulus, areas);
  }
  if (shape.dihedralStiffness > 0.0) {
    requireSpace(model, "dihedral bending");
    const int dihedrals = partOf(model, part, "dihedral");
    for (const auto& hinge : hingesOf(part.triangles)) {
      model.dihedrals.push_back({hinge, shape.dihedralStiffness, 0.0, dihedrals});
    }
  }
  part.measure =
      shape.across.cross(shape.along).norm() * shape.spacing * shape.spacing * (shape.nu - 1) * (shape.nv - 1);
  return part;
}

Part addBox(Model& model, const BoxShape& shape, const std::string& name) {
  requireSpace(model, "a box");
  if (shape.nx < 1 || shape.ny < 1 || shape.nz < 1) {
    throw std::invalid_argument(
        fmt::format("a box of {} x {} x {} cells; at least 1 each", shape.nx, shape.ny, shape.nz));
  }
  const auto along = [](int n) { return static_cast<std::size_t>(n) + 1; };
  Part part = beginPart(model, name, along(shape.nx) * along(shape.ny) * along(shape.nz));
  const Vec3 least = shape.centre - 0.5 * shape.size;
  for (int k = 0; k <= shape.nz; ++k) {
    for (int j = 0; j <= shape.ny; ++j) {
      for (int i = 0; i <= shape.nx; ++i) {
        const Vec3 parts(static_cast<double>(i) / shape.nx, static_cast<double>(j) / shape.ny,
                         static_cast<double>(k) / shape.nz);
        addNode(model, least + shape.size.cwiseProduct(parts));
      }
    }
  }
  const auto tetrahedra = boxTetrahedra(shape, part.firstNode);
  connectTetrahedra(model, tetrahedra, shape.spring, partOf(model, part, "structural"));
  if (shape.bulkModulus > 0.0) {
    const int volumes = partOf(model, part, "bulk");
    for (const auto& t : tetrahedra) addVolume(model, t, shape.bulkModulus, volumes);
  }
  part.triangles = outerFaces(tetrahedra);
  part.measure = shape.size.prod();
  return part;
}

Part addShell(Model& model, const ShellShape& shape, const std::string& name) {
  requireSpace(model, "a surface");
  Part part = beginPart(model, name, shape.mesh.vertices.size());
  for (const Vec3& x : shape.mesh.vertices) addNode(model, x);
  const int springs = partOf(model, part, "structural");
  for (const auto& [a, b] : edgesOf(shape.mesh.triangles)) {
    connect(model, part.firstNode + a, part.firstNode + b, shape.spring, springs);
  }
  for (const Triangle& t : shape.mesh.triangles) {
    part.triangles.push_back({part.firstNode + t[0], part.firstNode + t[1], part.firstNode + t[2]});
  }
  part.measure = areaOf(shape.mesh);
  return part;
}

void lumpMass(Model& model, const Part& part, double M, double taper) {
  const auto first = model.nodes.begin() + part.firstNode;
  if (!part.shares.empty()) {
    for (int i = 0; i < part.nodeCount; ++i) first[i].m = M * part.shares[static_cast<std::size_t>(i)];
    return;
  }
  const double ratio = part.nodeCount > 1 ? std::pow(taper, 1.0 / (part.nodeCount - 1)) : 1.0;
  double sum = 0.0;
  for (int i = 0; i < part.nodeCount; ++i) sum += std::pow(ratio, i);
  for (int i = 0; i < part.nodeCount; ++i) first[i].m = M * std::pow(ratio, i) / sum;
}

void setDampingRatio(Model& model, const Part& part, double ratio) {
  for (ModelSpring& spring : model.springs) {
    if (spring.a < part.firstNode || spring.a >= part.firstNode + part.nodeCount) continue;
    spring.dampingRatio = ratio;
  }
}

}  // namespace muelle::engine
