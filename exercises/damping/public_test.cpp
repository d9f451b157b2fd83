#include "course/testing/expect.h"
#include "damping.h"

#include <gtest/gtest.h>

namespace {

TEST(NodeDamping, BrakesAMovingNode) {
  MUELLE_PROPERTY("with d = 0.5 N s/m a node at (2, 0, -4) m/s is braked with (-1, 0, 2) N");
  EXPECT_VECTOR_NEAR(submission::nodeDamping(Vec3(2, 0, -4), 0.5), Vec3(-1, 0, 2), 1e-12);
}

TEST(RelativeDamping, BrakesTheMotionOfASeenFromB) {
  MUELLE_PROPERTY("a at (3, 1, 0) m/s and b at (1, 1, 0) m/s: with d = 2 N s/m the force on a is (-4, 0, 0) N");
  EXPECT_VECTOR_NEAR(submission::relativeDamping(Vec3(3, 1, 0), Vec3(1, 1, 0), 2.0), Vec3(-4, 0, 0), 1e-12);
}

TEST(RelativeDamping, TurnsRoundForTheOtherEnd) {
  MUELLE_PROPERTY("with the ends exchanged the force is (4, 0, 0) N");
  EXPECT_VECTOR_NEAR(submission::relativeDamping(Vec3(1, 1, 0), Vec3(3, 1, 0), 2.0), Vec3(4, 0, 0), 1e-12);
}

TEST(ProjectedDamping, BrakesTheStretchingOnly) {
  MUELLE_PROPERTY(
      "a is 2 m above b and moves at (5, 0, 1) m/s: with d = 3 N s/m only the 1 m/s along the spring is braked");
  const Vec3 force = submission::projectedDamping(Vec3(0, 0, 2), Vec3(0, 0, 0), Vec3(5, 0, 1), Vec3(0, 0, 0), 3.0);
  EXPECT_VECTOR_NEAR(force, Vec3(0, 0, -3), 1e-12);
}

TEST(ProjectedDamping, WorksAlongAnyDirection) {
  MUELLE_PROPERTY(
      "a spring along (3, 4, 0) of length 5 m grows by 10 m/s: with d = 1 N s/m the force on a is (-6, -8, 0) N");
  const Vec3 force = submission::projectedDamping(Vec3(3, 4, 1), Vec3(0, 0, 1), Vec3(6, 8, 7), Vec3(0, 0, 2), 1.0);
  EXPECT_VECTOR_NEAR(force, Vec3(-6, -8, 0), 1e-9);
}

TEST(ShortSpring, HasNoDirectionAtLengthZero) {
  MUELLE_PROPERTY("with both nodes at one place the force is zero, and finite");
  const Vec3 here(1, 2, 3);
  EXPECT_VECTOR_NEAR(submission::projectedDamping(here, here, Vec3(1, 0, 0), Vec3(0, 1, 0), 2.0), Vec3(0, 0, 0), 0.0);
}

TEST(ShortSpring, HasADirectionAtOneNanometre) {
  MUELLE_PROPERTY("a spring of length 1e-9 m that grows by 2 m/s is braked like any other");
  const Vec3 force = submission::projectedDamping(Vec3(1e-9, 0, 0), Vec3(0, 0, 0), Vec3(2, 3, 0), Vec3(0, 0, 0), 1.0);
  EXPECT_VECTOR_NEAR(force, Vec3(-2, 0, 0), 1e-9);
}

}  // namespace
