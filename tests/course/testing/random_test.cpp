#include "course/testing/random.h"

#include <gtest/gtest.h>
#include <cmath>
#include <Eigen/LU>

namespace muelle {
namespace {

TEST(Random, RepeatsItselfForOneSeed) {
  Random a(7);
  Random b(7);
  Random c(8);
  const Vec3 first = a.vector3(1.0);
  EXPECT_EQ(first, b.vector3(1.0));
  EXPECT_NE(first, c.vector3(1.0));
  EXPECT_EQ(a.rotation(), b.rotation());
  EXPECT_EQ(a.integer(0, 1000), b.integer(0, 1000));
}

TEST(Random, GivesTheSameNumbersOnEveryPlatform) {
  // std::mt19937_64 is specified to the bit: its 10000th number from the default seed stands in the C++ standard.
  std::mt19937_64 engine;
  engine.discard(9999);
  EXPECT_EQ(engine(), 9981545732273789042ULL);
  // 53 bits of the first number of the seed 1, worked out from the engine alone.
  std::mt19937_64 one(1);
  EXPECT_EQ(Random(1).number(0, 1), std::ldexp(static_cast<double>(one() >> 11), -53));
}

TEST(Random, DrawsNumbersThatCanBeRead) {
  EXPECT_EQ(threeDigits(-0.0123456), -0.0123);
  EXPECT_EQ(threeDigits(98765.0), 98800.0);
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    const double number = random.rounded(2.0, 3.0);
    EXPECT_EQ(number, threeDigits(number));
    const Vec3 direction = random.roundedDirection();
    EXPECT_EQ(direction, threeDigits(direction));
    EXPECT_NEAR(direction.norm(), 1.0, 4e-16);
    EXPECT_GT(direction.cwiseAbs().minCoeff(), 0.2);
  }
}

TEST(Random, DrawsRotations) {
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    const Mat3 R = random.rotation();
    // A product of a few rounded numbers of size 1.
    EXPECT_LT((R * R.transpose() - Mat3::Identity()).norm(), 1e-14);
    EXPECT_NEAR(R.determinant(), 1.0, 1e-14);
  }
}

TEST(Random, DrawsRotationsWithoutPreference) {
  Random random(2);
  Mat3 mean = Mat3::Zero();
  const int n = 20000;
  for (int i = 0; i < n; ++i) mean += random.rotation() / n;
  // Each entry has mean 0 and variance 1/3: six standard deviations of the mean.
  EXPECT_LT(mean.cwiseAbs().maxCoeff(), 6.0 * std::sqrt(1.0 / 3.0 / n));
}

TEST(Random, DrawsDirectionsOfLengthOne) {
  Random random(3);
  Vec3 mean = Vec3::Zero();
  const int n = 20000;
  for (int i = 0; i < n; ++i) {
    const Vec3 u = random.direction();
    ASSERT_NEAR(u.norm(), 1.0, 1e-14);
    mean += u / n;
  }
  EXPECT_LT(mean.cwiseAbs().maxCoeff(), 6.0 * std::sqrt(1.0 / 3.0 / n));
}

TEST(Random, StaysInItsRange) {
  Random random(4);
  bool low = false, high = false;
  for (int i = 0; i < 10000; ++i) {
    const double number = random.number(-2.0, 3.0);
    ASSERT_TRUE(number >= -2.0 && number < 3.0);
    const double positive = random.positive(1e-3, 1e3);
    ASSERT_TRUE(positive >= 1e-3 * (1 - 1e-15) && positive <= 1e3 * (1 + 1e-15));
    const int integer = random.integer(-1, 2);
    ASSERT_TRUE(integer >= -1 && integer <= 2);
    low = low || integer == -1;
    high = high || integer == 2;
    ASSERT_LE(random.vector3(0.5).cwiseAbs().maxCoeff(), 0.5);
  }
  EXPECT_TRUE(low && high);
}

TEST(Random, RoundsToThreeDigits) {
  EXPECT_EQ(threeDigits(0.71938), 0.719);
  EXPECT_EQ(threeDigits(-1234.5), -1230.0);
  EXPECT_EQ(threeDigits(0.99951), 1.0);
  EXPECT_EQ(threeDigits(0.0), 0.0);
}

TEST(TestRandom, DependsOnTheSeedOfTheRunAndOnTheTest) {
  const double before = testRandom().number(0, 1);
  EXPECT_EQ(testRandom().number(0, 1), before);
  setTestSeed(99);
  const double after = testRandom().number(0, 1);
  setTestSeed(20090906);
  EXPECT_NE(after, before);
  EXPECT_EQ(testRandom().number(0, 1), before);
}

double& numberOfTheOtherTest() {
  static double number = -1.0;
  return number;
}

TEST(TestRandom, IsAnotherStreamInEachTestA) { numberOfTheOtherTest() = testRandom().number(0, 1); }
TEST(TestRandom, IsAnotherStreamInEachTestB) { EXPECT_NE(testRandom().number(0, 1), numberOfTheOtherTest()); }

}  // namespace
}  // namespace muelle
