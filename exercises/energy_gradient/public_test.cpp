#include "course/testing/expect.h"
#include "energy_gradient.h"

#include <gtest/gtest.h>

// One spring with k = 10 N/m and L0 = 3 m. In 3D, a is at (3, 0, 4) and b at the origin: L = 5 m, and the direction
// from b to a is (0.6, 0, 0.8).

namespace {

Vec6 stacked(const Vec3& xa, const Vec3& xb) {
  Vec6 x;
  x << xa, xb;
  return x;
}

const Vec3 farNode(3, 0, 4);
const Vec3 origin(0, 0, 0);

TEST(EnergyInOneDimension, OfAStretchedSpring) {
  MUELLE_PROPERTY("k = 10, L0 = 3, nodes at 5 and 0: the stretch is 2, the energy 20 J");
  EXPECT_NUMBER_NEAR(submission::springEnergy1d(Vec2(5, 0), 10, 3), 20.0, 1e-9);
}

TEST(EnergyInOneDimension, DoesNotMindTheOrder) {
  MUELLE_PROPERTY("the nodes at 0 and 5 store the same 20 J");
  EXPECT_NUMBER_NEAR(submission::springEnergy1d(Vec2(0, 5), 10, 3), 20.0, 1e-9);
}

TEST(EnergyInSpace, OfAStretchedSpring) {
  MUELLE_PROPERTY("k = 10, L0 = 3, L = 5: the energy is 20 J");
  EXPECT_NUMBER_NEAR(submission::springEnergy(stacked(farNode, origin), 10, 3), 20.0, 1e-9);
}

TEST(LengthGradient, PointsFromBToA) {
  MUELLE_PROPERTY("the gradient of L with respect to xa is a unit vector from b to a");
  EXPECT_VECTOR_NEAR(submission::lengthGradient(farNode, origin), Vec3(0.6, 0, 0.8), 1e-9);
  EXPECT_VECTOR_NEAR(submission::lengthGradient(origin, farNode), Vec3(-0.6, 0, -0.8), 1e-9);
}

TEST(EnergyGradient, HasABlockForEachNode) {
  MUELLE_PROPERTY("pulling a away from b costs 20 N, and so does pulling b away from a");
  Vec6 expected;
  expected << 12, 0, 16, -12, 0, -16;
  EXPECT_VECTOR_NEAR(submission::energyGradient(stacked(farNode, origin), 10, 3), expected, 1e-9);
}

TEST(FiniteDifferences, OfTheEnergyAreTheGradient) {
  MUELLE_PROPERTY(
      "moving the x of a by 1e-4 m to either side changes the energy at the rate of component 0 of the gradient");
  const double h = 1e-4;
  const double forward = submission::springEnergy(stacked(farNode + Vec3(h, 0, 0), origin), 10, 3);
  const double backward = submission::springEnergy(stacked(farNode - Vec3(h, 0, 0), origin), 10, 3);
  EXPECT_NUMBER_NEAR((forward - backward) / (2 * h), 12.0, 1e-6);
  EXPECT_NUMBER_NEAR(submission::energyGradient(stacked(farNode, origin), 10, 3)[0], 12.0, 1e-9);
}

TEST(Forces, PullTheNodesOfAStretchedSpringTogether) {
  MUELLE_PROPERTY("the force on a points to b and the force on b to a, 20 N each");
  Vec6 expected;
  expected << -12, 0, -16, 12, 0, 16;
  EXPECT_VECTOR_NEAR(submission::springForces(stacked(farNode, origin), 10, 3), expected, 1e-9);
}

TEST(CoincidentNodes, HaveEnergyButNoForce) {
  MUELLE_PROPERTY("both nodes at one point: 45 J, and neither gradient nor force");
  const Vec6 x = stacked(farNode, farNode);
  EXPECT_NUMBER_NEAR(submission::springEnergy(x, 10, 3), 45.0, 1e-9);
  EXPECT_VECTOR_NEAR(submission::lengthGradient(farNode, farNode), Vec3(0, 0, 0), 0.0);
  EXPECT_VECTOR_NEAR(submission::springForces(x, 10, 3), Vec6(Vec6::Zero()), 0.0);
}

TEST(TinyLengths, HaveADirection) {
  MUELLE_PROPERTY("a spring of 1e-9 m has a direction");
  EXPECT_VECTOR_NEAR(submission::lengthGradient(Vec3(0, 0, 1e-9), origin), Vec3(0, 0, 1), 1e-9);
}

}  // namespace
