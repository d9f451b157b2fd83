#include "course/testing/expect.h"
#include "property_forces.h"

#include <gtest/gtest.h>

// Three nodes at the heights 1, 2 and 6 m: their mean is 3 m. Two nodes of 1 and 4 kg, 5 m apart along x: their centre
// of mass is 4 m from the first and 1 m from the second, and the spread is the root of (1 * 16 + 4 * 1) / 5 = 4 m^2.

namespace {

VecX stacked(const std::vector<Vec3>& nodes) {
  VecX x(3 * nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) x.segment<3>(3 * static_cast<Eigen::Index>(i)) = nodes[i];
  return x;
}

const VecX heights = stacked({Vec3(7, -2, 1), Vec3(4, 0, 2), Vec3(0, 3, 6)});
const VecX pair = stacked({Vec3(1, 0, 3), Vec3(6, 0, 3)});
const VecX masses = Eigen::Vector2d(1, 4);

TEST(MeanHeight, IsTheSumOverTheNumber) {
  MUELLE_PROPERTY("the mean of the heights 1, 2 and 6 m is 3 m");
  EXPECT_NUMBER_NEAR(submission::meanHeight(heights), 3.0, 1e-12);
}

TEST(MeanHeightEnergy, GrowsWithTheDistanceFromTheTarget) {
  MUELLE_PROPERTY("with k = 10, 1 m above the target stores 5 J, 2 m below it 20 J, and at the target it is 0");
  EXPECT_NUMBER_NEAR(submission::meanHeightEnergy(heights, 2, 10), 5.0, 1e-9);
  EXPECT_NUMBER_NEAR(submission::meanHeightEnergy(heights, 5, 10), 20.0, 1e-9);
  EXPECT_NUMBER_NEAR(submission::meanHeightEnergy(heights, 3, 10), 0.0, 1e-9);
}

TEST(MeanHeightForce, PushesAllTowardsTheTarget) {
  MUELLE_PROPERTY(
      "1 m above the target with k = 12: raising one node by 1 m raises the mean by 1/3 m, so -4 N on each");
  EXPECT_VECTOR_NEAR(submission::meanHeightForce(heights, 2, 12),
                     stacked({Vec3(0, 0, -4), Vec3(0, 0, -4), Vec3(0, 0, -4)}), 1e-9);
  EXPECT_VECTOR_NEAR(submission::meanHeightForce(heights, 4.5, 12),
                     stacked({Vec3(0, 0, 6), Vec3(0, 0, 6), Vec3(0, 0, 6)}), 1e-9);
}

TEST(Spread, IsTheRootOfAMeanSquare) {
  MUELLE_PROPERTY("1 kg at 4 m and 4 kg at 1 m from their centre of mass: the spread is 2 m");
  EXPECT_NUMBER_NEAR(submission::spread(pair, masses), 2.0, 1e-9);
}

TEST(SpreadGradient, PointsAwayFromTheCentre) {
  MUELLE_PROPERTY(
      "moving the first node by 1 mm away from the centre adds 0.4 mm to the spread, and so does the second");
  EXPECT_VECTOR_NEAR(submission::spreadGradient(pair, masses), stacked({Vec3(-0.4, 0, 0), Vec3(0.4, 0, 0)}), 1e-9);
}

TEST(SpreadEnergy, GrowsWithTheDistanceFromTheTarget) {
  MUELLE_PROPERTY("with k = 10, 1 m above the target stores 5 J, 3 m below it 45 J");
  EXPECT_NUMBER_NEAR(submission::spreadEnergy(pair, masses, 1, 10), 5.0, 1e-9);
  EXPECT_NUMBER_NEAR(submission::spreadEnergy(pair, masses, 5, 10), 45.0, 1e-9);
}

TEST(SpreadForce, LeadsTowardsTheTarget) {
  MUELLE_PROPERTY(
      "1 m above the target with k = 10: the nodes are pulled together with 4 N; 3 m below, pushed with 12 N");
  EXPECT_VECTOR_NEAR(submission::spreadForce(pair, masses, 1, 10), stacked({Vec3(4, 0, 0), Vec3(-4, 0, 0)}), 1e-9);
  EXPECT_VECTOR_NEAR(submission::spreadForce(pair, masses, 5, 10), stacked({Vec3(-12, 0, 0), Vec3(12, 0, 0)}), 1e-9);
}

TEST(NoNetForce, OfTheSpread) {
  MUELLE_PROPERTY("the forces of the spread add up to zero, and none of them is zero");
  const VecX F = submission::spreadForce(pair, masses, 1, 10);
  ASSERT_EQ(F.size(), 6);
  EXPECT_VECTOR_NEAR(Vec3(F.segment<3>(0) + F.segment<3>(3)), Vec3(0, 0, 0), 1e-9);
  EXPECT_NUMBER_NEAR(F.segment<3>(0).norm(), 4.0, 1e-9);
}

TEST(OnePoint, HasEnergyAndNoForce) {
  MUELLE_PROPERTY(
      "both nodes at one point: no spread and no force (not NaN), but the energy of R0 = 2 m with k = 10: 20 J");
  const VecX x = stacked({Vec3(0.5, -1.25, 2), Vec3(0.5, -1.25, 2)});
  const VecX m = Eigen::Vector2d(1, 1);
  EXPECT_NUMBER_NEAR(submission::spread(x, m), 0.0, 1e-12);
  EXPECT_VECTOR_NEAR(submission::spreadGradient(x, m), VecX(VecX::Zero(6)), 1e-12);
  EXPECT_NUMBER_NEAR(submission::spreadEnergy(x, m, 2, 10), 20.0, 1e-9);
  EXPECT_VECTOR_NEAR(submission::spreadForce(x, m, 2, 10), VecX(VecX::Zero(6)), 1e-12);
}

TEST(TinySpread, HasAGradient) {
  MUELLE_PROPERTY("two equal nodes that are 2e-9 m apart have a spread of 1e-9 m, and its gradient is as long as ever");
  const VecX x = stacked({Vec3(0, 1e-9, 0), Vec3(0, -1e-9, 0)});
  const VecX m = Eigen::Vector2d(3, 3);
  EXPECT_VECTOR_NEAR(submission::spreadGradient(x, m), stacked({Vec3(0, 0.5, 0), Vec3(0, -0.5, 0)}), 1e-9);
}

}  // namespace
