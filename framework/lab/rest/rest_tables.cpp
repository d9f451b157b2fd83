#include "lab/rest/rest_tables.h"

#include "base/file.h"

#include <fmt/format.h>

namespace muelle::lab {

using namespace engine;

namespace {

std::string nodeTable(const SceneAtRest& rest) {
  const Model& model = rest.system->model();
  const State start = rest.system->initialState();
  std::string text = "node,free,x [m],y [m],z [m],moved [m]\n";
  for (int node = 0; node < rest.system->nodeCount(); ++node) {
    const Vec3 x = rest.system->position(rest.result.state, node);
    const double way = (x - rest.system->position(start, node)).norm();
    text += fmt::format("{},{},{},{},{},{}\n", node, isFree(model.nodes[static_cast<std::size_t>(node)]) ? 1 : 0, x[0],
                        x[1], x[2], way);
  }
  return text;
}

std::string springTable(const SceneAtRest& rest) {
  const Model& model = rest.system->model();
  std::string text = "spring,node a,node b,k [N/m],L0 [m],length [m],tension [N]\n";
  for (std::size_t i = 0; i < rest.result.tensions.size(); ++i) {
    const ModelSpring& s = model.springs[i];
    const Vec3 d = rest.system->position(rest.result.state, s.a) - rest.system->position(rest.result.state, s.b);
    text += fmt::format("{},{},{},{},{},{},{}\n", i, s.a, s.b, s.k, s.L0, d.norm(), rest.result.tensions[i]);
  }
  return text;
}

}  // namespace

std::vector<std::filesystem::path> writeTables(const Scene& scene, const SceneAtRest& rest,
                                               const std::filesystem::path& folder) {
  const std::filesystem::path nodes = folder / (scene.name + "_nodes.csv");
  const std::filesystem::path springs = folder / (scene.name + "_springs.csv");
  writeFile(nodes, nodeTable(rest));
  if (scene.model.springs.empty()) return {nodes};
  writeFile(springs, springTable(rest));
  return {nodes, springs};
}

}  // namespace muelle::lab
