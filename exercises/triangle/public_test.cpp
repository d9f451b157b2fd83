#include "course/testing/expect.h"
#include "triangle.h"

#include <gtest/gtest.h>

// The nodes are at (0, 0, 0), (3, 0, 0) and (0, 4, 0): the springs 01, 12, 20 have the lengths 3, 5, 4 m.

namespace {

Vec9 stacked(const Vec3& x0, const Vec3& x1, const Vec3& x2) {
  Vec9 x;
  x << x0, x1, x2;
  return x;
}

const Vec9 corners = stacked(Vec3(0, 0, 0), Vec3(3, 0, 0), Vec3(0, 4, 0));
const Vec3 k(10, 20, 30);

TEST(MassMatrix, GivesEveryComponentTheMassOfItsNode) {
  MUELLE_PROPERTY("with the masses 1, 2 and 3 kg the diagonal reads 1 1 1 2 2 2 3 3 3");
  const Mat9 M = submission::massMatrix(Vec3(1, 2, 3));
  Vec9 diagonal;
  diagonal << 1, 1, 1, 2, 2, 2, 3, 3, 3;
  for (int row = 0; row < 9; ++row) {
    Vec9 expected = Vec9::Zero();
    expected[row] = diagonal[row];
    EXPECT_VECTOR_NEAR(Vec9(M.row(row)), expected, 1e-12);
  }
}

TEST(TriangleEnergy, OfSpring01Alone) {
  MUELLE_PROPERTY("only spring 01 is stretched, by 1 m with k = 10: 5 J");
  EXPECT_NUMBER_NEAR(submission::triangleEnergy(corners, k, Vec3(2, 5, 4)), 5.0, 1e-9);
}

TEST(TriangleEnergy, AddsTheSprings) {
  MUELLE_PROPERTY("each spring is stretched by 1 m: 5 + 10 + 15 J");
  EXPECT_NUMBER_NEAR(submission::triangleEnergy(corners, k, Vec3(2, 4, 3)), 30.0, 1e-9);
}

TEST(TriangleForce, OfSpring01Alone) {
  MUELLE_PROPERTY("only spring 01 is stretched, by 1 m with k = 10: it pulls nodes 0 and 1 together with 10 N");
  const Vec9 expected = stacked(Vec3(10, 0, 0), Vec3(-10, 0, 0), Vec3(0, 0, 0));
  EXPECT_VECTOR_NEAR(submission::triangleForce(corners, k, Vec3(2, 5, 4)), expected, 1e-9);
}

TEST(TriangleForce, OfSpring12Alone) {
  MUELLE_PROPERTY("only spring 12 is stretched, by 1 m with k = 20: it pulls nodes 1 and 2 together with 20 N");
  const Vec9 expected = stacked(Vec3(0, 0, 0), Vec3(-12, 16, 0), Vec3(12, -16, 0));
  EXPECT_VECTOR_NEAR(submission::triangleForce(corners, k, Vec3(3, 4, 4)), expected, 1e-9);
}

TEST(TriangleForce, AddsTheSprings) {
  MUELLE_PROPERTY("each spring is stretched by 1 m: every node feels two of them");
  const Vec9 expected = stacked(Vec3(10, 30, 0), Vec3(-22, 16, 0), Vec3(12, -46, 0));
  EXPECT_VECTOR_NEAR(submission::triangleForce(corners, k, Vec3(2, 4, 3)), expected, 1e-9);
}

TEST(NewtonsThirdLaw, LeavesNoNetForce) {
  MUELLE_PROPERTY("the forces on the three nodes add up to zero, and none of them is zero");
  const Vec9 F = submission::triangleForce(corners, k, Vec3(2, 4, 3));
  EXPECT_VECTOR_NEAR(Vec3(F.segment<3>(0) + F.segment<3>(3) + F.segment<3>(6)), Vec3(0, 0, 0), 1e-9);
  EXPECT_NUMBER_NEAR(F.segment<3>(3).norm(), std::sqrt(740.0), 1e-9);
}

TEST(CoincidentNodes, FeelTheOtherSpringsAlone) {
  MUELLE_PROPERTY("nodes 0 and 1 coincide: spring 01 pulls at nothing, the springs 12 and 20 still pull at node 2");
  const Vec9 x = stacked(Vec3(0, 0, 0), Vec3(0, 0, 0), Vec3(0, 4, 0));
  const Vec9 expected = stacked(Vec3(0, 30, 0), Vec3(0, 20, 0), Vec3(0, -50, 0));
  EXPECT_VECTOR_NEAR(submission::triangleForce(x, k, Vec3(3, 3, 3)), expected, 1e-9);
  EXPECT_NUMBER_NEAR(submission::triangleEnergy(x, k, Vec3(3, 3, 3)), 70.0, 1e-9);
}

TEST(TinyLengths, HaveADirection) {
  MUELLE_PROPERTY("nodes 0 and 1 are 1e-9 m apart: spring 01, compressed by its 3 m, pushes them apart with 30 N");
  const Vec9 x = stacked(Vec3(0, 0, 0), Vec3(1e-9, 0, 0), Vec3(0, 4, 0));
  const Vec9 expected = stacked(Vec3(-30, 0, 0), Vec3(30, 0, 0), Vec3(0, 0, 0));
  EXPECT_VECTOR_NEAR(submission::triangleForce(x, k, Vec3(3, 4, 4)), expected, 1e-6);
}

}  // namespace
