#include "drawing.h"
#include "engine/scene/generators.h"
#include "tools.h"

#include <fmt/format.h>
#include <map>

namespace muelle::plots::mesh_to_springs {

namespace {

/// A spring that bows a little to one side, so that it is seen beside the shorter ones that it spans.
void addBow(Segments& lines, const Vec3& a, const Vec3& b) {
  const Vec3 side = 0.09 * Vec3(-(b - a).z(), 0.0, (b - a).x());
  const auto at = [&](double s) -> Vec3 { return a + s * (b - a) + 4.0 * s * (1.0 - s) * side; };
  for (int i = 0; i < 10; ++i) lines.add(at(0.1 * i), at(0.1 * (i + 1)));
}

}  // namespace

/// Slide "Mallado" of the index and "Todo junto...": the edges of a mesh become springs, and further springs keep its
/// cells square and the cloth flat.
Figure mesh_to_springs() {
  engine::GridShape shape;
  shape.nu = 6;
  shape.nv = 6;
  shape.along = Vec3::UnitZ();
  shape.shearStiffness = shape.bendStiffness = 10.0;
  engine::Model model;
  const engine::Part part = engine::addGrid(model, shape);
  const auto position = [&](int node) { return model.nodes[static_cast<std::size_t>(node)].x; };

  Segments edges;
  for (const auto& [a, b] : engine::edgesOf(part.triangles)) edges.add(position(a), position(b));
  std::vector<double> x, z;
  for (const engine::ModelNode& node : model.nodes) {
    x.push_back(node.x.x());
    z.push_back(node.x.z());
  }
  // The kinds by their length: a side, a diagonal, two sides of a cell.
  Segments structural, shear, bending;
  std::map<const Segments*, int> count;
  for (const engine::ModelSpring& spring : model.springs) {
    const double sides = spring.L0 / shape.spacing;
    Segments& kind = sides < 1.2 ? structural : sides < 1.7 ? shear : bending;
    ++count[&kind];
    &kind == &bending ? addBow(kind, position(spring.a), position(spring.b))
                      : kind.add(position(spring.a), position(spring.b));
  }

  Figure figure(
      "mesh_to_springs",
      fmt::format("A mesh becomes {} nodes and {} springs of three kinds", part.nodeCount, model.springs.size()),
      "x [m]");
  figure.slide(2);
  figure.panel("z [m]")
      .heading("mesh: vertices and edges")
      .line("edge", edges.x, edges.y)
      .colour(5)
      .nodes("vertex", x, z)
      .equalAxes();
  figure.panel("z [m]")
      .heading("model: nodes and springs")
      .line(fmt::format("{} bending", count[&bending]), bending.x, bending.y)
      .colour(2)
      .line(fmt::format("{} shear", count[&shear]), shear.x, shear.y)
      .colour(4)
      .line(fmt::format("{} structural", count[&structural]), structural.x, structural.y)
      .colour(0)
      .nodes("node", x, z)
      .equalAxes();
  return figure;
}

}  // namespace muelle::plots::mesh_to_springs
