#include "spring_1d.h"

#include "course/testing/expect.h"
#include "course/testing/random.h"
#include "grader/testing/ladders.h"
#include "grader/testing/of_use.h"
#include "harness/function_system.h"
#include "harness/march.h"
#include "harness/symplectic_euler.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace {

using muelle::FunctionSystem;
using muelle::In;
using muelle::Out;
using muelle::Random;
using muelle::roundOff;
using muelle::Trajectory;

constexpr int caseCount = 12;

/// For what is about structure, not digits: single precision, 1e-7 of the numbers a force is made of, and difference
/// quotients do not break it.
constexpr double ofStructure = 1e-6;

/// Of three digits, as all numbers that a student may have to type.
double number(Random& random, double low, double high) { return muelle::threeDigits(random.number(low, high)); }
double positive(Random& random, double low, double high) { return muelle::threeDigits(random.positive(low, high)); }

/// A spring between a and b.
struct SpringCase {
  double xa, xb, k, L0;
  /// Of the numbers that the force is made of [N]. Not of the positions: their difference is exact to round-off.
  double scale() const { return k * (std::abs(xa - xb) + L0); }
};

enum class Strain { Stretched, Compressed };

/// Cases come in turn, so that every test sees both.
Strain strainOf(int i) { return i % 2 == 0 ? Strain::Stretched : Strain::Compressed; }

/// Its length differs from L0 by 10 to 60 %, so that no mistake hides in a small number.
/// \param side +1: a is above b; -1: a is below b
SpringCase randomSpring(Random& random, int side, Strain strain) {
  SpringCase spring{};
  spring.k = positive(random, 5.0, 500.0);
  spring.L0 = number(random, 0.4, 1.6);
  const double change = random.number(0.1, 0.6);
  const double stretch = strain == Strain::Stretched ? change : -change;
  spring.xb = number(random, -2.0, 2.0);
  spring.xa = muelle::threeDigits(spring.xb + side * spring.L0 * (1 + stretch));
  return spring;
}

/// The ends of the contract's ranges and their corners, with a above b.
const SpringCase corners[] = {
    {1000, -1000, 1e9, 0},   {1000, -1000, 1e-3, 1000}, {1000, 999.25, 310, 0},   {-998.4, -1000, 7.3, 1000},
    {0.37, -0.81, 1e-3, 0},  {0.37, -0.81, 1e9, 0},     {0.37, -0.81, 1e9, 1000}, {0.37, -0.81, 1e-3, 0.66},
    {0.37, -0.81, 73, 1000}, {1.83, 0.19, 2.9e5, 0.47}, {-0.29, -3.31, 0.037, 0}, {0.0, -0.43, 41, 0},
    {0.43, 0.0, 41, 0.78},
};

SpringCase exchanged(const SpringCase& s) { return {s.xb, s.xa, s.k, s.L0}; }

void expectForceOnA(const SpringCase& s) {
  EXPECT_NUMBER_NEAR(submission::springForceOnA(s.xa, s.xb, s.k, s.L0), oracle::springForceOnA(s.xa, s.xb, s.k, s.L0),
                     roundOff(s.scale()));
}

/// A node with a spring to each side, or above only, and the gravity of some planet.
struct NodeCase {
  double x, m;
  Attachment lower, upper;
  double g;
  /// Of the numbers that the acceleration is made of [m/s^2].
  double scale() const { return (scaleOf(lower) + scaleOf(upper)) / m + g; }
  double scaleOf(const Attachment& spring) const { return spring.k * (std::abs(x - spring.x) + spring.L0); }
};

/// \param side +1: the other end is above x
Attachment randomAttachment(Random& random, double x, int side, Strain strain) {
  const SpringCase spring = randomSpring(random, side, strain);
  return {muelle::threeDigits(x + (spring.xa - spring.xb)), spring.k, spring.L0};
}

NodeCase randomNode(Random& random, int i) {
  NodeCase node{};
  node.x = number(random, -1.0, 1.0);
  node.m = positive(random, 0.2, 5.0);
  node.lower = randomAttachment(random, node.x, -1, strainOf(i));
  node.upper = randomAttachment(random, node.x, +1, strainOf(i / 2));
  node.g = number(random, 3.0, 20.0);
  return node;
}

