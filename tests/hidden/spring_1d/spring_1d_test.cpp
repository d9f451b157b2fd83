#include "spring_1d.h"

#include "course/testing/expect.h"
#include "course/testing/random.h"
#include "harness/function_system.h"
#include "harness/march.h"
#include "harness/symplectic_euler.h"

#include <gtest/gtest.h>

namespace {

using muelle::FunctionSystem;
using muelle::In;
using muelle::Out;
using muelle::Random;
using muelle::roundOff;
using muelle::Trajectory;

constexpr int caseCount = 12;

/// A spring between a and b whose length differs from L0 by 10 to 60 %, so that no mistake hides in a small number.
struct SpringCase {
  double xa, xb, k, L0;
  /// Of the numbers that the force is made of [N].
  double scale() const { return k * (std::abs(xa) + std::abs(xb) + L0); }
};

enum class Strain { Stretched, Compressed };

/// Cases come in turn, so that every test sees both.
Strain strainOf(int i) { return i % 2 == 0 ? Strain::Stretched : Strain::Compressed; }

/// \param side +1: a is above b; -1: a is below b
SpringCase randomSpring(Random& random, int side, Strain strain) {
  SpringCase spring{};
  spring.k = random.positive(5.0, 500.0);
  spring.L0 = random.number(0.4, 1.6);
  const double change = random.number(0.1, 0.6);
  const double stretch = strain == Strain::Stretched ? change : -change;
  spring.xb = random.number(-2.0, 2.0);
  spring.xa = spring.xb + side * spring.L0 * (1 + stretch);
  return spring;
}

void expectForceOnA(const SpringCase& s) {
  EXPECT_NUMBER_NEAR(submission::springForceOnA(s.xa, s.xb, s.k, s.L0), oracle::springForceOnA(s.xa, s.xb, s.k, s.L0),
                     roundOff(s.scale()));
}

void expectForceOnB(const SpringCase& s) {
  EXPECT_NUMBER_NEAR(submission::springForceOnB(s.xa, s.xb, s.k, s.L0), oracle::springForceOnB(s.xa, s.xb, s.k, s.L0),
                     roundOff(s.scale()));
}

/// A node with a spring to each side, or above only, and the gravity of some planet.
struct NodeCase {
  double x, m;
  Attachment lower, upper;
  double g;
  /// Of the numbers that the acceleration is made of [m/s^2].
  double scale() const { return (scaleOf(lower) + scaleOf(upper)) / m + g; }
  double scaleOf(const Attachment& spring) const { return spring.k * (std::abs(x) + std::abs(spring.x) + spring.L0); }
};

/// \param side +1: the other end is above x
Attachment randomAttachment(Random& random, double x, int side, Strain strain) {
  const SpringCase spring = randomSpring(random, side, strain);
  return {x + (spring.xa - spring.xb), spring.k, spring.L0};
}

NodeCase randomNode(Random& random, int i) {
  NodeCase node{};
  node.x = random.number(-1.0, 1.0);
  node.m = random.positive(0.2, 5.0);
  node.lower = randomAttachment(random, node.x, -1, strainOf(i));
  node.upper = randomAttachment(random, node.x, +1, strainOf(i / 2));
  node.g = random.number(1.0, 20.0);
  return node;
}

void expectHangingAcceleration(const NodeCase& c) {
  EXPECT_NUMBER_NEAR(submission::hangingAcceleration(c.x, c.m, c.upper, c.g),
                     oracle::hangingAcceleration(c.x, c.m, c.upper, c.g), roundOff(c.scale()));
}

void expectAccelerationBetween(const NodeCase& c) {
  EXPECT_NUMBER_NEAR(submission::accelerationBetween(c.x, c.m, c.lower, c.upper, c.g),
                     oracle::accelerationBetween(c.x, c.m, c.lower, c.upper, c.g), roundOff(c.scale()));
}

}  // namespace

// ---------------------------------------------------------------------------------------------------- lumped mass

