#include "engine/model/singular_starts.h"

#include <gtest/gtest.h>

namespace muelle::engine {
namespace {

Model withNodes(std::initializer_list<Vec3> places, int dimension = 3) {
  Model model;
  model.dimension = dimension;
  for (const Vec3& place : places) model.nodes.push_back({.x = place});
  return model;
}

TEST(SingularStarts, AreNamed) {
  Model pair = withNodes({Vec3(1, 2, 3), Vec3(1, 2, 3)});
  pair.springs.push_back({.a = 0, .b = 1, .k = 10.0, .L0 = 0.5});
  EXPECT_EQ(singularStarts(pair),
            std::vector<std::string>{"nodes 0 and 1 start in one place, and spring 0 between them "
                                     "is 0.5 m long: its force has no direction there"});
  Model straight = withNodes({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0)});
  straight.angles.push_back({.k = 1.0, .theta0 = 0.3});
  EXPECT_EQ(singularStarts(straight),
            std::vector<std::string>{"angle 0 at node 1 starts straight and wants 0.3 rad: it "
                                     "has no side to bend to"});
  Model folded = withNodes({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0.5, 0, 0)});
  folded.angles.push_back({.k = 1.0});
  EXPECT_EQ(singularStarts(folded).size(), 1U);
  Model ball = withNodes({Vec3(0, 0, 1), Vec3(0, 0, 2)});
  ball.obstacles.push_back({.kind = Obstacle::Kind::Sphere, .name = "ball", .centre = Vec3(0, 0, 1)});
  EXPECT_EQ(singularStarts(ball),
            std::vector<std::string>{"node 0 starts at the centre of 'ball', which has no side to push it out of"});
}

TEST(SingularStarts, AreNoneWhereTheGradientIsDefined) {
  Model zero = withNodes({Vec3(1, 2, 3), Vec3(1, 2, 3)});
  zero.springs.push_back({.a = 0, .b = 1, .k = 10.0, .L0 = 0.0});
  EXPECT_TRUE(singularStarts(zero).empty()) << "a spring of rest length 0 is smooth";
  Model straight = withNodes({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0)});
  straight.angles.push_back({.k = 1.0, .theta0 = 0.0});
  EXPECT_TRUE(singularStarts(straight).empty()) << "straight is where it wants to be";
  Model plane = withNodes({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0)}, 2);
  plane.angles.push_back({.k = 1.0, .theta0 = 0.3});
  EXPECT_TRUE(singularStarts(plane).empty()) << "in the plane an angle has a sign";
  Model held = withNodes({Vec3(1, 2, 3), Vec3(1, 2, 3)});
  held.nodes[0].pinned = held.nodes[1].pinned = true;
  held.springs.push_back({.a = 0, .b = 1, .k = 10.0, .L0 = 0.5});
  EXPECT_TRUE(singularStarts(held).empty()) << "both are held";
}

}  // namespace
}  // namespace muelle::engine
