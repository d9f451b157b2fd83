#include "engine/scene/polygon.h"

#include <gmock/gmock.h>
#include <Eigen/Geometry>

namespace muelle::engine {
namespace {

/// The area that the triangles cover, counted as often as they cover it; negative parts would lessen it.
double areaOf(const std::vector<Triangle>& triangles, const std::vector<Vec3>& vertices, double& least) {
  double sum = 0.0;
  for (const Triangle& t : triangles) {
    const Vec3& a = vertices[static_cast<std::size_t>(t[0])];
    const Vec3& b = vertices[static_cast<std::size_t>(t[1])];
    const Vec3& c = vertices[static_cast<std::size_t>(t[2])];
    const double area = (b - a).cross(c - a)[2] / 2.0;
    least = std::min(least, area);
    sum += area;
  }
  return sum;
}

void expectCut(const std::vector<int>& corners, const std::vector<Vec3>& vertices, std::size_t count, double area) {
  const std::vector<Triangle> triangles = cutPolygon(corners, vertices);
  EXPECT_EQ(triangles.size(), count);
  double least = 0.0;
  EXPECT_NEAR(areaOf(triangles, vertices, least), area, 1e-14);
  EXPECT_GE(least, 0.0);  // none lies outside and is taken off again
}

TEST(Polygon, AConvexOneIsAFanAboutItsFirstCorner) {
  const std::vector<Vec3> square = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  EXPECT_EQ(cutPolygon({2, 3, 0, 1}, square), (std::vector<Triangle>{{2, 3, 0}, {2, 0, 1}}));
}

TEST(Polygon, ADentStaysADentWhereverItBegins) {
  // An arrow head: 4 x 4 / 2 less the dent of 4 x 1 / 2.
  const std::vector<Vec3> arrow = {{0, 0, 0}, {2, 1, 0}, {4, 0, 0}, {2, 4, 0}};
  for (int first = 0; first < 4; ++first) {
    expectCut({first, (first + 1) % 4, (first + 2) % 4, (first + 3) % 4}, arrow, 2, 6.0);
  }
}

TEST(Polygon, ABridgedOneLeavesItsHoleOpen) {
  // A square of side 3 with a hole of side 1, which the outline goes to over the bridge 0-4 and back.
  const std::vector<Vec3> vertices = {{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0},
                                      {1, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}};
  expectCut({0, 1, 2, 3, 0, 4, 7, 6, 5, 4}, vertices, 8, 8.0);
  expectCut({4, 0, 1, 2, 3, 0, 4, 7, 6, 5}, vertices, 8, 8.0);
}

TEST(Polygon, RepeatedCornersAreDroppedAndThereAndBackIsNothing) {
  const std::vector<Vec3> square = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  expectCut({0, 1, 1, 2, 3, 3, 0}, square, 2, 1.0);
  expectCut({0, 1, 2, 1, 2, 3}, square, 2, 1.0);
  for (const std::vector<int>& corners : {std::vector<int>{}, {0}, {0, 1}, {0, 1, 0}, {0, 1, 2, 1}, {2, 2, 2, 2}}) {
    EXPECT_TRUE(cutPolygon(corners, square).empty());
  }
}

}  // namespace
}  // namespace muelle::engine