TEST(LumpedMass, SharesTheMassOutEqually) {
  MUELLE_PROPERTY("each of n nodes gets the n-th part of the total mass");
  Random random = muelle::testRandom();
  for (int i = 0; i < caseCount; ++i) {
    const double M = random.positive(0.1, 50.0);
    const int n = random.integer(2, 40);
    EXPECT_NUMBER_NEAR(submission::lumpedMass(M, n), oracle::lumpedMass(M, n), roundOff(M));
  }
}

TEST(LumpedMass, OneNodeCarriesEverything) {
  MUELLE_PROPERTY("with a single node, its mass is the total mass");
  EXPECT_NUMBER_NEAR(submission::lumpedMass(3.25, 1), 3.25, roundOff(3.25));
}

// --------------------------------------------------------------------------------------------------- force on node a

TEST(HookeForce, FollowsHookesLaw) {
  MUELLE_PROPERTY("the force on the upper node has the size k |L - L0|, down when stretched and up when compressed");
  Random random = muelle::testRandom();
  for (int i = 0; i < caseCount; ++i) expectForceOnA(randomSpring(random, +1, strainOf(i)));
}

TEST(HookeForce, GrowsInProportionToTheDeformation) {
  MUELLE_PROPERTY("at the rest length the force is 0, and every further 1 cm of stretch adds k times 1 cm");
  const double k = 80.0, L0 = 0.7;
  for (int cm = 0; cm <= 10; ++cm) {
    const double stretch = 0.01 * cm;
    EXPECT_NUMBER_NEAR(submission::springForceOnA(0.3 + L0 + stretch, 0.3, k, L0), -k * stretch, roundOff(k));
  }
}

TEST(CrossedNodes, TheForceFollowsTheOrderOfTheNodes) {
  MUELLE_PROPERTY("with a below b, a stretched spring pulls a up and a compressed one pushes it down");
  Random random = muelle::testRandom();
  for (int i = 0; i < caseCount; ++i) expectForceOnA(randomSpring(random, -1, strainOf(i)));
}

TEST(CrossedNodes, TheForceTurnsRoundWhenANodeCrosses) {
  MUELLE_PROPERTY("a compressed spring pushes a away from b on either side of b");
  for (const double x : {-0.9, -0.5, -0.1, 0.1, 0.5, 0.9}) expectForceOnA({2 + x, 2, 60.0, 1.0});
}

// ----------------------------------------------------------------------------------------------------- force on node b

TEST(ThirdLaw, BFeelsTheOppositeOfA) {
  MUELLE_PROPERTY("the forces on the two nodes of a spring add up to 0");
  Random random = muelle::testRandom();
  for (int i = 0; i < caseCount; ++i) {
    const SpringCase s = randomSpring(random, i % 4 < 2 ? +1 : -1, strainOf(i));
    const double onA = submission::springForceOnA(s.xa, s.xb, s.k, s.L0);
    EXPECT_NUMBER_NEAR(submission::springForceOnB(s.xa, s.xb, s.k, s.L0), -onA, roundOff(s.scale()));
    expectForceOnB(s);
  }
}

TEST(ThirdLaw, MomentumIsConserved) {
  MUELLE_PROPERTY("two free nodes on a spring keep their total momentum");
  const double ma = 1.0, mb = 3.0, k = 40.0, L0 = 1.0;
  const auto momentum = [&](auto&& onA, auto&& onB) {
    const FunctionSystem system({ma, mb}, [&](double, In x, In, Out f) {
      f[0] = onA(x[0], x[1], k, L0);
      f[1] = onB(x[0], x[1], k, L0);
    });
    const muelle::MarchOptions options{.h = 5e-3, .duration = 1.0, .outputEvery = 10, .probes = {}, .label = ""};
    return muelle::march(system, {0.0, {1.4, 0.0}, {0.2, -0.5}, {}}, options);
  };
  const Trajectory run = momentum(submission::springForceOnA, submission::springForceOnB);
  const Trajectory reference = momentum(given::springForceOnA, oracle::springForceOnB);
  ASSERT_EQ(run.t.size(), reference.t.size()) << "the simulation stopped early: " << run.stop.message;
  for (std::size_t i = 0; i < run.t.size(); ++i) {
    // The method adds h (Fa + Fb) to the momentum in a step: nothing but rounding when the forces are opposite.
    EXPECT_NUMBER_NEAR(ma * run.v[i][0] + mb * run.v[i][1], ma * 0.2 - mb * 0.5, roundOff(ma + mb));
    EXPECT_NUMBER_NEAR(run.x[i][0] - run.x[i][1], reference.x[i][0] - reference.x[i][1], roundOff(1.4));
  }
}

