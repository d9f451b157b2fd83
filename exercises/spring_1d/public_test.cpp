#include "course/testing/expect.h"
#include "spring_1d.h"

#include <gtest/gtest.h>

namespace {

TEST(LumpedMass, FourNodesShareTwoKilograms) {
  MUELLE_PROPERTY("2 kg shared out among 4 nodes are 0.5 kg a node");
  EXPECT_NUMBER_NEAR(submission::lumpedMass(2.0, 4), 0.5, 1e-12);
}

TEST(HookeForce, AStretchedSpringPullsAToB) {
  MUELLE_PROPERTY("a spring of 100 N/m stretched by 0.5 m pulls the upper node down with 50 N");
  EXPECT_NUMBER_NEAR(submission::springForceOnA(1.5, 0.0, 100.0, 1.0), -50.0, 1e-9);
}

TEST(HookeForce, ACompressedSpringPushesAFromB) {
  MUELLE_PROPERTY("a spring of 100 N/m compressed by 0.25 m pushes the upper node up with 25 N");
  EXPECT_NUMBER_NEAR(submission::springForceOnA(2.75, 2.0, 100.0, 1.0), 25.0, 1e-9);
}

TEST(CrossedNodes, AStretchedSpringPullsTheLowerNodeUp) {
  MUELLE_PROPERTY("when a is the lower node, a spring stretched by 0.5 m pulls it up with 50 N");
  EXPECT_NUMBER_NEAR(submission::springForceOnA(0.0, 1.5, 100.0, 1.0), 50.0, 1e-9);
}

TEST(ThirdLaw, BFeelsTheOppositeForce) {
  MUELLE_PROPERTY("the stretched spring pulls b up with the 50 N with which it pulls a down");
  EXPECT_NUMBER_NEAR(submission::springForceOnB(1.5, 0.0, 100.0, 1.0), 50.0, 1e-9);
}

TEST(ZeroLength, CoincidentNodesFeelNoForce) {
  MUELLE_PROPERTY("at L = 0 there is no direction, and the force is 0");
  EXPECT_NUMBER_NEAR(submission::springForceOnA(1.0, 1.0, 100.0, 1.0), 0.0, 1e-12);
}

TEST(HangingNode, RestsWhereTheSpringCarriesItsWeight) {
  MUELLE_PROPERTY("2 kg on 100 N/m stretch the spring by 0.2 m (with g = 10 m/s^2) and stay there");
  EXPECT_NUMBER_NEAR(submission::hangingAcceleration(1.8, 2.0, {3.0, 100.0, 1.0}, 10.0), 0.0, 1e-9);
}

TEST(HangingNode, AnUnstretchedSpringLetsItFall) {
  MUELLE_PROPERTY("at the rest length the spring exerts no force: the node falls with g");
  EXPECT_NUMBER_NEAR(submission::hangingAcceleration(2.0, 2.0, {3.0, 100.0, 1.0}, 10.0), -10.0, 1e-9);
}

TEST(NodeBetween, BothSpringsPushItBackToTheMiddle) {
  MUELLE_PROPERTY("0.1 m above the middle, 100 N/m below and 300 N/m above pull 2 kg down with 20 m/s^2 (no gravity)");
  EXPECT_NUMBER_NEAR(submission::accelerationBetween(1.1, 2.0, {0.0, 100.0, 1.0}, {2.0, 300.0, 1.0}, 0.0), -20.0, 1e-9);
}

}  // namespace
