#include "course/testing/expect.h"
#include "generalised_springs.h"

#include <gtest/gtest.h>

// A right angle at node 1: the line goes 2 m along x, then 4 m along y. As a triangle it has an area of 4 m^2. With a
// fourth node 3 m above node 0 it is a tetrahedron of 4 m^3.

namespace {

Vec9 three(const Vec3& x0, const Vec3& x1, const Vec3& x2) {
  Vec9 x;
  x << x0, x1, x2;
  return x;
}

Vec12 four(const Vec3& x0, const Vec3& x1, const Vec3& x2, const Vec3& x3) {
  Vec12 x;
  x << x0, x1, x2, x3;
  return x;
}

const Vec9 corner = three(Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(2, 4, 0));
const Vec9 line = three(Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(3, 0, 0));
const Vec12 solid = four(Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(2, 4, 0), Vec3(0, 0, 3));
const double right = std::acos(0.0);  // a right angle

TEST(BendingAngle, OfACornerAndOfALine) {
  MUELLE_PROPERTY("a right angle is pi/2, a line that goes straight on bends by 0");
  EXPECT_NUMBER_NEAR(submission::bendingAngle(corner), right, 1e-12);
  EXPECT_NUMBER_NEAR(submission::bendingAngle(line), 0.0, 1e-12);
}

TEST(BendingEnergy, GrowsWithTheSquare) {
  MUELLE_PROPERTY("with kb = 10, 0.2 rad off the rest angle store 0.2 J");
  EXPECT_NUMBER_NEAR(submission::bendingEnergy(corner, right - 0.2, 10), 0.2, 1e-9);
}

TEST(BendingForce, StraightensTheCorner) {
  MUELLE_PROPERTY("0.2 rad too much with kb = 10 is a torque of 2 N m: 1 N at the end of 2 m, 0.5 N at the end of 4 m");
  EXPECT_VECTOR_NEAR(submission::bendingForce(corner, right - 0.2, 10),
                     three(Vec3(0, -1, 0), Vec3(-0.5, 1, 0), Vec3(0.5, 0, 0)), 1e-9);
}

TEST(TriangleArea, IsBaseTimesHeightOverTwo) {
  MUELLE_PROPERTY("2 m times 4 m over 2");
  EXPECT_NUMBER_NEAR(submission::triangleArea(corner), 4.0, 1e-12);
}

TEST(AreaEnergy, GrowsWithTheSquare) {
  MUELLE_PROPERTY("with kA = 10, 1 m^2 too much stores 5 J, and so does 1 m^2 too little");
  EXPECT_NUMBER_NEAR(submission::areaEnergy(corner, 3, 10), 5.0, 1e-9);
  EXPECT_NUMBER_NEAR(submission::areaEnergy(corner, 5, 10), 5.0, 1e-9);
}

TEST(AreaForce, MovesEachCornerTowardsItsSide) {
  MUELLE_PROPERTY("1 m^2 too much with kA = 10: node 0 is 2 m from a side of 4 m, which adds 2 m^2 a metre: 20 N");
  EXPECT_VECTOR_NEAR(submission::areaForce(corner, 3, 10), three(Vec3(20, 0, 0), Vec3(-20, 10, 0), Vec3(0, -10, 0)),
                     1e-9);
}

TEST(TetrahedronVolume, HasASign) {
  MUELLE_PROPERTY("base 4 m^2 times height 3 m over 3; with nodes 1 and 2 exchanged it is inverted: -4 m^3");
  EXPECT_NUMBER_NEAR(submission::tetrahedronVolume(solid), 4.0, 1e-12);
  const Vec12 inverted = four(Vec3(0, 0, 0), Vec3(2, 4, 0), Vec3(2, 0, 0), Vec3(0, 0, 3));
  EXPECT_NUMBER_NEAR(submission::tetrahedronVolume(inverted), -4.0, 1e-12);
}

TEST(VolumeEnergy, GrowsWithTheSquare) {
  MUELLE_PROPERTY("with kV = 10, 1 m^3 too much stores 5 J; from -4 m^3 at rest it is 8 m^3 too much: 320 J");
  EXPECT_NUMBER_NEAR(submission::volumeEnergy(solid, 3, 10), 5.0, 1e-9);
  EXPECT_NUMBER_NEAR(submission::volumeEnergy(solid, -4, 10), 320.0, 1e-9);
}

TEST(VolumeForce, PullsTheTopDown) {
  MUELLE_PROPERTY("1 m^3 too much with kV = 6: node 3 stands on 4 m^2, which is 4/3 m^3 a metre: 8 N downwards");
  const Vec12 F = submission::volumeForce(solid, 3, 6);
  EXPECT_VECTOR_NEAR(Vec3(F.segment<3>(9)), Vec3(0, 0, -8), 1e-9);
  EXPECT_VECTOR_NEAR(F, four(Vec3(12, 0, 8), Vec3(-12, 6, 0), Vec3(0, -6, 0), Vec3(0, 0, -8)), 1e-9);
}

TEST(NoNetForce, OfAnyOfThem) {
  MUELLE_PROPERTY("the forces of each of the three springs add up to zero, and none of them is zero");
  const Vec9 bending = submission::bendingForce(corner, 0.3, 10), area = submission::areaForce(corner, 3, 10);
  const Vec12 volume = submission::volumeForce(solid, 3, 6);
  for (const Vec9& F : {bending, area}) {
    EXPECT_VECTOR_NEAR(Vec3(F.segment<3>(0) + F.segment<3>(3) + F.segment<3>(6)), Vec3(0, 0, 0), 1e-9);
    EXPECT_GT(F.segment<3>(6).norm(), 0.1);
  }
  EXPECT_VECTOR_NEAR(Vec3(volume.segment<3>(0) + volume.segment<3>(3) + volume.segment<3>(6) + volume.segment<3>(9)),
                     Vec3(0, 0, 0), 1e-9);
  EXPECT_GT(volume.segment<3>(9).norm(), 0.1);
}

TEST(OneLine, HasNoPlane) {
  MUELLE_PROPERTY("three nodes on one line feel no force of bending or area (not NaN), but keep the energies");
  EXPECT_VECTOR_NEAR(submission::bendingForce(line, 0.5, 10), Vec9(Vec9::Zero()), 1e-12);
  EXPECT_VECTOR_NEAR(submission::areaForce(line, 2, 10), Vec9(Vec9::Zero()), 1e-12);
  EXPECT_NUMBER_NEAR(submission::bendingEnergy(line, 0.5, 8), 1.0, 1e-9);
  EXPECT_NUMBER_NEAR(submission::areaEnergy(line, 2, 10), 20.0, 1e-9);
}

TEST(Narrow, AngleKeepsItsDigits) {
  MUELLE_PROPERTY("2 m along x, then 1 m along x and 1e-9 m along y: the line bends by 1e-9 rad");
  EXPECT_NUMBER_NEAR(submission::bendingAngle(three(Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(3, 1e-9, 0))), 1e-9, 1e-15);
}

}  // namespace