// ------------------------------------------------------------------------------------------------------------- edges

TEST(ZeroLength, CoincidentNodesFeelNoForce) {
  MUELLE_PROPERTY("when the nodes coincide the force on both is 0, whatever the rest length");
  Random random = muelle::testRandom();
  for (int i = 0; i < 4; ++i) {
    const double x = random.number(-2.0, 2.0), k = random.positive(5.0, 500.0);
    for (const double L0 : {random.number(0.4, 1.6), 0.0}) {
      EXPECT_NUMBER_NEAR(submission::springForceOnA(x, x, k, L0), 0.0, roundOff(k));
      EXPECT_NUMBER_NEAR(submission::springForceOnB(x, x, k, L0), 0.0, roundOff(k));
    }
    for (const double L : {-0.3, 0.3}) {  // on either side of b there is a force again
      expectForceOnA({x + L, x, k, 0.8});
      expectForceOnB({x + L, x, k, 0.8});
    }
  }
}

TEST(ZeroLength, ANodeOnAnAnchorFeelsTheOtherSpringOnly) {
  MUELLE_PROPERTY("a node on the end of one spring is accelerated by the other spring alone");
  Random random = muelle::testRandom();
  for (int i = 0; i < 4; ++i) {
    NodeCase onLower = randomNode(random, i);
    onLower.g = 0.0;  // leaves the springs alone: gravity has its own criteria
    NodeCase onUpper = onLower;
    onLower.lower.x = onLower.x;
    onUpper.upper.x = onUpper.x;
    expectAccelerationBetween(onLower);
    expectHangingAcceleration(onLower);
    expectAccelerationBetween(onUpper);
    expectHangingAcceleration(onUpper);
    std::swap(onUpper.lower, onUpper.upper);
    expectAccelerationBetween(onUpper);
    expectHangingAcceleration(onUpper);
  }
}

TEST(ZeroLength, ASpringWithoutRestLengthPullsAllTheWay) {
  MUELLE_PROPERTY("with L0 = 0 the force is -k (xa - xb): it fades to 0 at L = 0 and there only");
  const double k = 30.0;
  for (const double x : {-0.5, -0.25, 0.0, 0.25, 0.5}) {
    EXPECT_NUMBER_NEAR(submission::springForceOnA(1 + x, 1.0, k, 0.0), -k * x, roundOff(k));
    EXPECT_NUMBER_NEAR(submission::springForceOnB(1 + x, 1.0, k, 0.0), k * x, roundOff(k));
  }
}

TEST(ShortSpring, EveryPositiveLengthHasADirection) {
  MUELLE_PROPERTY("a spring of 1e-9 m, or of 1e-100 m, still pushes its nodes apart with k (L0 - L)");
  Random random = muelle::testRandom();
  for (const double L : {3e-3,  3e-4,  3e-5,  3e-6,  3e-7,  3e-8,  3e-9,  3e-10, 3e-11, 3e-12, 3e-13, 3e-14,
                         3e-15, 3e-16, 3e-17, 3e-18, 3e-21, 1e-25, 1e-35, 1e-45, 1e-60, 1e-80, 1e-100}) {
    const double k = random.positive(5.0, 500.0), L0 = random.number(0.4, 1.6);
    // b stands at 0: beside it, positions so near to each other are different numbers.
    for (const double xa : {L, -L}) {
      expectForceOnA({xa, 0.0, k, L0});
      expectForceOnB({xa, 0.0, k, L0});
    }
  }
  for (int i = 0; i < 4; ++i) {  // longer ones too, so that a mistake that is not about short springs keeps its name
    const SpringCase s = randomSpring(random, i < 2 ? +1 : -1, strainOf(i));
    expectForceOnA(s);
    expectForceOnB(s);
  }
}

