#include "course/testing/expect.h"
#include "stiffness.h"

#include <gtest/gtest.h>

// A spring of 2 m along x between a at the origin and b, with k = 12 N/m. With L0 = 1.5 m its tension is 6 N, which is
// 3 N/m across; with L0 = 3 m it is compressed by 12 N, which is -6 N/m across.

namespace {

using muelle::MatX;

const Vec3 a(0, 0, 0), b(2, 0, 0);

Mat6 blocks(const Vec3& diagonal) {
  Mat6 K = Mat6::Zero();
  for (int i = 0; i < 3; ++i) {
    K(i, i) = K(i + 3, i + 3) = diagonal[i];
    K(i, i + 3) = K(i + 3, i) = -diagonal[i];
  }
  return K;
}

/// Three nodes on the x axis, 2 m apart.
const VecX row{{0, 0, 0, 2, 0, 0, 4, 0, 0}};

/// A node that another one holds by a spring without rest length.
const std::vector<Spring> loose = {{0, 1, 12, 0}};

TEST(SpringHessian, OfASpringAlongX) {
  MUELLE_PROPERTY("12 N/m along the spring, 3 N/m across it: the tension of 6 N over 2 m");
  EXPECT_MATRIX_NEAR(submission::springHessian(a, b, 12, 1.5), blocks(Vec3(12, 3, 3)), 1e-12);
}

TEST(GeometricPart, ChangesItsSign) {
  MUELLE_PROPERTY("at rest there is no stiffness across, compressed by 1 m it is negative: -12 N over 2 m");
  EXPECT_MATRIX_NEAR(submission::springHessian(a, b, 12, 2), blocks(Vec3(12, 0, 0)), 1e-12);
  EXPECT_MATRIX_NEAR(submission::springHessian(a, b, 12, 3), blocks(Vec3(12, -6, -6)), 1e-12);
}

TEST(Blocks, AreSymmetric) {
  MUELLE_PROPERTY("a Hessian is symmetric, and moving both nodes alike changes nothing");
  const Mat6 K = submission::springHessian(Vec3(0.3, -0.7, 0.2), Vec3(1.1, 0.4, -0.6), 12, 1);
  EXPECT_GT(K.cwiseAbs().maxCoeff(), 1);
  EXPECT_MATRIX_NEAR(K, Mat6(K.transpose()), 1e-12);
  EXPECT_MATRIX_NEAR(Mat3(K.topRightCorner<3, 3>()), Mat3(-K.topLeftCorner<3, 3>()), 1e-12);
}

TEST(ElasticForce, PullsTheMiddleBothWays) {
  MUELLE_PROPERTY("springs of 12 and 20 N/m, each stretched by 0.5 m: 6 N and 10 N; the middle feels 10 - 6");
  EXPECT_VECTOR_NEAR(submission::elasticForce(row, {{0, 1, 12, 1.5}, {1, 2, 20, 1.5}}),
                     (VecX{{6, 0, 0, 4, 0, 0, -10, 0, 0}}), 1e-12);
}

TEST(AssembleHessian, AddsUpInTheMiddle) {
  MUELLE_PROPERTY("two springs of 12 and 20 N/m at rest: the middle node has 12 + 20 along x");
  MatX expected = MatX::Zero(9, 9);
  expected(0, 0) = 12, expected(0, 3) = expected(3, 0) = -12;
  expected(3, 3) = 32;
  expected(6, 6) = 20, expected(3, 6) = expected(6, 3) = -20;
  MUELLE_LABEL("assembleHessian", "N/m");
  EXPECT_MATRIX_NEAR(MatX(submission::assembleHessian(row, {{0, 1, 12, 2}, {2, 1, 20, 2}})), expected, 1e-12);
}

TEST(DerivativeOfForce, IsMinusTheHessian) {
  MUELLE_PROPERTY("a moves by 0.001 m along y, across a tension of 6 N over 2 m: its force changes by -0.003 N");
  const VecX x{{0, 0, 0, 2, 0, 0}}, d{{0, 0.001, 0, 0, 0, 0}};
  const VecX ahead = submission::elasticForce(x + d, {{0, 1, 12, 1.5}});
  ASSERT_EQ(ahead.size(), 6);
  MUELLE_LABEL("force on a along y", "N");
  EXPECT_NUMBER_NEAR(ahead[1], -0.003, 1e-6);
  EXPECT_NUMBER_NEAR(-submission::springHessian(a, b, 12, 1.5)(1, 1) * 0.001, -0.003, 1e-6);
}

TEST(ZeroLength, IsAsStiffInEveryDirection) {
  MUELLE_PROPERTY("where both nodes are at one place there is no force, and A is 12 N/m in every direction");
  EXPECT_MATRIX_NEAR(submission::springHessian(b, b, 12, 1.5), blocks(Vec3(12, 12, 12)), 1e-12);
  EXPECT_VECTOR_NEAR(submission::elasticForce((VecX{{2, 0, 0, 2, 0, 0}}), {{0, 1, 12, 1.5}}), VecX(VecX::Zero(6)),
                     1e-12);
}

TEST(BackwardEuler, OfTwoNodesAtRest) {
  MUELLE_PROPERTY("two nodes of 2 kg, 1 m apart on 12 N/m, h = 0.5 s: (2 + 0.25 * 24) dv = 0.5 * 12 gives 0.75 m/s");
  const State next =
      submission::backwardEulerStep({VecX{{0, 0, 0, 1, 0, 0}}, VecX::Zero(6)}, VecX{{2, 2}}, loose, VecX::Zero(6), 0.5);
  {
    MUELLE_LABEL("velocities", "m/s");
    EXPECT_VECTOR_NEAR(next.v, (VecX{{0.75, 0, 0, -0.75, 0, 0}}), 1e-12);
  }
  MUELLE_LABEL("positions", "m");
  EXPECT_VECTOR_NEAR(next.x, (VecX{{0.375, 0, 0, 0.625, 0, 0}}), 1e-12);
}

TEST(Indefinite, IsSolvedAsItIs) {
  MUELLE_PROPERTY(
      "compressed by 12 N: across, 1 kg + 1 s^2 * 2 * -6 N/m = -11 kg, which a push of 11 N moves by -1 m/s");
  const State next = submission::backwardEulerStep({VecX{{0, 0, 0, 2, 0, 0}}, VecX::Zero(6)}, VecX{{1, 1}},
                                                   {{0, 1, 12, 3}}, VecX{{0, 11, 0, 0, -11, 0}}, 1);
  ASSERT_EQ(next.v.size(), 6);
  MUELLE_LABEL("velocity of a along y", "m/s");
  EXPECT_NUMBER_NEAR(next.v[1], -1, 1e-12);
}

/// Two nodes of 2 kg on 16 N/m without rest length: omega = 4 rad/s.
State swung(double h, int steps) {
  State now{VecX{{0.5, 0, 0, -0.5, 0, 0}}, VecX::Zero(6)};
  for (int i = 0; i < steps && now.x.size() == 6; ++i) {
    now = submission::backwardEulerStep(now, VecX{{2, 2}}, {{0, 1, 16, 0}}, VecX::Zero(6), h);
  }
  return now;
}

double energy(const State& now) {
  if (now.x.size() != 6 || now.v.size() != 6) return NAN;
  return 8 * (now.x.head<3>() - now.x.tail<3>()).squaredNorm() + now.v.squaredNorm();
}

TEST(Order, IsOne) {
  MUELLE_PROPERTY("after half a swing the nodes have changed places: half the step is off by half as much");
  const auto error = [](int steps) {
    const State end = swung(M_PI / 4 / steps, steps);
    return end.x.size() == 6 ? std::abs(end.x[0] + 0.5) : NAN;
  };
  MUELLE_LABEL("error with 80 steps over that with 160");
  EXPECT_NUMBER_NEAR(error(80) / error(160), 2, 0.15);
}

TEST(NumericalDamping, DividesTheEnergy) {
  MUELLE_PROPERTY("8 J at the start; with h omega = 0.5 each step divides the energy by 1.25");
  MUELLE_LABEL("energy after 3 steps", "J");
  EXPECT_NUMBER_NEAR(energy(swung(0.125, 3)), 8 / std::pow(1.25, 3), 1e-9);
}

TEST(Stability, HasNoLimit) {
  MUELLE_PROPERTY("with h omega = 40 the swing is gone after one step: 8 J over 1 + 1600");
  MUELLE_LABEL("energy after a step of 10 s", "J");
  EXPECT_NUMBER_NEAR(energy(swung(10, 1)), 8 / 1601.0, 1e-9);
}

TEST(Momentum, ComesFromOutside) {
  MUELLE_PROPERTY("a push of 3 N for 0.5 s is 1.5 kg m/s, whatever the spring does with it");
  const State next = submission::backwardEulerStep({VecX{{0, 0, 0, 1, 0, 0}}, VecX::Zero(6)}, VecX{{2, 4}}, loose,
                                                   VecX{{3, 0, 0, 0, 0, 0}}, 0.5);
  ASSERT_EQ(next.v.size(), 6);
  MUELLE_LABEL("momentum along x", "kg m/s");
  EXPECT_NUMBER_NEAR(2 * next.v[0] + 4 * next.v[3], 1.5, 1e-12);
}

}  // namespace