/// The ends of the contract's ranges and their corners: light and heavy, soft and hard, on either side.
const NodeCase nodeCorners[] = {
    {1000, 1e-6, {-1000, 1e-3, 0}, {-1000, 1e9, 1000}, 1000},
    {-1000, 1e6, {1000, 1e9, 1000}, {1000, 1e-3, 0}, 0},
    {-0.63, 1e-6, {-1.47, 37, 0.31}, {0.29, 410, 1.13}, 8.37},
    {-0.63, 1e6, {-1.47, 2.9e5, 0.31}, {0.29, 1e9, 1.13}, 8.37},
    {0.71, 3.7e-4, {-0.47, 7.3, 0}, {1.29, 0.037, 0}, 0},
    {0.71, 430, {1.63, 1e9, 0}, {0.23, 1e9, 0}, 1000},
    {0.0, 0.43, {-0.38, 41, 0.77}, {0.94, 67, 0}, 5.3},
};

void expectHangingAcceleration(const NodeCase& c) {
  EXPECT_NUMBER_NEAR(submission::hangingAcceleration(c.x, c.m, c.upper, c.g),
                     oracle::hangingAcceleration(c.x, c.m, c.upper, c.g), roundOff(c.scaleOf(c.upper) / c.m + c.g));
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
    const double M = positive(random, 0.1, 50.0);
    const int n = random.integer(2, 40);
    EXPECT_NUMBER_NEAR(submission::lumpedMass(M, n), oracle::lumpedMass(M, n), roundOff(M / n));
  }
}

TEST(LumpedMass, HoldsForOneNodeAndForMany) {
  MUELLE_PROPERTY("a single node carries everything; two carry half each; light and heavy objects are shared alike");
  for (const double M : {1e-3, 0.037, 3.25, 710.0, 1e6}) {
    for (const int n : {1, 2, 3, 1000}) {
      EXPECT_NUMBER_NEAR(submission::lumpedMass(M, n), oracle::lumpedMass(M, n), roundOff(M / n));
    }
  }
}

// --------------------------------------------------------------------------------------------------- force on node a

TEST(HookeForce, FollowsHookesLaw) {
  MUELLE_PROPERTY("the force on the upper node has the size k |L - L0|, down when stretched and up when compressed");
  Random random = muelle::testRandom();
  for (int i = 0; i < caseCount; ++i) expectForceOnA(randomSpring(random, +1, strainOf(i)));
}

TEST(HookeForce, GrowsInProportionToTheDeformation) {
  MUELLE_PROPERTY("at the rest length the force is 0, and every further 1 cm of stretch adds k times 1 cm");
  for (int cm = 0; cm <= 10; ++cm) expectForceOnA({muelle::threeDigits(0.31 + 0.73 + 0.01 * cm), 0.31, 83.0, 0.73});
}

TEST(HookeForce, HoldsForEverySpring) {
  MUELLE_PROPERTY("soft, hard, long springs and those of rest length 0 follow the same law");
  for (const SpringCase& corner : corners) expectForceOnA(corner);
}

TEST(CrossedNodes, TheForceFollowsTheOrderOfTheNodes) {
  MUELLE_PROPERTY("with a below b, a stretched spring pulls a up and a compressed one pushes it down");
  Random random = muelle::testRandom();
  for (int i = 0; i < caseCount; ++i) expectForceOnA(randomSpring(random, -1, strainOf(i)));
}

TEST(CrossedNodes, TheForceTurnsRoundWhenANodeCrosses) {
  MUELLE_PROPERTY("a compressed spring pushes a away from b on either side of b");
  for (const double xa : {1.41, 1.83, 2.24, 2.46, 2.87, 3.29}) expectForceOnA({xa, 2.33, 61.0, 1.13});
}

TEST(CrossedNodes, HoldsForEverySpring) {
  MUELLE_PROPERTY("soft, hard, long springs and those of rest length 0 follow the order of their nodes too");
  for (const SpringCase& corner : corners) expectForceOnA(exchanged(corner));
}

// ----------------------------------------------------------------------------------------------------- force on node b

namespace {

void expectOpposite(const SpringCase& s) {
  const double onA = submission::springForceOnA(s.xa, s.xb, s.k, s.L0);
  EXPECT_NUMBER_NEAR(submission::springForceOnB(s.xa, s.xb, s.k, s.L0), -onA, ofStructure * s.scale());
}

}  // namespace