// ----------------------------------------------------------------------------------------------------- accelerations

TEST(HangingNode, FollowsNewtonsSecondLaw) {
  MUELLE_PROPERTY("m a is the force of the spring plus the weight");
  Random random = muelle::testRandom();
  for (int i = 0; i < caseCount; ++i) expectHangingAcceleration(randomNode(random, i));
}

TEST(HangingNode, RestsWhereTheSpringCarriesItsWeight) {
  MUELLE_PROPERTY(
      "a node that stretches its spring by m g / k does not accelerate; below that it goes up, above it down");
  Random random = muelle::testRandom();
  for (int i = 0; i < 4; ++i) {
    const double m = random.positive(0.2, 2.0), g = random.number(5.0, 15.0), k = random.positive(50.0, 200.0);
    const Attachment top{random.number(-1.0, 1.0), k, 1.0};
    const double equilibrium = top.x - top.L0 - m * g / k;
    for (const double y : {-0.2, 0.0, 0.2}) {
      EXPECT_NUMBER_NEAR(submission::hangingAcceleration(equilibrium + y, m, top, g),
                         oracle::hangingAcceleration(equilibrium + y, m, top, g), roundOff(k * 4 / m + g));
    }
  }
}

TEST(HangingNode, MayStandAboveItsSpring) {
  MUELLE_PROPERTY("a node above the end of its spring is pushed or pulled along the spring too");
  Random random = muelle::testRandom();
  for (int i = 0; i < 4; ++i) {
    NodeCase node = randomNode(random, i);
    node.upper = node.lower;
    expectHangingAcceleration(node);
  }
}

TEST(NodeBetween, AddsTheForcesOfBothSprings) {
  MUELLE_PROPERTY("m a is the sum of both springs' forces and the weight");
  Random random = muelle::testRandom();
  for (int i = 0; i < caseCount; ++i) expectAccelerationBetween(randomNode(random, i));
}

TEST(NodeBetween, FallsFreelyWhenBothSpringsAreAtRest) {
  MUELLE_PROPERTY("springs at their rest lengths exert no force: the acceleration is -g, whatever the mass");
  Random random = muelle::testRandom();
  for (int i = 0; i < 4; ++i) {
    const NodeCase node = randomNode(random, i);
    const Attachment lower{node.x - node.lower.L0, node.lower.k, node.lower.L0};
    const Attachment upper{node.x + node.upper.L0, node.upper.k, node.upper.L0};
    EXPECT_NUMBER_NEAR(submission::accelerationBetween(node.x, node.m, lower, upper, node.g),
                       oracle::accelerationBetween(node.x, node.m, lower, upper, node.g), roundOff(node.scale()));
  }
}

TEST(NodeBetween, DoesNotCareWhichEndIsAbove) {
  MUELLE_PROPERTY("exchanging the two springs changes nothing, nor does a node that has crossed an end");
  Random random = muelle::testRandom();
  for (int i = 0; i < 4; ++i) {
    NodeCase node = randomNode(random, i);
    std::swap(node.lower, node.upper);
    expectAccelerationBetween(node);
    node.lower = randomAttachment(random, node.x, -1, strainOf(i));
    node.upper = randomAttachment(random, node.x, -1, strainOf(i));
    expectAccelerationBetween(node);
  }
}

// -------------------------------------------------------------------------------------------------------- simulations

