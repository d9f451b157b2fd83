#include "engine/scene/object_reader.h"

#include "base/text/count.h"
#include "base/text/lists.h"
#include "base/text/nearest.h"
#include "base/text/printable.h"
#include "engine/scene/connectivity.h"
#include "engine/scene/mesh_file.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <map>
#include <numbers>
#include <stdexcept>

namespace muelle::engine {

namespace {

using Keys = TableReader::Keys;

constexpr int mostAlong = 100'000;  // nodes or cells of a generator in one direction

const Keys commonKeys = {
    "kind",          "name", "mass",     "density", "k",    "relative_damping", "projected_damping",
    "damping_ratio", "drag", "velocity", "spin",    "turn", "translation"};

/// The keys of each kind of object besides the common ones, those needed first.
struct KindKeys {
  Keys required;
  Keys optional;
};

const std::map<std::string, KindKeys>& kinds() {
  static const std::map<std::string, KindKeys> all = {
      {"chain", {{"nodes", "from", "to"}, {"taper", "angle_stiffness", "L0", "sag", "unilateral", "rod"}}},
      {"rope", {{"mesh"}, {"scale", "weld", "angle_stiffness", "unilateral", "rod"}}},
      {"grid",
       {{"nodes", "spacing"},
        {"origin", "across", "along", "shear_stiffness", "bend_stiffness", "dihedral_stiffness", "area_modulus",
         "rod"}}},
      {"box", {{"cells", "size"}, {"centre", "bulk_modulus"}}},
      {"shell", {{"mesh"}, {"scale", "weld"}}},
      {"lattice", {{"mesh", "spacing"}, {"scale", "weld", "ties"}}},
  };
  return all;
}

void checkKeys(const TableReader& table, const std::string& kind) {
  Keys known = commonKeys;
  Keys required = {"kind"};
  const KindKeys& keys = kinds().at(kind);
  known.insert(known.end(), keys.required.begin(), keys.required.end());
  known.insert(known.end(), keys.optional.begin(), keys.optional.end());
  required.insert(required.end(), keys.required.begin(), keys.required.end());
  const bool mayBeRods = std::ranges::find(keys.optional, "rod") != keys.optional.end();
  if (!(mayBeRods && table.has("rod"))) required.emplace_back("k");
  table.checkKeys(known, required);
  table.oneKeyOf({"mass", "density"}, true);
  table.oneKeyOf({"damping_ratio", "projected_damping"}, false);
}

SpringMaterial readMaterial(const TableReader& table) {
  SpringMaterial material;
  material.rod = table.flag("rod", false);
  if (material.rod && table.has("k")) table.fail("k", "a rod has no stiffness: leave k or rod out");
  if (!material.rod) material.k = table.positive("k");
  material.dRelative = table.notNegative("relative_damping", 0.0);
  material.dProjected = table.notNegative("projected_damping", 0.0);
  return material;
}

Part readChain(const TableReader& table, Model& model, const std::string& name) {
  ChainShape shape;
  shape.n = table.integer("nodes", 2, mostAlong);
  shape.from = table.vector("from");
  shape.to = table.vector("to");
  if (!((shape.to - shape.from).norm() > 0.0)) table.fail("to", "is the same point as 'from'");
  shape.spring = readMaterial(table);
  shape.L0 = table.positive("L0", 0.0);
  shape.sag = table.number("sag", 0.0);
  if (shape.sag != 0.0 && model.dimension == 1) table.fail("sag", "needs a scene of dimension 2 or 3");
  shape.unilateral = table.flag("unilateral", false);
  shape.angleStiffness = table.notNegative("angle_stiffness", 0.0);
  return addChain(model, shape, name);
}

Part readGrid(const TableReader& table, Model& model, const std::string& name) {
  GridShape shape;
  const std::vector<int> counts = table.integers("nodes", 2, 2, mostAlong);
  shape.nu = counts[0];
  shape.nv = counts[1];
  shape.spacing = table.positive("spacing");
  shape.origin = table.vector("origin", Vec3::Zero());
  if (model.dimension == 2) {
    shape.across = Vec3::Unit(model.plane[0]);
    shape.along = Vec3::Unit(model.plane[1]);
  }
  if (table.has("across")) shape.across = table.direction("across");
  if (table.has("along")) shape.along = table.direction("along");
  shape.structural = readMaterial(table);
  shape.shearStiffness = table.notNegative("shear_stiffness", 0.0);
  shape.bendStiffness = table.notNegative("bend_stiffness", 0.0);
  shape.dihedralStiffness = table.notNegative("dihedral_stiffness", 0.0);
  shape.areaModulus = table.notNegative("area_modulus", 0.0);
  return addGrid(model, shape, name);
}

Part readBox(const TableReader& table, Model& model, const std::string& name) {
  BoxShape shape;
  const std::vector<int> cells = table.integers("cells", 3, 1, mostAlong);
  shape.nx = cells[0];
  shape.ny = cells[1];
  shape.nz = cells[2];
  shape.size = table.sizes("size", false);
  shape.centre = table.vector("centre", Vec3::Zero());
  shape.spring = readMaterial(table);
  shape.bulkModulus = table.notNegative("bulk_modulus", 0.0);
  return addBox(model, shape, name);
}

/// Adds "3 things", or nothing where there are none.
void addCount(std::vector<std::string>& words, int count, const std::string& one, const std::string& several) {
  if (count > 0) words.push_back(counted(count, one, several));
}

/// What of a mesh is perhaps not meant, in one sentence with its full path; empty when nothing is.
std::string doubtsAbout(const SurfaceMesh& mesh, const Connectivity& found, const std::string& file) {
  std::vector<std::string> words;
  addCount(words, mesh.facesLeftOut, "face without three different corners is left out",
           "faces without three different corners are left out");
  addCount(words, mesh.linesLeftOut, "line from a node to itself, or given before, is left out",
           "lines from a node to itself, or given before, are left out");
  const char* what = mesh.lines.empty() ? "face" : "line";
  addCount(words, found.unused, fmt::format("vertex of no {} is no node", what),
           fmt::format("vertices of no {} are no nodes", what));
  if (found.pieces > 1) words.push_back(fmt::format("{} pieces that nothing joins", found.pieces));
  const bool shared = found.places < found.vertices;
  if (shared) words.push_back(fmt::format("{} vertices at {}", found.vertices, counted(found.places, "place")));
  if (words.empty()) return "";
  return fmt::format("mesh '{}': {}{}", printableLine(file), joined(words, ", "),
                     shared ? "; weld = true makes one node of those at the same place" : "");
}

/// The mesh files of a folder by name, in order.
std::vector<std::string> meshesIn(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  std::error_code unreadable;
  for (const auto& entry : std::filesystem::directory_iterator(folder, unreadable)) {
    const std::string extension = entry.path().extension().string();
    if (extension == ".obj" || extension == ".off" || extension == ".ply") {
      names.push_back(printableLine(entry.path().filename().string()));
    }
  }
  std::ranges::sort(names);
  constexpr std::size_t mostNames = 20;
  if (names.size() > mostNames) names.resize(mostNames);
  return names;
}

SurfaceMesh readMesh(const TableReader& table, const std::filesystem::path& folder, Scene& scene, MeshPart wanted) {
  const std::string name = table.text("mesh");
  const std::filesystem::path file = folder / name;  // an absolute name stays as it is
  if (!std::filesystem::is_regular_file(file)) {
    table.fail("mesh",
               fmt::format("no file '{}' beside the scene{}", printableLine(name), suggestion(name, meshesIn(folder))));
  }
  SurfaceMesh mesh = readMeshFile(file, wanted);
  if (table.flag("weld", false)) weld(mesh);
  std::string doubts = doubtsAbout(mesh, connectivityOf(mesh), file.string());
  if (!doubts.empty()) scene.warnings.push_back(std::move(doubts));
  dropUnused(mesh);
  const double scale = table.positive("scale", 1.0);
  for (Vec3& x : mesh.vertices) x *= scale;
  return mesh;
}

Part readShell(const TableReader& table, Scene& scene, const std::string& name, const std::filesystem::path& folder) {
  return addShell(scene.model, {readMesh(table, folder, scene, MeshPart::Faces), readMaterial(table)}, name);
}

Part readRope(const TableReader& table, Scene& scene, const std::string& name, const std::filesystem::path& folder) {
  RopeShape shape;
  shape.mesh = readMesh(table, folder, scene, MeshPart::Lines);
  shape.spring = readMaterial(table);
  shape.unilateral = table.flag("unilateral", false);
  shape.angleStiffness = table.notNegative("angle_stiffness", 0.0);
  return addRope(scene.model, shape, name);
}

Part readLattice(const TableReader& table, Scene& scene, const std::string& name, const std::filesystem::path& folder) {
  LatticeShape shape;
  shape.mesh = readMesh(table, folder, scene, MeshPart::Faces);
  shape.spacing = table.positive("spacing");
  if (table.has("ties")) shape.ties = table.integer("ties", 1, 100);
  shape.spring = readMaterial(table);
  return addLattice(scene.model, shape, name);
}

Part generate(const TableReader& table, const std::string& kind, const std::string& name, Scene& scene,
              const std::filesystem::path& folder) {
  if (kind == "chain") return readChain(table, scene.model, name);
  if (kind == "rope") return readRope(table, scene, name, folder);
  if (kind == "grid") return readGrid(table, scene.model, name);
  if (kind == "box") return readBox(table, scene.model, name);
  return kind == "shell" ? readShell(table, scene, name, folder) : readLattice(table, scene, name, folder);
}

void readMass(const TableReader& table, Model& model, const Part& part) {
  const double mass = table.has("mass") ? table.positive("mass") : table.positive("density") * part.measure;
  if (!(mass > 0.0)) table.fail("density", "the surface encloses no volume; give 'mass', or turn its triangles round");
  lumpMass(model, part, mass, table.positive("taper", 1.0));
  if (table.has("damping_ratio")) setDampingRatio(model, part, table.notNegative("damping_ratio"));
}

template <class Use>
void forNodes(Model& model, const Part& part, const Use& use) {
  const auto first = model.nodes.begin() + part.firstNode;
  std::for_each(first, first + part.nodeCount, use);
}

Vec3 centreOf(Model& model, const Part& part) {
  Vec3 sum = Vec3::Zero();
  double mass = 0.0;
  forNodes(model, part, [&](const ModelNode& node) {
    sum += node.m * node.x;
    mass += node.m;
  });
  return sum / mass;
}

/// turn = [rx, ry, rz], degrees: about the centre of mass, first about x, then y, then z.
void turn(const TableReader& table, Model& model, const Part& part) {
  if (!table.has("turn")) return;
  if (model.dimension != 3) table.fail("turn", "needs a scene of dimension 3");
  const Vec3 angles = table.triple("turn") * std::numbers::pi / 180.0;
  const Mat3 R = (Eigen::AngleAxisd(angles[2], Vec3::UnitZ()) * Eigen::AngleAxisd(angles[1], Vec3::UnitY()) *
                  Eigen::AngleAxisd(angles[0], Vec3::UnitX()))
                     .toRotationMatrix();
  const Vec3 centre = centreOf(model, part);
  forNodes(model, part, [&](ModelNode& node) { node.x = centre + R * (node.x - centre); });
  for (ModelArea& area : model.areas) {
    if (area.nodes[0] >= part.firstNode) area.normal = R * area.normal;
  }
}

void place(const TableReader& table, Model& model, const Part& part) {
  turn(table, model, part);
  const Vec3 translation = table.vector("translation", Vec3::Zero());
  const Vec3 velocity = table.vector("velocity", Vec3::Zero());
  if (table.has("spin") && model.dimension == 1) table.fail("spin", "needs a scene of dimension 2 or 3");
  const Vec3 spin = table.has("spin") ? table.triple("spin") : Vec3::Zero();
  const double drag = table.notNegative("drag", 0.0);
  const Vec3 centre = centreOf(model, part);
  forNodes(model, part, [&](ModelNode& node) {
    node.v = velocity + spin.cross(node.x - centre);
    node.x += translation;
    node.drag = drag;
  });
}

}  // namespace

void readObject(const TableReader& table, Scene& scene, const std::filesystem::path& folder) {
  Keys names;
  for (const auto& [name, keys] : kinds()) names.push_back(name);
  const std::string kind = table.choice("kind", names);
  checkKeys(table, kind);
  const std::string name = table.text("name", fmt::format("{}{}", kind, scene.parts.size() + 1));
  if (std::ranges::find(scene.parts, name, &Part::name) != scene.parts.end()) {
    table.fail("name", fmt::format("'{}' is already that of another object", name));
  }
  Part part;
  try {
    part = generate(table, kind, name, scene, folder);
  } catch (const std::invalid_argument& error) {
    table.failHere(error.what());
  }
  readMass(table, scene.model, part);
  place(table, scene.model, part);
  scene.parts.push_back(std::move(part));
}

}  // namespace muelle::engine
