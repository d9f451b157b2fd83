#include "engine/scene/polygon.h"

#include <algorithm>
#include <Eigen/Geometry>

namespace muelle::engine {

namespace {

/// A polygon that loses its ears, one after the other.
class Outline {
 public:
  Outline(std::vector<int> corners, const std::vector<Vec3>& vertices)
      : corners_(std::move(corners)), vertices_(vertices) {
    dropRepeated();
    // Newell: the sum of the signed areas over the three planes, right for polygons that are not quite flat.
    for (std::size_t i = 0; i < corners_.size(); ++i) normal_ += place(i).cross(place(i + 1));
  }

  std::size_t size() const { return corners_.size(); }
  Triangle around(std::size_t i) const { return {corner(i + size() - 1), corner(i), corner(i + 1)}; }
  Triangle fan(std::size_t i) const { return {corner(0), corner(i), corner(i + 1)}; }

  bool isConvex() const {
    std::vector<int> sorted = corners_;
    std::ranges::sort(sorted);
    if (std::ranges::adjacent_find(sorted) != sorted.end()) return false;
    for (std::size_t i = 0; i < size(); ++i) {
      if (turn(around(i)) < 0.0) return false;
    }
    return true;
  }

  /// The next corner to cut off; where rounding hides every ear, the one that turns most.
  std::size_t ear() const {
    std::size_t best = 0;
    for (std::size_t i = 0; i < size(); ++i) {
      if (isEar(around(i))) return i;
      if (turn(around(i)) > turn(around(best))) best = i;
    }
    return best;
  }

  void cutOff(std::size_t i) {
    corners_.erase(corners_.begin() + static_cast<std::ptrdiff_t>(i));
    dropRepeated();
  }

 private:
  int corner(std::size_t i) const { return corners_[i % size()]; }
  const Vec3& vertex(int i) const { return vertices_[static_cast<std::size_t>(i)]; }
  const Vec3& place(std::size_t i) const { return vertex(corner(i)); }

  /// Positive where the outline turns left, seen against the normal; twice the area of the triangle, times its length.
  double turn(const Vec3& a, const Vec3& b, const Vec3& c) const { return (b - a).cross(c - b).dot(normal_); }
  double turn(const Triangle& t) const { return turn(vertex(t[0]), vertex(t[1]), vertex(t[2])); }

  bool isEar(const Triangle& t) const {
    if (!(turn(t) > 0.0)) return false;
    return std::ranges::none_of(corners_, [&](int i) { return liesIn(t, vertex(i)); });
  }

  /// The border belongs to it, the corners do not: a bridge's ends lie there twice.
  bool liesIn(const Triangle& t, const Vec3& point) const {
    const Vec3& a = vertex(t[0]);
    const Vec3& b = vertex(t[1]);
    const Vec3& c = vertex(t[2]);
    if (point == a || point == b || point == c) return false;
    return turn(a, b, point) >= 0.0 && turn(b, c, point) >= 0.0 && turn(c, a, point) >= 0.0;
  }

  /// Corners that follow themselves, and ways to a corner and straight back.
  void dropRepeated() {
    std::size_t i = 0;
    while (i < size() && size() > 1) {
      const bool follows = corner(i) == corner(i + 1);
      if (!follows && (size() < 3 || corner(i) != corner(i + 2))) {
        ++i;
        continue;
      }
      corners_.erase(corners_.begin() + static_cast<std::ptrdiff_t>((i + 1) % size()));
      i = 0;
    }
  }

  std::vector<int> corners_;
  const std::vector<Vec3>& vertices_;
  Vec3 normal_ = Vec3::Zero();
};

}  // namespace

std::vector<Triangle> cutPolygon(std::vector<int> corners, const std::vector<Vec3>& vertices) {
  Outline outline(std::move(corners), vertices);
  std::vector<Triangle> triangles;
  if (outline.size() > 3 && outline.isConvex()) {
    for (std::size_t i = 1; i + 1 < outline.size(); ++i) triangles.push_back(outline.fan(i));
    return triangles;
  }
  while (outline.size() > 3) {
    const std::size_t ear = outline.ear();
    triangles.push_back(outline.around(ear));
    outline.cutOff(ear);
  }
  if (outline.size() == 3) triangles.push_back(outline.fan(1));
  return triangles;
}

}  // namespace muelle::engine