TEST(ThirdLaw, BFeelsTheOppositeOfA) {
  MUELLE_PROPERTY("the forces on the two nodes of a spring add up to 0");
  MUELLE_EXPECT_OF_USE(springForceOnB);
  Random random = muelle::testRandom();
  for (int i = 0; i < caseCount; ++i) expectOpposite(randomSpring(random, i % 4 < 2 ? +1 : -1, strainOf(i)));
  for (const SpringCase& corner : corners) {
    expectOpposite(corner);
    expectOpposite(exchanged(corner));
  }
}

TEST(ThirdLaw, MomentumIsConserved) {
  MUELLE_PROPERTY("two free nodes on a spring keep their total momentum");
  const double ma = 1.3, mb = 2.9, k = 43.0, L0 = 0.9;
  const FunctionSystem system({ma, mb}, [&](double, In x, In, Out f) {
    f[0] = submission::springForceOnA(x[0], x[1], k, L0);
    f[1] = submission::springForceOnB(x[0], x[1], k, L0);
  });
  const muelle::MarchOptions options{.h = 5e-3, .duration = 1.0, .outputEvery = 10, .probes = {}, .label = ""};
  const Trajectory run = muelle::march(system, {0.0, {1.37, -0.11}, {0.21, -0.53}, {}}, options);
  double largest = 0;  // a wrong force may drive the nodes apart: rounding is that of their momenta so far
  for (std::size_t i = 0; i < run.t.size(); ++i) {
    // The method adds h (Fa + Fb) to the momentum in a step: nothing but rounding when the forces are opposite.
    largest = std::max(largest, ma * std::abs(run.v[i][0]) + mb * std::abs(run.v[i][1]));
    MUELLE_LABEL(fmt::format("momentum of both nodes at t = {:.2f} s", run.t[i]), "kg m/s");
    EXPECT_NUMBER_NEAR(ma * run.v[i][0] + mb * run.v[i][1], ma * 0.21 - mb * 0.53, ofStructure * largest);
  }
}

// ------------------------------------------------------------------------------------------------------------- edges
// An edge is lost by what is wrong there, not by what is wrong everywhere: a function that is right in general
// position must be right on the edge too; of another one the edge asks only what its own answers elsewhere imply.

namespace {

bool areNear(double a, double b, double tolerance) { return std::abs(a - b) <= tolerance; }

bool hangingIsRight(Random random) {
  for (int i = 0; i < 4; ++i) {
    NodeCase c = randomNode(random, i);
    if (i >= 2) c.upper = c.lower;
    const double own = submission::hangingAcceleration(c.x, c.m, c.upper, c.g);
    if (!areNear(own, oracle::hangingAcceleration(c.x, c.m, c.upper, c.g), roundOff(c.scale()))) return false;
  }
  return true;
}

bool betweenIsRight(Random random) {
  for (int i = 0; i < 4; ++i) {
    const NodeCase c = randomNode(random, i);
    const double own = submission::accelerationBetween(c.x, c.m, c.lower, c.upper, c.g);
    if (!areNear(own, oracle::accelerationBetween(c.x, c.m, c.lower, c.upper, c.g), roundOff(c.scale()))) return false;
  }
  return true;
}

Attachment onNode(const Attachment& spring, double x) { return {x, spring.k, spring.L0}; }
Attachment atRest(const Attachment& spring, double x) { return {x + spring.L0, spring.k, spring.L0}; }
Attachment softest(const Attachment& spring) { return {spring.x, 1e-3, spring.L0}; }

/// Without gravity: a spring that exerts no force changes nothing, so that the acceleration is 0, or the one of a
/// spring at its rest length.
void expectOwnHangingOnAnchor(const NodeCase& c) {
  const double own = submission::hangingAcceleration(c.x, c.m, onNode(c.upper, c.x), 0.0);
  if (areNear(own, 0.0, roundOff(c.scale()))) return;
  MUELLE_LABEL("acceleration on the anchor, without gravity, against your acceleration at the rest length", "m/s^2");
  EXPECT_NUMBER_NEAR(own, submission::hangingAcceleration(c.x, c.m, atRest(c.upper, c.x), 0.0), roundOff(c.scale()));
}

/// Without gravity: the acceleration is the same whatever the stiffness of the spring whose end is at the node, or the
/// same as with that spring at its rest length.
void expectOwnBetweenOnAnchor(const NodeCase& c, bool onLower, bool onUpper) {
  const auto own = [&](const Attachment& lower, const Attachment& upper) {
    return submission::accelerationBetween(c.x, c.m, lower, upper, 0.0);
  };
  const Attachment lower = onLower ? onNode(c.lower, c.x) : c.lower;
  const Attachment upper = onUpper ? onNode(c.upper, c.x) : c.upper;
  const double answer = own(lower, upper);
  const double soft = own(onLower ? softest(lower) : lower, onUpper ? softest(upper) : upper);
  if (areNear(answer, soft, roundOff(c.scale()))) return;
  const double rest = own(onLower ? atRest(lower, c.x) : lower, onUpper ? atRest(upper, c.x) : upper);
  MUELLE_LABEL("acceleration on an anchor, without gravity, against yours with that spring at its rest length",
               "m/s^2");
  EXPECT_NUMBER_NEAR(answer, rest, roundOff(c.scale()));
}

void expectBetweenOnAnchor(const NodeCase& c, bool isRight, bool onLower, bool onUpper) {
  if (!isRight) return expectOwnBetweenOnAnchor(c, onLower, onUpper);
  NodeCase edge = c;
  if (onLower) edge.lower.x = c.x;
  if (onUpper) edge.upper.x = c.x;
  expectAccelerationBetween(edge);
}

}  // namespace