namespace {

using Acceleration = std::function<double(double x)>;

constexpr double step = 2e-3;  // [s]

/// A node of mass m that starts at rest at x.
Trajectory swing(const Acceleration& acceleration, double m, double x, double duration) {
  const FunctionSystem system({m}, [&](double, In position, In, Out f) { f[0] = m * acceleration(position[0]); });
  const muelle::MarchOptions options{.h = step, .duration = duration, .outputEvery = 5, .probes = {}, .label = ""};
  return muelle::march(system, {0.0, {x}, {0.0}, {}}, options);
}

/// Compares a swing of the submission with that of the oracle, and its energy with the energy at the start.
void expectOscillation(const Trajectory& run, const Trajectory& reference, double equilibrium, double omega) {
  ASSERT_EQ(run.t.size(), reference.t.size()) << "the simulation stopped early: " << run.stop.message;
  const double amplitude = std::abs(reference.x[0][0] - equilibrium);
  const double startEnergy = omega * omega * amplitude * amplitude / 2;  // per mass
  // With y = x - equilibrium and z = h omega, the method conserves Q = v^2 + omega^2 y^2 - z omega y v exactly. As
  // |omega y v| <= (v^2 + omega^2 y^2) / 2 = e, every e lies between Q / (2 + z) and Q / (2 - z); from rest Q = 2 e(0).
  const double z = step * omega;
  const double energyBound = startEnergy * z / (2 - z);
  for (std::size_t i = 0; i < run.t.size(); ++i) {
    const double y = run.x[i][0] - equilibrium;
    const double v = run.v[i][0];
    // Same method and steps: only rounding differs, some 1e-15 a step, and an oscillator does not amplify it.
    EXPECT_NUMBER_NEAR(run.x[i][0], reference.x[i][0], roundOff(10.0));
    EXPECT_NUMBER_NEAR((v * v + omega * omega * y * y) / 2, startEnergy, energyBound + roundOff(startEnergy));
  }
}

}  // namespace

TEST(Oscillator, AHangingNodeSwingsAboutItsEquilibrium) {
  MUELLE_PROPERTY("a hanging node follows the reference curve and keeps its energy");
  const double m = 0.4, g = 9.81;
  const Attachment top{2.0, 25.0, 0.8};
  const double equilibrium = top.x - top.L0 - m * g / top.k;
  const double omega = std::sqrt(top.k / m), period = 2 * M_PI / omega;
  const auto run = [&](auto&& acceleration) {
    return swing([&](double x) { return acceleration(x, m, top, g); }, m, equilibrium - 0.3, 2 * period);
  };
  expectOscillation(run(submission::hangingAcceleration), run(oracle::hangingAcceleration), equilibrium, omega);
}

TEST(Oscillator, AStandingNodeSwingsAboutItsEquilibrium) {
  MUELLE_PROPERTY("a node that stands on its spring follows the reference curve and keeps its energy");
  const double m = 0.4, g = 9.81;
  const Attachment bottom{0.2, 30.0, 0.9};
  const double equilibrium = bottom.x + bottom.L0 - m * g / bottom.k;
  const double omega = std::sqrt(bottom.k / m), period = 2 * M_PI / omega;
  const auto run = [&](auto&& acceleration) {
    return swing([&](double x) { return acceleration(x, m, bottom, g); }, m, equilibrium + 0.3, period);
  };
  expectOscillation(run(submission::hangingAcceleration), run(oracle::hangingAcceleration), equilibrium, omega);
}

TEST(Oscillator, ANodeBetweenTwoSpringsSwingsAboutItsEquilibrium) {
  MUELLE_PROPERTY("a node between two springs follows the reference curve and keeps its energy");
  const double m = 0.5, g = 9.81;
  const Attachment lower{0.0, 40.0, 1.1}, upper{2.1, 60.0, 0.7};
  const double k = lower.k + upper.k;  // two springs side by side
  const double equilibrium = (lower.k * (lower.x + lower.L0) + upper.k * (upper.x - upper.L0) - m * g) / k;
  const double omega = std::sqrt(k / m), period = 2 * M_PI / omega;
  const auto run = [&](auto&& acceleration) {
    return swing([&](double x) { return acceleration(x, m, lower, upper, g); }, m, equilibrium + 0.2, 2 * period);
  };
  expectOscillation(run(submission::accelerationBetween), run(oracle::accelerationBetween), equilibrium, omega);
}
