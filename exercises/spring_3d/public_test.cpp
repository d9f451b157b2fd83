#include "spring_3d.h"

#include "course/testing/expect.h"

#include <gtest/gtest.h>

namespace {

TEST(Magnitude, IsNegativeWhenStretched) {
  MUELLE_PROPERTY("a spring of 100 N/m and 4 m at rest, stretched to 5 m, has the magnitude -100 N");
  EXPECT_NUMBER_NEAR(submission::springForceMagnitude(Vec3(3, 0, 4), Vec3(0, 0, 0), 100.0, 4.0), -100.0, 1e-9);
}

TEST(Direction, PointsFromBToAWithLengthOne) {
  MUELLE_PROPERTY("from b = (1, 1, 1) to a = (4, 1, 5) the direction is (0.6, 0, 0.8)");
  EXPECT_VECTOR_NEAR(submission::springDirection(Vec3(4, 1, 5), Vec3(1, 1, 1)), Vec3(0.6, 0, 0.8), 1e-12);
}

TEST(HookeForce, AStretchedSpringPullsAToB) {
  MUELLE_PROPERTY("100 N/m stretched by 1 m pulls a towards b with 100 N");
  EXPECT_VECTOR_NEAR(submission::springForce(Vec3(3, 0, 4), Vec3(0, 0, 0), 100.0, 4.0), Vec3(-60, 0, -80), 1e-9);
}

TEST(HookeForce, ACompressedSpringPushesAFromB) {
  MUELLE_PROPERTY("100 N/m compressed by 1 m pushes a away from b with 100 N");
  EXPECT_VECTOR_NEAR(submission::springForce(Vec3(3, 0, 4), Vec3(0, 0, 0), 100.0, 6.0), Vec3(60, 0, 80), 1e-9);
}

TEST(ThirdLaw, BFeelsTheOppositeForce) {
  MUELLE_PROPERTY("with the nodes exchanged, the same stretched spring pulls the other way");
  EXPECT_VECTOR_NEAR(submission::springForce(Vec3(0, 0, 0), Vec3(3, 0, 4), 100.0, 4.0), Vec3(60, 0, 80), 1e-9);
}

TEST(ZeroLength, CoincidentNodesFeelNoForce) {
  MUELLE_PROPERTY("at L = 0 there is no direction, and the force is a zero vector");
  EXPECT_VECTOR_NEAR(submission::springForce(Vec3(1, 2, 3), Vec3(1, 2, 3), 100.0, 1.0), Vec3(0, 0, 0), 1e-12);
}

TEST(NodeAcceleration, FallsFreelyWithoutSprings) {
  MUELLE_PROPERTY("without springs the acceleration is (0, 0, -g), whatever the mass");
  EXPECT_VECTOR_NEAR(submission::nodeAcceleration(Vec3(1, 2, 3), 5.0, {}, 10.0), Vec3(0, 0, -10), 1e-9);
}

TEST(NodeAcceleration, AddsTheSpringsAndTheWeight) {
  MUELLE_PROPERTY("two springs of 50 N/m, each stretched by 1 m along x and along z, pull 2 kg with 50 N each");
  const std::vector<Attachment> springs = {{Vec3(2, 0, 0), 50.0, 1.0}, {Vec3(0, 0, 2), 50.0, 1.0}};
  EXPECT_VECTOR_NEAR(submission::nodeAcceleration(Vec3(0, 0, 0), 2.0, springs, 10.0), Vec3(25, 0, 15), 1e-9);
}

}  // namespace