TEST(ZeroLength, CoincidentNodesFeelNoForce) {
  MUELLE_PROPERTY("when the nodes coincide the force on both is 0, whatever the rest length");
  MUELLE_EXPECT_ANSWERS(springForceOnA);
  MUELLE_EXPECT_ANSWERS(springForceOnB);
  Random random = muelle::testRandom();
  for (const double x : {number(random, -2.0, 2.0), number(random, -2.0, 2.0), 0.0, 1.0, 1000.0, -1000.0}) {
    for (const double k : {1e-3, positive(random, 5.0, 500.0), 1e9}) {
      for (const double L0 : {0.0, number(random, 0.4, 1.6), 1000.0}) {
        EXPECT_NUMBER_NEAR(submission::springForceOnA(x, x, k, L0), 0.0, ofStructure * k * (1 + L0));
        EXPECT_NUMBER_NEAR(submission::springForceOnB(x, x, k, L0), 0.0, ofStructure * k * (1 + L0));
      }
    }
  }
}

TEST(ZeroLength, AHangingNodeOnItsAnchorFallsFreely) {
  MUELLE_PROPERTY("a node on the end of its spring feels no force of it: it falls freely");
  MUELLE_EXPECT_ANSWERS(hangingAcceleration);
  Random random = muelle::testRandom();
  const bool isRight = hangingIsRight(random);
  for (int i = 0; i < 6; ++i) {
    NodeCase c = randomNode(random, i);
    if (!isRight) {
      expectOwnHangingOnAnchor(c);
      continue;
    }
    if (i >= 3) c.upper.L0 = i == 3 ? 0.0 : 1000.0;
    if (i == 5) c.g = 0.0;
    c.upper.x = c.x;
    expectHangingAcceleration(c);
  }
}

TEST(ZeroLength, ANodeOnAnAnchorFeelsTheOtherSpringOnly) {
  MUELLE_PROPERTY("a node on the end of one spring is accelerated by the other spring and gravity alone");
  MUELLE_EXPECT_ANSWERS(accelerationBetween);
  Random random = muelle::testRandom();
  const bool isRight = betweenIsRight(random);
  for (int i = 0; i < 4; ++i) {
    const NodeCase c = randomNode(random, i);
    expectBetweenOnAnchor(c, isRight, true, false);
    expectBetweenOnAnchor(c, isRight, false, true);
    expectBetweenOnAnchor(c, isRight, true, true);
  }
}

