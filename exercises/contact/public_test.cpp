#include "contact.h"
#include "course/testing/expect.h"

#include <gtest/gtest.h>

namespace {

const Vec3 origin(0, 0, 0);
const Vec3 up(0, 0, 1);

TEST(PlaneContact, PushesANodeInside) {
  MUELLE_PROPERTY("a node at rest, 0.1 m below the ground of 100 N/m, is pushed up with 10 N");
  EXPECT_VECTOR_NEAR(submission::planeContact(Vec3(3, 4, -0.1), origin, origin, up, 100.0, 5.0), Vec3(0, 0, 10), 1e-9);
}

TEST(PlaneContact, DampsTheWayIn) {
  MUELLE_PROPERTY("the same node on its way in at 2 m/s (and 7 m/s along the ground): 5 N s/m add 10 N");
  EXPECT_VECTOR_NEAR(submission::planeContact(Vec3(3, 4, -0.1), Vec3(7, 0, -2), origin, up, 100.0, 5.0), Vec3(0, 0, 20),
                     1e-9);
}

TEST(PlaneContact, WorksForAWall) {
  MUELLE_PROPERTY("a wall at x = 1 whose obstacle is beyond it pushes a node at x = 1.5 back with 50 N");
  EXPECT_VECTOR_NEAR(submission::planeContact(Vec3(1.5, 0, 0), origin, Vec3(1, 0, 0), Vec3(-1, 0, 0), 100.0, 5.0),
                     Vec3(-50, 0, 0), 1e-9);
}

TEST(PlaneNeverPulls, LeavesANodeOutsideAlone) {
  MUELLE_PROPERTY("a node above the ground feels nothing, even when it falls at 9 m/s");
  EXPECT_VECTOR_NEAR(submission::planeContact(Vec3(0, 0, 0.1), Vec3(0, 0, -9), origin, up, 100.0, 5.0), origin, 0.0);
}

TEST(PlaneNeverPulls, LetsANodeGo) {
  MUELLE_PROPERTY("a node 0.1 m inside that leaves at 3 m/s is not held back");
  EXPECT_VECTOR_NEAR(submission::planeContact(Vec3(0, 0, -0.1), Vec3(0, 0, 3), origin, up, 100.0, 5.0), origin, 0.0);
}

TEST(SphereContact, PushesAwayFromTheCentre) {
  MUELLE_PROPERTY("a node 1.5 m beside the centre of a sphere of radius 2 m and 100 N/m is pushed out with 50 N");
  EXPECT_VECTOR_NEAR(submission::sphereContact(Vec3(1, 3.5, 1), origin, Vec3(1, 2, 1), 2.0, 100.0, 5.0), Vec3(0, 50, 0),
                     1e-9);
}

TEST(SphereEdges, HasNoDirectionAtTheCentre) {
  MUELLE_PROPERTY("at the very centre the force is zero, and finite");
  EXPECT_VECTOR_NEAR(submission::sphereContact(Vec3(1, 2, 1), up, Vec3(1, 2, 1), 2.0, 100.0, 5.0), origin, 0.0);
}

TEST(ColumnAtRest, OneNodeEntersThePlane) {
  MUELLE_PROPERTY("2 kg on a plane of 100 N/m (with g = 10 m/s^2) rest 0.2 m below the surface");
  const std::vector<double> z = submission::columnAtRest({2.0}, 50.0, 1.0, 100.0, 10.0);
  ASSERT_EQ(z.size(), 1u);
  EXPECT_NUMBER_NEAR(z[0], -0.2, 1e-9);
}

TEST(ColumnAtRest, ASpringCarriesTheNodesAboveIt) {
  MUELLE_PROPERTY("1 kg, 2 kg, 1 kg: the plane carries 40 N, the lower spring 30 N, the upper one 10 N");
  const std::vector<double> z = submission::columnAtRest({1.0, 2.0, 1.0}, 100.0, 1.0, 200.0, 10.0);
  ASSERT_EQ(z.size(), 3u);
  EXPECT_NUMBER_NEAR(z[0], -0.2, 1e-9);
  EXPECT_NUMBER_NEAR(z[1], 0.5, 1e-9);
  EXPECT_NUMBER_NEAR(z[2], 1.4, 1e-9);
}

TEST(Friction, SlidesAtItsLimit) {
  MUELLE_PROPERTY("pressed with 10 N, mu = 0.3, at 2 m/s along x (and 5 m/s into the ground): 3 N against x");
  EXPECT_VECTOR_NEAR(submission::frictionForce(Vec3(2, 0, -5), up, 10.0, 0.3, 100.0), Vec3(-3, 0, 0), 1e-9);
}

TEST(Friction, GrowsFromZero) {
  MUELLE_PROPERTY("at 0.01 m/s with a slope of 100 N s/m: 1 N, and at rest none");
  EXPECT_VECTOR_NEAR(submission::frictionForce(Vec3(0, 0.01, 0), up, 10.0, 0.3, 100.0), Vec3(0, -1, 0), 1e-9);
  EXPECT_VECTOR_NEAR(submission::frictionForce(origin, up, 10.0, 0.3, 100.0), origin, 0.0);
}

}  // namespace
