#include "engine/scene/polygon_list.h"

#include "engine/scene/polygon.h"

#include <fmt/format.h>
#include <algorithm>
#include <set>

namespace muelle::engine {

namespace {

/// The lines from corner to corner that are not there yet.
void addLines(SurfaceMesh& mesh, const std::vector<int>& corners, std::set<Line>& there) {
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    const Line line = {corners[i], corners[i + 1]};
    const bool isNew =
        line[0] != line[1] && there.insert({std::min(line[0], line[1]), std::max(line[0], line[1])}).second;
    if (isNew) {
      mesh.lines.push_back(line);
    } else {
      ++mesh.linesLeftOut;
    }
  }
}

}  // namespace

void PolygonList::add(const std::vector<std::int64_t>& corners, const MeshText& at, bool isLine) {
  constexpr auto most = static_cast<std::size_t>(mostFaces);
  if (polygons_.size() >= most || corners_.size() + corners.size() > 3 * most) {
    at.fail(fmt::format("more than {} triangles; fewer are read", mostFaces));
  }
  corners_.insert(corners_.end(), corners.begin(), corners.end());
  polygons_.push_back({corners_.size(), at.lineNumber(), isLine});
}

std::vector<int> PolygonList::checkedCorners(const Polygon& polygon, std::size_t begin, std::int64_t count,
                                             const MeshText& at, int counted) const {
  std::vector<int> corners;
  for (std::size_t i = begin; i < polygon.end; ++i) {
    if (corners_[i] < 0 || corners_[i] >= count) {
      at.failAt(polygon.line,
                fmt::format("a {} names vertex {} (counted from {}); there {} {}", polygon.isLine ? "line" : "face",
                            corners_[i] + counted, counted, count == 1 ? "is" : "are", count));
    }
    corners.push_back(static_cast<int>(corners_[i]));
  }
  return corners;
}

void PolygonList::cutInto(SurfaceMesh& mesh, const MeshText& at, int counted, MeshPart wanted) const {
  std::set<Line> there;
  bool hasFaces = false;
  bool hasLines = false;
  std::size_t begin = 0;
  for (const Polygon& polygon : polygons_) {
    const std::vector<int> corners = checkedCorners(polygon, begin, std::ssize(mesh.vertices), at, counted);
    begin = polygon.end;
    const bool isLine = polygon.isLine || corners.size() == 2;
    (isLine ? hasLines : hasFaces) = true;
    if (wanted == MeshPart::Lines) {
      if (isLine) addLines(mesh, corners, there);
    } else if (!polygon.isLine) {
      const std::vector<Triangle> triangles = cutPolygon(corners, mesh.vertices);
      mesh.triangles.insert(mesh.triangles.end(), triangles.begin(), triangles.end());
      if (triangles.empty()) ++mesh.facesLeftOut;
    }
  }
  if (wanted == MeshPart::Lines) {
    if (!mesh.lines.empty()) return;
    at.fail(hasLines   ? "no line that has two different ends"
            : hasFaces ? "only faces and no line: a 'rope' needs lines; 'shell' and 'lattice' take faces"
                       : "no line");
  }
  if (!mesh.triangles.empty()) return;
  if (hasLines) at.fail("only lines and no face: 'shell' and 'lattice' need faces; a 'rope' takes lines");
  at.fail(hasFaces ? "no face that has three different corners" : "no face");
}

}  // namespace muelle::engine