TEST(ZeroLength, NorDoesASpringWithoutRestLengthPullThere) {
  MUELLE_PROPERTY("on the end of a spring with L0 = 0 the other spring acts alone");
  MUELLE_EXPECT_ANSWERS(accelerationBetween);
  Random random = muelle::testRandom();
  if (!betweenIsRight(random)) return;  // the expectations above are for those
  for (int i = 0; i < 4; ++i) {
    NodeCase c = randomNode(random, i);
    c.lower.L0 = i % 2 == 0 ? 0.0 : c.lower.L0;
    c.upper.L0 = i < 3 ? c.upper.L0 : 0.0;
    expectBetweenOnAnchor(c, true, i % 2 == 0, i % 2 == 1);
    expectBetweenOnAnchor(c, true, true, true);
  }
}

namespace {

/// What acts on a node at the signed distance r from the other end of its springs.
using OfDistance = std::function<double(double r)>;

/// Where the other end of a short spring stands, and how short the springs there are [m].
struct Place {
  double end;
  std::vector<double> lengths;
};

/// Beside 0 positions as near as 1e-100 m are different numbers; beside 1 those that differ by 2^-k are.
const Place places[] = {{0.0, muelle::grader::lengthLadder(1e-100)}, {1.0, muelle::grader::exactLengthLadder()}};

/// A function of a short spring, the student's and the right one.
struct ShortSpringCase {
  std::string what, unit;  ///< "force on a", "N"
  OfDistance own, right;
  std::function<double(double L)> scale;  ///< of the numbers that the answer is made of

  bool isRightElsewhere() const {
    for (const double r : {0.23, -0.23, 0.31, -0.31, 1.93, -1.93}) {
      if (!areNear(own(r), right(r), roundOff(scale(std::abs(r))))) return false;
    }
    return true;
  }

  /// Relative to the numbers the answer is made of, however small they are.
  void expectRight(double r) const {
    MUELLE_LABEL(fmt::format("{} of a spring of {} m", what, std::abs(r)), unit);
    EXPECT_NUMBER_NEAR(own(r), right(r), roundOff(scale(std::abs(r))));
  }

  /// Short springs are alike: what is wrong in all of them is, like the right force, a power of their length, constant
  /// for most mistakes. Each answer follows from the one before to 20 %: from 3 mm on, 1 - L / L0 changes by 1 % at
  /// most, and a length that is softened or taken for 0 changes it by more than half from one rung to the next.
  void expectOwnLaw(const std::vector<double>& lengths, int side) const {
    double before = 0.003, answer = own(side * before);
    const double slope = std::round(std::log10(own(side * 0.03) / answer));
    const double power = std::isfinite(slope) ? slope : 0.0;
    for (const double L : lengths) {
      if (L >= before) continue;
      const double expected = answer * std::pow(L / before, power);
      answer = own(side * L);
      MUELLE_LABEL(fmt::format("{} of a spring of {} m, which follows from yours of {} m", what, L, before), unit);
      EXPECT_NUMBER_NEAR(answer, expected, 0.2 * std::abs(expected));
      before = L;
    }
  }

  /// \param hasRestLength without one there is no law of short springs, but the force at every length
  void expectAllLengths(const std::vector<double>& lengths, bool hasRestLength) const {
    const bool isRight = isRightElsewhere();
    for (const int side : {+1, -1}) {
      if (!isRight && hasRestLength) expectOwnLaw(lengths, side);
      if (!isRight) continue;
      for (const double L : lengths) expectRight(side * L);
    }
  }
};

/// A pair of springs that end in one place; a test of one spring takes the first.
struct ShortSprings {
  double k, L0, otherK, otherL0;
};

template <class Makes>
void expectShortSprings(const Makes& makeCase) {
  Random random = muelle::testRandom();
  const ShortSprings general{positive(random, 5.0, 500.0), number(random, 0.4, 1.6), positive(random, 5.0, 500.0),
                             number(random, 0.4, 1.6)};
  for (const Place& place : places) {
    makeCase(place.end, general).expectAllLengths(place.lengths, true);
    makeCase(place.end, {1e9, 0, 310, 0}).expectAllLengths(place.lengths, false);
    makeCase(place.end, {1e-3, 0.83, 0.037, 1.27}).expectAllLengths(place.lengths, false);
  }
}

}  // namespace

