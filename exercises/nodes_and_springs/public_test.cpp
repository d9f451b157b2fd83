#include "course/testing/expect.h"
#include "nodes_and_springs.h"

#include <gtest/gtest.h>

#include <memory>

// Three nodes on a line, of 2 kg each, at x = 0, 3 and 7 m; a spring of 10 N/m from 0 to 1 and one of 5 N/m from 1 to
// 2, both 1 m long at rest. The first is stretched by 2 m and pulls with 20 N, the second by 3 m and pulls with 15 N.

namespace {

const ForceLaw hooke = [](const Vec3& xa, const Vec3& xb, double stiffness, double length) -> Vec3 {
  const double apart = xa[0] - xb[0];  // along the line of x
  return Vec3(apart > 0 ? -stiffness * (apart - length) : -stiffness * (apart + length), 0, 0);
};

const std::vector<NodeData> nodes = {{2, Vec3(0, 0, 0)}, {2, Vec3(3, 0, 0)}, {2, Vec3(7, 0, 0)}};
const std::vector<SpringData> springs = {{0, 1, 10, 1}, {1, 2, 5, 1}};

/// One row a node: its F or its a.
muelle::MatX table(const std::vector<Result>& results, Vec3 Result::*which) {
  muelle::MatX rows(static_cast<Eigen::Index>(results.size()), 3);
  Eigen::Index row = 0;
  for (const Result& result : results) rows.row(row++) = (result.*which).transpose();
  return rows;
}

muelle::MatX alongX(double first, double second, double third) {
  muelle::MatX rows = muelle::MatX::Zero(3, 3);
  rows.col(0) = Vec3(first, second, third);
  return rows;
}

/// Hooke's law above, which counts.
struct Counter {
  std::shared_ptr<int> asked = std::make_shared<int>(0);
  ForceLaw law() const {
    return [asked = asked](const Vec3& xa, const Vec3& xb, double stiffness, double length) {
      ++*asked;
      return hooke(xa, xb, stiffness, length);
    };
  }
};

TEST(GetForce, GivesEachEndItsForce) {
  MUELLE_PROPERTY("a stretched spring pulls its node na to the right with 20 N, and its node nb to the left");
  EXPECT_VECTOR_NEAR(submission::getForce(Vec3(0, 0, 0), Vec3(3, 0, 0), 10, 1, 0, hooke), Vec3(20, 0, 0), 1e-9);
  EXPECT_VECTOR_NEAR(submission::getForce(Vec3(0, 0, 0), Vec3(3, 0, 0), 10, 1, 1, hooke), Vec3(-20, 0, 0), 1e-9);
}

TEST(CalcForce, LeavesTheForceOnNa) {
  MUELLE_PROPERTY("after calcForce, F is the force on na: 20 N to the right");
  EXPECT_VECTOR_NEAR(submission::calcForce(Vec3(0, 0, 0), Vec3(3, 0, 0), 10, 1, hooke), Vec3(20, 0, 0), 1e-9);
}

TEST(CalcAcceleration, IsForceByMass) {
  MUELLE_PROPERTY("a force of (6, -4, 2) N gives 2 kg an acceleration of (3, -2, 1) m/s^2");
  EXPECT_VECTOR_NEAR(submission::calcAcceleration(2, Vec3(6, -4, 2)), Vec3(3, -2, 1), 1e-12);
}

TEST(Gather, OfThreeNodes) {
  MUELLE_PROPERTY("the springs pull with 20 N and 15 N: F is 20, -5 and -15 N, a half of that");
  const std::vector<Result> results = submission::gather(nodes, springs, hooke);
  {
    MUELLE_LABEL("F after gather, one row a node", "N");
    EXPECT_MATRIX_NEAR(table(results, &Result::F), alongX(20, -5, -15), 1e-9);
  }
  MUELLE_LABEL("a after gather, one row a node", "m/s^2");
  EXPECT_MATRIX_NEAR(table(results, &Result::a), alongX(10, -2.5, -7.5), 1e-9);
}

TEST(Scatter, OfThreeNodes) {
  MUELLE_PROPERTY("the springs pull with 20 N and 15 N: F is 20, -5 and -15 N, a half of that");
  const std::vector<Result> results = submission::scatter(nodes, springs, hooke);
  {
    MUELLE_LABEL("F after scatter, one row a node", "N");
    EXPECT_MATRIX_NEAR(table(results, &Result::F), alongX(20, -5, -15), 1e-9);
  }
  MUELLE_LABEL("a after scatter, one row a node", "m/s^2");
  EXPECT_MATRIX_NEAR(table(results, &Result::a), alongX(10, -2.5, -7.5), 1e-9);
}

TEST(BothAlike, GiveTheSameForces) {
  MUELLE_PROPERTY("gather and scatter give node 1 the same force, which is not zero");
  const std::vector<Result> gathered = submission::gather(nodes, springs, hooke);
  const std::vector<Result> scattered = submission::scatter(nodes, springs, hooke);
  {
    MUELLE_LABEL("F after scatter against F after gather, one row a node", "N");
    EXPECT_MATRIX_NEAR(table(scattered, &Result::F), table(gathered, &Result::F), 1e-9);
  }
  MUELLE_LABEL("size of F of node 1", "N");
  EXPECT_NUMBER_NEAR(gathered[1].F.norm(), 5, 1e-9);
}

TEST(Questions, AreTwoASpringOrOne) {
  MUELLE_PROPERTY("with two springs gather asks the law four times, scatter twice");
  const Counter gathering, scattering;
  (void)submission::gather(nodes, springs, gathering.law());
  (void)submission::scatter(nodes, springs, scattering.law());
  {
    MUELLE_LABEL("questions in gather");
    EXPECT_NUMBER_NEAR(*gathering.asked, 4, 0);
  }
  MUELLE_LABEL("questions in scatter");
  EXPECT_NUMBER_NEAR(*scattering.asked, 2, 0);
}

TEST(AtRest, NoForceIsLeft) {
  MUELLE_PROPERTY(
      "a spring of 10 N/m is stretched by 2 m between nodes 0 and 1, one of 5 N/m compressed by 4 m beside it: both "
      "nodes are pulled and pushed with 20 N");
  const std::vector<NodeData> two = {nodes[0], nodes[1]};
  const std::vector<SpringData> sideBySide = {{0, 1, 10, 1}, {1, 0, 5, 7}};
  {
    MUELLE_LABEL("F after gather, one row a node", "N");
    EXPECT_MATRIX_NEAR(table(submission::gather(two, sideBySide, hooke), &Result::F), muelle::MatX::Zero(2, 3), 1e-9);
  }
  MUELLE_LABEL("F after scatter, one row a node", "N");
  EXPECT_MATRIX_NEAR(table(submission::scatter(two, sideBySide, hooke), &Result::F), muelle::MatX::Zero(2, 3), 1e-9);
}

}  // namespace
