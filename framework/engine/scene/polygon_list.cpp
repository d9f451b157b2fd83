#include "engine/scene/polygon_list.h"

#include "engine/scene/mesh_file.h"
#include "engine/scene/polygon.h"

#include <fmt/format.h>

namespace muelle::engine {

void PolygonList::add(const std::vector<std::int64_t>& corners, const MeshText& at) {
  constexpr auto most = static_cast<std::size_t>(mostFaces);
  if (polygons_.size() >= most || corners_.size() + corners.size() > 3 * most) {
    at.fail(fmt::format("more than {} triangles; fewer are read", mostFaces));
  }
  corners_.insert(corners_.end(), corners.begin(), corners.end());
  polygons_.push_back({corners_.size(), at.lineNumber()});
}

void PolygonList::cutInto(SurfaceMesh& mesh, const MeshText& at, int counted, bool hasLines) const {
  const std::int64_t count = std::ssize(mesh.vertices);
  std::vector<int> corners;
  std::size_t begin = 0;
  for (const Polygon& polygon : polygons_) {
    corners.clear();
    for (std::size_t i = begin; i < polygon.end; ++i) {
      if (corners_[i] < 0 || corners_[i] >= count) {
        at.failAt(polygon.line, fmt::format("a face names vertex {} (counted from {}); there are {}",
                                            corners_[i] + counted, counted, count));
      }
      corners.push_back(static_cast<int>(corners_[i]));
    }
    hasLines |= polygon.end - begin == 2;
    begin = polygon.end;
    const std::vector<Triangle> triangles = cutPolygon(corners, mesh.vertices);
    mesh.triangles.insert(mesh.triangles.end(), triangles.begin(), triangles.end());
    if (triangles.empty()) ++mesh.facesLeftOut;
  }
  if (!mesh.triangles.empty()) return;
  if (hasLines) at.fail("only lines and no face: what is made of a mesh needs faces; a line is a 'chain'");
  at.fail(polygons_.empty() ? "no face" : "no face that has three different corners");
}

}  // namespace muelle::engine