TEST(ShortSpring, EveryPositiveLengthHasADirection) {
  MUELLE_PROPERTY("a spring of 1e-9 m, or of 1e-100 m, still pushes node a away with k (L0 - L)");
  MUELLE_EXPECT_ANSWERS(springForceOnA);
  expectShortSprings([](double end, const ShortSprings& s) {
    return ShortSpringCase{"force on a", "N",
                           [=](double r) { return submission::springForceOnA(end + r, end, s.k, s.L0); },
                           [=](double r) { return oracle::springForceOnA(end + r, end, s.k, s.L0); },
                           [=](double L) { return s.k * (L + s.L0); }};
  });
}

TEST(ShortSpring, AndSoHasTheForceOnB) {
  MUELLE_PROPERTY("a spring of 1e-9 m, or of 1e-100 m, still pushes node b away with k (L0 - L)");
  MUELLE_EXPECT_ANSWERS(springForceOnB);
  expectShortSprings([](double end, const ShortSprings& s) {
    return ShortSpringCase{"force on b", "N",
                           [=](double r) { return submission::springForceOnB(end + r, end, s.k, s.L0); },
                           [=](double r) { return oracle::springForceOnB(end + r, end, s.k, s.L0); },
                           [=](double L) { return s.k * (L + s.L0); }};
  });
}

TEST(ShortSpring, PushesAHangingNode) {
  MUELLE_PROPERTY("a node that is 1e-9 m, or 1e-100 m, from the end of its spring is still pushed away");
  MUELLE_EXPECT_ANSWERS(hangingAcceleration);
  expectShortSprings([](double end, const ShortSprings& s) {
    const double m = 0.43;
    const Attachment top{end, s.k, s.L0};
    return ShortSpringCase{"acceleration without gravity", "m/s^2",
                           [=](double r) { return submission::hangingAcceleration(end + r, m, top, 0.0); },
                           [=](double r) { return oracle::hangingAcceleration(end + r, m, top, 0.0); },
                           [=](double L) { return s.k * (L + s.L0) / m; }};
  });
}

TEST(ShortSpring, PushesANodeBetweenTwo) {
  MUELLE_PROPERTY("a node that is 1e-9 m, or 1e-100 m, from the ends of both its springs is still pushed by both");
  MUELLE_EXPECT_ANSWERS(accelerationBetween);
  expectShortSprings([](double end, const ShortSprings& s) {
    const double m = 0.43;
    const Attachment lower{end, s.k, s.L0}, upper{end, s.otherK, s.otherL0};
    return ShortSpringCase{"acceleration without gravity", "m/s^2",
                           [=](double r) { return submission::accelerationBetween(end + r, m, lower, upper, 0.0); },
                           [=](double r) { return oracle::accelerationBetween(end + r, m, lower, upper, 0.0); },
                           [=](double L) { return (s.k * (L + s.L0) + s.otherK * (L + s.otherL0)) / m; }};
  });
}

// ----------------------------------------------------------------------------------------------------- accelerations
// Compared with the oracle everywhere, which may be given the student's own force.

TEST(HangingNode, FollowsNewtonsSecondLaw) {
  MUELLE_PROPERTY("m a is the force of the spring plus the weight");
  Random random = muelle::testRandom();
  for (int i = 0; i < caseCount; ++i) expectHangingAcceleration(randomNode(random, i));
}

TEST(HangingNode, RestsWhereTheSpringCarriesItsWeight) {
  MUELLE_PROPERTY(
      "a node that stretches its spring by m g / k does not accelerate; below that it goes up, above it down");
  for (const double y : {-0.23, -0.11, 0.0, 0.07, 0.19}) {
    // 0.3 kg at 7 m/s^2 stretch 30 N/m by 0.07 m.
    expectHangingAcceleration({muelle::threeDigits(-0.37 - 0.07 + y), 0.3, {}, {0.45, 30, 0.82}, 7});
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

TEST(HangingNode, HoldsForEverySpringAndMass) {
  MUELLE_PROPERTY("light and heavy nodes, soft and hard springs, no gravity and much follow the same law");
  for (const NodeCase& corner : nodeCorners) expectHangingAcceleration(corner);
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
    NodeCase node = randomNode(random, i);
    node.lower.x = node.x - node.lower.L0;
    node.upper.x = node.x + node.upper.L0;
    expectAccelerationBetween(node);
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

TEST(NodeBetween, HoldsForEverySpringAndMass) {
  MUELLE_PROPERTY("light and heavy nodes, soft and hard springs, no gravity and much follow the same law");
  for (const NodeCase& corner : nodeCorners) expectAccelerationBetween(corner);
}

// -------------------------------------------------------------------------------------------------------- simulations

namespace {

using Acceleration = std::function<double(double x)>;

/// A node of mass m that starts at rest at x.
Trajectory swing(const Acceleration& acceleration, double m, double x, double duration) {
  const FunctionSystem system({m}, [&](double, In position, In, Out f) { f[0] = m * acceleration(position[0]); });
  const muelle::MarchOptions options{.h = 2e-3, .duration = duration, .outputEvery = 5, .probes = {}, .label = ""};
  return muelle::march(system, {0.0, {x}, {0.0}, {}}, options);
}

/// Compares a swing of the submission with that of the oracle, which may be given the student's own force: then it may
/// be thrown out, and stop early.
void expectOscillation(const Trajectory& run, const Trajectory& reference) {
  {
    MUELLE_LABEL("time at which the motion has no numbers any more", "s");
    ASSERT_NUMBER_NEAR(std::min(run.t.back(), reference.t.back()), reference.t.back(), 0.0);
  }
  double largest = 0;
  for (std::size_t i = 0; i < reference.t.size(); ++i) {
    largest = std::max(largest, std::abs(reference.x[i][0]));
    MUELLE_LABEL(fmt::format("height at t = {:.2f} s", run.t[i]), "m");
    // Same method and steps: only rounding differs, some 1e-15 of the height in each of 1000 steps, or 1e-7 in single
    // precision, which costs other criteria. An oscillator does not amplify it, a force of the wrong sign, by
    // exp(omega t) < 3e5 in two periods, as much as the height itself. A wrong term moves the node by centimetres.
    EXPECT_NUMBER_NEAR(run.x[i][0], reference.x[i][0], 10 * ofStructure * (1.0 + largest));
  }
}

}  // namespace

TEST(Oscillator, AHangingNodeSwingsAboutItsEquilibrium) {
  MUELLE_PROPERTY("a hanging node follows the reference curve");
  const double m = 0.43, g = 8.37;
  const Attachment top{2.3, 26.0, 0.83};
  const double equilibrium = top.x - top.L0 - m * g / top.k, period = 2 * M_PI / std::sqrt(top.k / m);
  const auto run = [&](auto&& acceleration) {
    return swing([&](double x) { return acceleration(x, m, top, g); }, m, equilibrium - 0.31, 2 * period);
  };
  expectOscillation(run(submission::hangingAcceleration), run(oracle::hangingAcceleration));
}

TEST(Oscillator, AStandingNodeSwingsAboutItsEquilibrium) {
  MUELLE_PROPERTY("a node that stands on its spring follows the reference curve");
  const double m = 0.43, g = 8.37;
  const Attachment bottom{0.22, 31.0, 0.91};
  const double equilibrium = bottom.x + bottom.L0 - m * g / bottom.k, period = 2 * M_PI / std::sqrt(bottom.k / m);
  const auto run = [&](auto&& acceleration) {
    return swing([&](double x) { return acceleration(x, m, bottom, g); }, m, equilibrium + 0.31, period);
  };
  expectOscillation(run(submission::hangingAcceleration), run(oracle::hangingAcceleration));
}

TEST(Oscillator, ANodeBetweenTwoSpringsSwingsAboutItsEquilibrium) {
  MUELLE_PROPERTY("a node between two springs follows the reference curve");
  const double m = 0.57, g = 8.37;
  const Attachment lower{0.13, 41.0, 1.13}, upper{2.17, 61.0, 0.72};
  const double k = lower.k + upper.k;  // two springs side by side
  const double equilibrium = (lower.k * (lower.x + lower.L0) + upper.k * (upper.x - upper.L0) - m * g) / k;
  const double period = 2 * M_PI / std::sqrt(k / m);
  const auto run = [&](auto&& acceleration) {
    return swing([&](double x) { return acceleration(x, m, lower, upper, g); }, m, equilibrium + 0.23, 2 * period);
  };
  expectOscillation(run(submission::accelerationBetween), run(oracle::accelerationBetween));
}
