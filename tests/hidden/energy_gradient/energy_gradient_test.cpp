#include "energy_gradient.h"

#include "course/testing/expect.h"
#include "course/testing/random.h"
#include "grader/testing/ladders.h"
#include "grader/testing/motion.h"
#include "grader/testing/of_use.h"
#include "grader/testing/plain_numbers.h"
#include "harness/function_system.h"
#include "harness/march.h"
#include "harness/symplectic_euler.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <functional>
#include <optional>

using muelle::FunctionSystem;
using muelle::In;
using muelle::Mat3;
using muelle::Out;
using muelle::Random;
using muelle::testRandom;
using muelle::threeDigits;
using muelle::Trajectory;
using muelle::VecX;
using muelle::grader::exactLengthLadder;
using muelle::grader::lengthLadder;
using muelle::grader::someTurn;
using muelle::grader::stiffnessLadder;
using muelle::grader::tidy;

namespace {

constexpr double shortest = 1e-100;       // [m], of the contract
constexpr double longestRest = 1000.0;    // [m], of the contract
constexpr double longestLength = 1000.0;  // [m]: springs of the tests are not longer

/// A tolerance for values: some 20 roundings of 1.1e-16 in any order of the sums, with lengths by any formula, are
/// 2e-15 of the numbers involved; the best central difference is off by 4e-11, single precision by 6e-8.
double inRounding(double scale) { return 1e-13 * scale; }

/// A tolerance for laws, which are about structure and not about digits: a derivative by differences, or single
/// precision, breaks none of them. It loses the criterion of its values.
double inStructure(double scale) { return 1e-6 * scale; }

/// One spring somewhere in space.
struct Case {
  Vec6 x;     ///< (xa, xb) [m]
  double k;   ///< [N/m]
  double L0;  ///< [m]

  Vec3 xa() const { return x.head<3>(); }
  Vec3 xb() const { return x.tail<3>(); }
  double L() const { return (xa() - xb()).stableNorm(); }
  double forceScale() const { return k * (L() + L0); }
  double energyScale() const { return k * (L() + L0) * (L() + L0); }
};

Vec6 stacked(const Vec3& xa, const Vec3& xb) {
  Vec6 x;
  x << xa, xb;
  return x;
}

/// A stiffness, from 5 to 2000 N/m.
double someStiffness(Random& random) { return threeDigits(random.positive(5.0, 2000.0)); }

/// Along no axis, and no two components alike.
Vec3 slantedVector(Random& random, double least, double most) {
  const auto component = [&] {
    const double size = random.number(least, most);
    return random.integer(0, 1) == 0 ? size : -size;
  };
  const double x = component(), y = component(), z = component();
  return tidy(Vec3(x, y + std::copysign(0.11, y), z + std::copysign(0.23, z)));
}

/// A rest length that differs from L by a tenth at least: a stretched spring for an even `number`, a compressed one for
/// an odd one, never one at rest.
double restLengthFor(Random& random, double L, int number) {
  const double ratio = random.number(1.15, 2.5);
  return threeDigits(number % 2 == 0 ? L / ratio : L * ratio);
}

/// On either side of the origin, or across it.
Case anySpring(Random& random, int number) {
  Case spring;
  const Vec3 xb = slantedVector(random, 0.1, 2.0);
  spring.x = stacked(tidy(xb + slantedVector(random, 0.2, 1.7)), xb);
  spring.k = someStiffness(random);
  spring.L0 = restLengthFor(random, spring.L(), number);
  return spring;
}

/// Hundreds of metres from the origin, where a length that is not one of the difference has lost its digits.
Case farSpring(Random& random, int number) {
  Case spring = anySpring(random, number);
  const Vec3 shift = slantedVector(random, 500.0, 900.0);
  spring.x = stacked(tidy(spring.xa() + shift), tidy(spring.xb() + shift));
  return spring;
}

/// Differences along an axis, and in a plane of two of them.
std::vector<Vec3> alignedDifferences() {
  return {{0.7, 0, 0},   {-1.3, 0, 0},   {0, 0.9, 0},   {0, -2.1, 0},   {0, 0, 1.7},   {0, 0, -0.6},
          {0.7, 1.1, 0}, {-0.4, 0, 1.9}, {0, 1.3, 0.8}, {0.3, -0.8, 0}, {1.2, 0, 0.5}, {0, 0.6, -1.4}};
}

/// Springs along axes and in planes of axes, at the origin and away from it, stretched and compressed.
std::vector<Case> alignedSprings(Random& random) {
  std::vector<Case> springs;
  for (const Vec3& d : alignedDifferences()) {
    const int number = static_cast<int>(springs.size());
    const Vec3 xb = number % 3 == 0 ? Vec3(Vec3::Zero()) : Vec3(slantedVector(random, 0.1, 2.0));
    Case spring{stacked(tidy(xb + d), xb), someStiffness(random), 0};
    spring.L0 = restLengthFor(random, spring.L(), number);
    springs.push_back(spring);
  }
  return springs;
}

/// Every stiffness with every rest length, the ends of the contract among them, long and short.
std::vector<Case> springsOfTheWholeRange() {
  std::vector<Case> springs;
  const Vec3 along(2, -3, 6);  // its length is 7
  for (const double k : stiffnessLadder) {
    for (const double L0 : {0.0, 0.043, 1.7, longestRest}) {
      for (const double L : {0.021, 0.63, 5.6, longestLength}) {
        const Vec3 half = tidy(Vec3(L / 14 * along), 1e5);
        springs.push_back({stacked(half, -half), k, L0});
      }
    }
  }
  return springs;
}

/// Short springs between nodes away from the origin, whose differences are exact: (2, -3, 6) 2^-n m, of length 7 2^-n
/// m. \param least the shortest length [m]
std::vector<Case> exactShortSprings(double least, double L0) {
  std::vector<Case> springs;
  const Vec3 xb(1.25, -1.75, 1.5);
  for (const double unit : exactLengthLadder()) {
    if (7 * unit >= least) springs.push_back({stacked(xb + unit * Vec3(2, -3, 6), xb), 310.0, L0});
  }
  return springs;
}

/// Springs near their rest length, 1.75 m, whose stretch is exact: from a quarter of a metre to 2^-n m, either way.
/// \param least the smallest stretch [m]
std::vector<Case> nearlyRelaxedSprings(double least) {
  std::vector<Case> springs;
  for (const double stretch : exactLengthLadder()) {
    if (stretch < least) break;
    for (const double sign : {1.0, -1.0}) {
      springs.push_back({stacked(Vec3(0.5, -0.75, 1.5), Vec3::Zero()), 73.0, 1.75 + sign * stretch});
    }
  }
  return springs;
}

Vec6 turned(const Vec6& x, const Mat3& rotation) { return stacked(rotation * x.head<3>(), rotation * x.tail<3>()); }

void expectEnergy(const Case& s) {
  EXPECT_NUMBER_NEAR(submission::springEnergy(s.x, s.k, s.L0), oracle::springEnergy(s.x, s.k, s.L0),
                     inRounding(s.energyScale()));
}

void expectDirection(const Case& s) {
  EXPECT_VECTOR_NEAR(submission::lengthGradient(s.xa(), s.xb()), oracle::lengthGradient(s.xa(), s.xb()), inRounding(1));
}

void expectForces(const Case& s) {
  EXPECT_VECTOR_NEAR(submission::springForces(s.x, s.k, s.L0), oracle::springForces(s.x, s.k, s.L0),
                     inRounding(s.forceScale()));
}

/// Central differences of the submission's energy in all six components.
Vec6 slopes(const Case& spring, double h) {
  Vec6 slope;
  for (int i = 0; i < 6; ++i) {
    Vec6 forward = spring.x;
    Vec6 backward = spring.x;
    forward[i] += h;
    backward[i] -= h;
    slope[i] = (submission::springEnergy(forward, spring.k, spring.L0) -
                submission::springEnergy(backward, spring.k, spring.L0)) /
               (forward[i] - backward[i]);
  }
  return slope;
}

}  // namespace

// --- EnergyInOneDimension -------------------------------------------------------------------------------------------

namespace {

/// Stretched and compressed by 2^-10, 2^-20, 2^-30 m: differences of which every square root and sum is exact.
std::vector<Case> springsNearRest() {
  std::vector<Case> springs;
  for (const Vec3& r : {Vec3(1.5, 0.0, 0.0), Vec3(0.75, 1.0, 0.0), Vec3(0.5, 1.0, 1.0)}) {
    for (const double stretch : {0x1p-10, -0x1p-20, 0x1p-30}) {
      springs.push_back({stacked(r, Vec3::Zero()), 370.0, r.norm() - stretch});
    }
  }
  return springs;
}

/// Lengths of some 1.5 m by any formula are off by three roundings, 5e-16 m: of the smallest stretch, 9e-10 m, that is
/// 5e-7, and twice as much of its square. What squares first is off by 5e-16 of L^2, which is 6e-4 of the energy at a
/// stretch of 2^-20 m and 600 times the energy at 2^-30 m.
double nearRest(const Case& s) { return 1e-5 * oracle::springEnergy(s.x, s.k, s.L0); }

struct Case1d {
  Vec2 x;
  double k;
  double L0;

  double L() const { return std::abs(x[0] - x[1]); }
  double scale() const { return k * (L() + L0) * (L() + L0); }
};

void expectEnergy(const Case1d& s) {
  EXPECT_NUMBER_NEAR(submission::springEnergy1d(s.x, s.k, s.L0), oracle::springEnergy1d(s.x, s.k, s.L0),
                     inRounding(s.scale()));
}

/// In turn: either order of the nodes, each right of the origin, left of it, and across it; stretched and compressed.
Case1d anySpring1d(Random& random, int number) {
  const double near = tidy(random.number(0.2, 1.4));
  const double far = tidy(near + random.number(0.3, 3.0));
  const std::array<Vec2, 6> places = {Vec2(far, near),   Vec2(near, far),  Vec2(-near, -far),
                                      Vec2(-far, -near), Vec2(far, -near), Vec2(-near, far)};
  Case1d spring{places[static_cast<std::size_t>(number % 6)], someStiffness(random), 0};
  spring.L0 = restLengthFor(random, spring.L(), number / 6);
  return spring;
}

}  // namespace

TEST(EnergyInOneDimension, IsHalfTheStiffnessTimesTheSquaredStretch) {
  MUELLE_PROPERTY("in 1D the energy is that of the stretch L - L0 with L = |xa - xb|, whichever node is on the left");
  Random random = testRandom();
  for (int i = 0; i < 24; ++i) expectEnergy(anySpring1d(random, i));
}

TEST(EnergyInOneDimension, HoldsForEveryStiffnessAndLength) {
  MUELLE_PROPERTY("in 1D the energy is right for the softest and the hardest spring, and for any rest length, 0 too");
  for (const Case& s : springsOfTheWholeRange()) expectEnergy(Case1d{{s.x[0], s.x[3]}, s.k, s.L0});
  for (const Case& s : exactShortSprings(0.01, 0.0)) expectEnergy(Case1d{{s.x[0], s.x[3]}, s.k, s.L0});
  for (const Case& s : nearlyRelaxedSprings(1e-6)) expectEnergy(Case1d{{-0.5, 1.25}, s.k, s.L0});
}

TEST(EnergyInOneDimension, KeepsItsDigitsNearRest) {
  MUELLE_PROPERTY("in 1D, near rest, the lengths are subtracted before they are squared: the energy keeps its digits");
  for (const Case& s : springsNearRest()) {
    const Case1d line{{s.L(), 0.0}, s.k, s.L0};
    EXPECT_NUMBER_NEAR(submission::springEnergy1d(line.x, line.k, line.L0),
                       oracle::springEnergy1d(line.x, line.k, line.L0), nearRest(s));
  }
}

TEST(EnergyInOneDimension, DependsOnTheDistanceAlone) {
  MUELLE_PROPERTY("in 1D the energy stays the same when the nodes swap places or both move by the same amount");
  Random random = testRandom();
  for (int i = 0; i < 12; ++i) {
    const Case1d s = anySpring1d(random, i);
    const double shift = tidy(random.number(-5.0, 5.0));
    const double E = submission::springEnergy1d(s.x, s.k, s.L0);
    {
      MUELLE_LABEL("energy after the nodes have swapped places", "J");
      EXPECT_NUMBER_NEAR(submission::springEnergy1d(Vec2(s.x[1], s.x[0]), s.k, s.L0), E, inStructure(s.scale()));
    }
    MUELLE_LABEL("energy after both nodes have moved by the same amount", "J");
    EXPECT_NUMBER_NEAR(submission::springEnergy1d(Vec2(tidy(s.x[0] + shift), tidy(s.x[1] + shift)), s.k, s.L0), E,
                       inStructure(s.scale()));
  }
}

// --- EnergyInSpace --------------------------------------------------------------------------------------------------

TEST(EnergyInSpace, IsHalfTheStiffnessTimesTheSquaredStretch) {
  MUELLE_PROPERTY("in 3D the energy is that of the stretch L - L0 with L = |xa - xb|");
  Random random = testRandom();
  for (int i = 0; i < 12; ++i) expectEnergy(anySpring(random, i));
  for (int i = 0; i < 4; ++i) expectEnergy(farSpring(random, i));
  for (const Case& s : alignedSprings(random)) expectEnergy(s);
}

TEST(EnergyInSpace, HoldsForEveryStiffnessAndLength) {
  MUELLE_PROPERTY("the energy is right for the softest and the hardest spring, and for any rest length, 0 too");
  for (const Case& s : springsOfTheWholeRange()) expectEnergy(s);
  for (const Case& s : exactShortSprings(0.01, 0.0)) expectEnergy(s);
  for (const Case& s : nearlyRelaxedSprings(1e-6)) expectEnergy(s);
}

TEST(EnergyInSpace, KeepsItsDigitsNearRest) {
  MUELLE_PROPERTY("near rest the lengths are subtracted before they are squared: the energy keeps its digits");
  for (const Case& s : springsNearRest()) {
    EXPECT_NUMBER_NEAR(submission::springEnergy(s.x, s.k, s.L0), oracle::springEnergy(s.x, s.k, s.L0), nearRest(s));
  }
}

TEST(EnergyInSpace, DoesNotChangeWhenTheSpringIsMovedOrTurned) {
  MUELLE_PROPERTY("the energy stays the same when the spring is moved, turned, or its nodes are exchanged");
  Random random = testRandom();
  for (int i = 0; i < 6; ++i) {
    const Case s = anySpring(random, i);
    const double E = submission::springEnergy(s.x, s.k, s.L0);
    const Vec3 shift = slantedVector(random, 0.5, 9.0);
    const auto expectSame = [&](const char* what, const Vec3& xa, const Vec3& xb) {
      MUELLE_LABEL(fmt::format("energy after {}", what), "J");
      EXPECT_NUMBER_NEAR(submission::springEnergy(stacked(xa, xb), s.k, s.L0), E, inStructure(s.energyScale()));
    };
    expectSame("the nodes are exchanged", s.xb(), s.xa());
    expectSame("both nodes have moved by the same amount", tidy(s.xa() + shift), tidy(s.xb() + shift));
    const Mat3 turn = someTurn(i);
    expectSame("the spring is turned", tidy(turn * s.xa(), 1e5), tidy(turn * s.xb(), 1e5));
  }
}

// --- LengthGradient -------------------------------------------------------------------------------------------------

TEST(LengthGradient, IsTheUnitVectorFromBToA) {
  MUELLE_PROPERTY("the gradient of L with respect to xa is the unit vector that points from b to a");
  Random random = testRandom();
  for (int i = 0; i < 12; ++i) expectDirection(anySpring(random, i));
  for (int i = 0; i < 4; ++i) expectDirection(farSpring(random, i));
}

TEST(LengthGradient, IsThatAlongAxesToo) {
  MUELLE_PROPERTY("a spring along an axis, or in a plane of two axes, has a direction as any other has");
  Random random = testRandom();
  for (const Case& s : alignedSprings(random)) expectDirection(s);
}

TEST(LengthGradient, DoesNotDependOnTheLength) {
  MUELLE_PROPERTY("along one line the gradient of L is the same for a long spring and for a shorter one");
  for (const Case& s : springsOfTheWholeRange()) {
    if (s.k == stiffnessLadder.front() && s.L0 == 0) expectDirection(s);
  }
  for (const Case& s : exactShortSprings(0.01, 0.0)) expectDirection(s);
}

TEST(LengthGradient, IsOppositeForTheOtherNode) {
  MUELLE_PROPERTY("exchanging the nodes turns the gradient of the length round");
  MUELLE_EXPECT_ANSWERS(lengthGradient);
  Random random = testRandom();
  for (int i = 0; i < 4; ++i) {
    const Case s = anySpring(random, i);
    const Vec3 gradient = submission::lengthGradient(s.xa(), s.xb());
    MUELLE_LABEL("gradient of L after the nodes have been exchanged");
    EXPECT_VECTOR_NEAR(submission::lengthGradient(s.xb(), s.xa()), -gradient, inStructure(gradient.norm()));
  }
}

// --- EnergyGradient: partial ----------------------------------------------------------------------------------------

namespace {

using Block = Vec3 (*)(const Vec6&);
Vec3 blockOfA(const Vec6& x) { return x.head<3>(); }
Vec3 blockOfB(const Vec6& x) { return x.tail<3>(); }

/// One block of the gradient, which has half of the points: a mistake in the other costs nothing here.
void expectBlock(Block block, const char* label, const Case& s) {
  const Vec6 gradient = submission::energyGradient(s.x, s.k, s.L0);
  MUELLE_LABEL(label, "N");
  EXPECT_VECTOR_NEAR(block(gradient), block(oracle::energyGradient(s.x, s.k, s.L0)), inRounding(s.forceScale()));
}

void expectBlockEverywhere(Block block, const char* label) {
  Random random = testRandom();
  for (int i = 0; i < 12; ++i) expectBlock(block, label, anySpring(random, i));
  for (int i = 0; i < 4; ++i) expectBlock(block, label, farSpring(random, i));
  for (const Case& s : alignedSprings(random)) expectBlock(block, label, s);
  for (const Case& s : springsOfTheWholeRange()) expectBlock(block, label, s);
  for (const Case& s : exactShortSprings(0.01, 0.0)) expectBlock(block, label, s);
  for (const Case& s : nearlyRelaxedSprings(0)) expectBlock(block, label, s);
}

}  // namespace

TEST(EnergyGradient, HasTheDerivativeWithRespectToA) {
  MUELLE_PROPERTY("components 0 to 2 of the energy gradient are the derivatives with respect to xa");
  MUELLE_EXPECT_ANSWERS(energyGradient);
  expectBlockEverywhere(blockOfA, "derivative of the energy with respect to xa");
}

TEST(EnergyGradient, HasTheDerivativeWithRespectToB) {
  MUELLE_PROPERTY("components 3 to 5 of the energy gradient are the derivatives with respect to xb");
  MUELLE_EXPECT_ANSWERS(energyGradient);
  expectBlockEverywhere(blockOfB, "derivative of the energy with respect to xb");
}

TEST(EnergyGradient, TurnsWithTheSpring) {
  MUELLE_PROPERTY("moving the spring leaves its gradient alone, turning the spring turns the gradient");
  MUELLE_EXPECT_ANSWERS(energyGradient);
  Random random = testRandom();
  for (int i = 0; i < 6; ++i) {
    const Case s = anySpring(random, i);
    const Mat3 turn = someTurn(i);
    const Vec3 shift = slantedVector(random, 0.5, 9.0);
    const Vec6 gradient = submission::energyGradient(s.x, s.k, s.L0);
    const double tolerance = inStructure(gradient.norm());
    const auto expectGradient = [&](const char* what, const Vec3& xa, const Vec3& xb, const Vec6& expected) {
      MUELLE_LABEL(fmt::format("gradient of the energy after {}", what), "N");
      EXPECT_VECTOR_NEAR(submission::energyGradient(stacked(xa, xb), s.k, s.L0), expected, tolerance);
    };
    expectGradient("both nodes have moved by the same amount", tidy(s.xa() + shift), tidy(s.xb() + shift), gradient);
    expectGradient("the spring is turned", tidy(turn * s.xa(), 1e5), tidy(turn * s.xb(), 1e5), turned(gradient, turn));
  }
}

// --- FiniteDifferences ----------------------------------------------------------------------------------------------

TEST(FiniteDifferences, OfTheEnergyAreTheGradient) {
  MUELLE_PROPERTY("each component of energyGradient is the slope of springEnergy when that component of x moves");
  MUELLE_EXPECT_ANSWERS(springEnergy);
  MUELLE_EXPECT_ANSWERS(energyGradient);
  Random random = testRandom();
  for (int i = 0; i < 9; ++i) {
    Case s = anySpring(random, i);
    if (i >= 6) s.L0 = 0;
    const double h = 1e-4 * s.L();
    // E''' = -k L0 L''' with |L'''| <= 1.16 / L^2, so h^2 k L0 / (5 L^2) = 2e-9 k L0; the energies carry some 1e-15 of
    // their scale, divided by h: 1e-11 of the force's scale. The law allows more: see inStructure.
    const Vec6 gradient = submission::energyGradient(s.x, s.k, s.L0);
    MUELLE_LABEL("slope of your springEnergy, where your energyGradient is expected", "N");
    EXPECT_VECTOR_NEAR(slopes(s, h), gradient, inStructure(s.forceScale()));
  }
}

TEST(FiniteDifferences, ConvergeToTheGradientWithOrderTwo) {
  MUELLE_PROPERTY(
      "halving the step of the central difference of springEnergy divides its distance to energyGradient by four");
  MUELLE_EXPECT_ANSWERS(springEnergy);
  MUELLE_EXPECT_ANSWERS(energyGradient);
  Random random = testRandom();
  for (int i = 0; i < 4; ++i) {
    Case s = anySpring(random, i);
    // A direction along no axis: the third derivative along an axis vanishes for a spring that lies along it.
    s.x.head<3>() = s.xb() + Vec3(1.2, 0.96, -1.28);
    s.L0 = i % 2 == 0 ? 1.33 : 2.81;
    const Vec6 gradient = submission::energyGradient(s.x, s.k, s.L0);
    const double h = 0.04 * s.L();
    const double coarse = (slopes(s, h) - gradient).norm();
    const double fine = (slopes(s, h / 2) - gradient).norm();
    // The next term of the error is of relative size 2 (h / L)^2 = 3e-3. A gradient that is off by 1e-6 (inStructure)
    // moves the finer error, about 1e-4 of the force's scale, by 1e-2.
    MUELLE_LABEL("distance of slope and gradient with half the step, where a quarter is expected", "N");
    EXPECT_NUMBER_NEAR(fine, coarse / 4, 0.02 * coarse + inStructure(s.forceScale()));
  }
}

// --- Forces ---------------------------------------------------------------------------------------------------------

TEST(Forces, LeadDownhillInEnergy) {
  MUELLE_PROPERTY("the forces are minus the gradient of the energy, block by block");
  Random random = testRandom();
  for (int i = 0; i < 12; ++i) expectForces(anySpring(random, i));
  for (int i = 0; i < 4; ++i) expectForces(farSpring(random, i));
  for (const Case& s : alignedSprings(random)) expectForces(s);
}

TEST(Forces, HoldForEveryStiffnessAndLength) {
  MUELLE_PROPERTY("the forces are right for the softest and the hardest spring, and for any rest length, 0 too");
  for (const Case& s : springsOfTheWholeRange()) expectForces(s);
  for (const Case& s : exactShortSprings(0.01, 0.0)) expectForces(s);
}

TEST(Forces, PullTogetherWhenStretchedAndPushApartWhenCompressed) {
  MUELLE_PROPERTY(
      "a stretched spring pulls its nodes together, a compressed one pushes them apart, one at rest does nothing");
  for (const Case& s : nearlyRelaxedSprings(0)) expectForces(s);
  const Vec6 x = stacked(Vec3(0.5, -0.75, 1.5), Vec3::Zero());  // of length 1.75 m
  expectForces({x, 73.0, 1.75});
}

TEST(Forces, ObeyNewtonsThirdLaw) {
  MUELLE_PROPERTY("the forces on a and b are opposite and along the spring: no net force, no net torque");
  Random random = testRandom();
  for (int i = 0; i < 6; ++i) {
    const Case s = anySpring(random, i);
    const Vec6 forces = submission::springForces(s.x, s.k, s.L0);
    const Vec3 onA = forces.head<3>(), onB = forces.tail<3>();
    {
      MUELLE_LABEL("sum of the forces on a and b", "N");
      EXPECT_VECTOR_NEAR(Vec3(onA + onB), Vec3(Vec3::Zero()), inStructure(forces.norm()));
    }
    MUELLE_LABEL("sum of the torques of both forces about the origin", "N m");
    EXPECT_VECTOR_NEAR(Vec3(s.xa().cross(onA) + s.xb().cross(onB)), Vec3(Vec3::Zero()),
                       inStructure(forces.norm() * (s.xa().norm() + s.xb().norm())));
  }
}

// --- edges: partial, one test a function ----------------------------------------------------------------------------

namespace {

/// What a function answers about the spring from a to b.
using Answer = std::function<VecX(const Vec3& xa, const Vec3& xb)>;

/// A stiffness for the edges: nothing about it is special.
constexpr double someK = 731.0;

Answer askEnergy1d(double L0) {
  return [L0](const Vec3& xa, const Vec3& xb) -> VecX {
    return VecX::Constant(1, submission::springEnergy1d(Vec2(xa[0], xb[0]), someK, L0));
  };
}
Answer askEnergy(double L0) {
  return [L0](const Vec3& xa, const Vec3& xb) -> VecX {
    return VecX::Constant(1, submission::springEnergy(stacked(xa, xb), someK, L0));
  };
}
Answer askDirection() {
  return [](const Vec3& xa, const Vec3& xb) -> VecX { return submission::lengthGradient(xa, xb); };
}
Answer askGradient(double L0) {
  return
      [L0](const Vec3& xa, const Vec3& xb) -> VecX { return submission::energyGradient(stacked(xa, xb), someK, L0); };
}
Answer askForces(double L0) {
  return [L0](const Vec3& xa, const Vec3& xb) -> VecX { return submission::springForces(stacked(xa, xb), someK, L0); };
}

/// The lengths that an answer is followed from [m].
constexpr double from = 0.3, past = 0.03;

/// Along no axis and of length 1 to round-off.
Vec3 line(int number) {
  constexpr double signs[] = {1.0, -1.0};
  return Vec3(2, -3 * signs[number % 2], 6 * signs[number / 2 % 2]) / 7;
}

/// The power of L, whole or half, that an answer follows from 0.3 m to 0.03 m: 0 for a direction, and for a force or an
/// energy that L0 rules, 1 or 2 for these without L0. None where it follows another law: it is wrong at any length.
/// expectPowerLaw() cannot ask so closely: it takes the nearest whole power, for right forces of contact bend.
std::optional<double> powerOf(double at, double below) {
  if (at == 0) return std::nullopt;
  if (below == 0) return 0.0;
  const double halves = 2 * std::log(at / below) / std::log(from / past);
  if (!(std::abs(halves - std::round(halves)) < 0.02)) return std::nullopt;
  return std::round(halves) / 2;
}

/// Short springs beside the origin answer as one of 0.3 m along the same line does, times the power of the length that
/// it is ruled by. That holds for right answers, and for wrong ones that are wrong at any length.
/// \param least until the answers fade to what single precision does not hold
/// \param tolerance of the answer at 0.3 m
void expectNothingNewBesideTheOrigin(const std::string& what, const Answer& answer, double least, double tolerance) {
  for (int i = 0; i < 4; ++i) {
    const auto at = [&](double L) -> VecX {
      const Vec3 node = L * line(i);
      return i % 2 == 0 ? answer(node, Vec3::Zero()) : answer(Vec3::Zero(), node);
    };
    const VecX reference = at(from);
    const auto power = powerOf(reference.norm(), at(past).norm());
    if (!power) continue;
    for (const double L : lengthLadder(least)) {
      MUELLE_LABEL(fmt::format("{} at L = {:.2g} m, {}expected as at L = 0.3 m", what, L,
                               *power == 0 ? "" : fmt::format("divided by (L / 0.3 m)^{:g}, ", *power)));
      EXPECT_VECTOR_NEAR(VecX(at(L) / std::pow(L / from, *power)), reference, tolerance * reference.norm());
    }
    if (*power <= 0) continue;
    MUELLE_LABEL(what + " at L = 1e-100 m");
    EXPECT_VECTOR_NEAR(at(shortest), VecX(VecX::Zero(reference.size())), inStructure(reference.norm()));
  }
}

/// Short springs away from the origin answer as the same ones beside it, where longer ones do.
void expectTheSameAwayFromTheOrigin(const std::string& what, const Answer& answer) {
  for (const Case& s : exactShortSprings(0, 0.0)) {
    const VecX beside = answer(s.xa() - s.xb(), Vec3::Zero());
    const VecX away = answer(s.xa(), s.xb());
    const double tolerance = inStructure(beside.norm());
    if (s.L() > 1 && !((away - beside).norm() <= tolerance)) return;  // not an edge: wrong at any length
    MUELLE_LABEL(fmt::format("{} at L = {:.2g} m away from the origin, expected as at the origin", what, s.L()));
    EXPECT_VECTOR_NEAR(away, beside, tolerance);
  }
}

/// \param answer with the given L0
/// \param least see expectNothingNewBesideTheOrigin
void expectNothingNewInShortSprings(const std::string& what, const std::function<Answer(double L0)>& answer,
                                    double least) {
  // With L0 = 0 the answers are powers of L; with the largest L0 they are those of L = 0, but for 2 L / L0 = 6e-4.
  expectNothingNewBesideTheOrigin(what + " with L0 = 0", answer(0.0), least, 1e-6);
  expectNothingNewBesideTheOrigin(what + " with L0 = 1000 m", answer(longestRest), shortest, 3e-3);
  expectTheSameAwayFromTheOrigin(what + " with L0 = 0", answer(0.0));
  expectTheSameAwayFromTheOrigin(what + " with L0 = 1.7 m", answer(1.7));
}

/// Where two nodes may coincide.
std::vector<Vec3> points() { return {Vec3::Zero(), Vec3(0.3, -0.7, 1.1), Vec3(-870, 640, -390), Vec3(0, 0, 1.3)}; }

/// The energy of coincident nodes is what that of short springs tends to.
void expectEnergyOfFullCompression(const std::function<Answer(double L0)>& answer) {
  for (const Vec3& point : points()) {
    const double near = answer(longestRest)(point + from * line(0), point)[0];
    {
      MUELLE_LABEL("energy at L = 0 with L0 = 1000 m, expected about as at L = 0.3 m", "J");
      EXPECT_NUMBER_NEAR(answer(longestRest)(point, point)[0], near, 3e-3 * std::abs(near));
    }
    const double at = answer(0.0)(point + from * line(0), point)[0];
    const auto power = powerOf(std::abs(at), std::abs(answer(0.0)(point + past * line(0), point)[0]));
    const double got = answer(0.0)(point, point)[0];
    MUELLE_LABEL("energy at L = 0 with L0 = 0", "J");
    EXPECT_NUMBER_NEAR(got, power && *power > 0 ? 0 : got, inStructure(std::abs(at)));  // at least a number
  }
}

/// \param scale of the answer elsewhere
void expectZeroWhereNodesCoincide(const Answer& answer, double scale) {
  for (const Vec3& point : points()) {
    const VecX got = answer(point, point);
    EXPECT_VECTOR_NEAR(got, VecX(VecX::Zero(got.size())), inStructure(scale));
  }
}

}  // namespace

TEST(CoincidentNodes, KeepTheirEnergyInOneDimension) {
  MUELLE_PROPERTY("in 1D, where both nodes coincide, the energy is that of a spring compressed by all of L0");
  MUELLE_EXPECT_ANSWERS(springEnergy1d);
  expectEnergyOfFullCompression(askEnergy1d);
}

TEST(CoincidentNodes, KeepTheirEnergy) {
  MUELLE_PROPERTY("where both nodes coincide the energy is that of a spring compressed by all of its rest length");
  MUELLE_EXPECT_ANSWERS(springEnergy);
  expectEnergyOfFullCompression(askEnergy);
}

TEST(CoincidentNodes, HaveNoDirection) {
  MUELLE_PROPERTY("where both nodes coincide the gradient of the length is zero, not NaN");
  MUELLE_EXPECT_ANSWERS(lengthGradient);
  MUELLE_LABEL("gradient of L at L = 0");
  expectZeroWhereNodesCoincide(askDirection(), 1);
}

TEST(CoincidentNodes, HaveNoGradient) {
  MUELLE_PROPERTY("where both nodes coincide the gradient of the energy is zero, not NaN, whatever L0 is");
  MUELLE_EXPECT_ANSWERS(energyGradient);
  MUELLE_LABEL("gradient of the energy at L = 0", "N");
  for (const double L0 : {1.7, 0.0, longestRest}) expectZeroWhereNodesCoincide(askGradient(L0), someK * (L0 + 1));
}

TEST(CoincidentNodes, HaveNoForce) {
  MUELLE_PROPERTY("where both nodes coincide the forces are zero, not NaN, whatever L0 is");
  MUELLE_EXPECT_ANSWERS(springForces);
  MUELLE_LABEL("forces at L = 0", "N");
  for (const double L0 : {1.7, 0.0, longestRest}) expectZeroWhereNodesCoincide(askForces(L0), someK * (L0 + 1));
}

TEST(TinyLengths, HaveAnEnergyInOneDimension) {
  MUELLE_PROPERTY(
      "in 1D the energy of shorter and shorter springs tends to k L0^2 / 2, without a jump, down to 1e-100 m");
  MUELLE_EXPECT_ANSWERS(springEnergy1d);
  expectNothingNewInShortSprings("energy in 1D", askEnergy1d, 1e-15);
}

TEST(TinyLengths, HaveAnEnergy) {
  MUELLE_PROPERTY("the energy of shorter and shorter springs tends to k L0^2 / 2, without a jump, down to 1e-100 m");
  MUELLE_EXPECT_ANSWERS(springEnergy);
  expectNothingNewInShortSprings("energy", askEnergy, 1e-15);
}

TEST(TinyLengths, HaveADirection) {
  MUELLE_PROPERTY(
      "the gradient of the length of a spring of any length above zero, down to 1e-100 m, is that of a long one");
  MUELLE_EXPECT_ANSWERS(lengthGradient);
  expectNothingNewBesideTheOrigin("gradient of L", askDirection(), shortest, 1e-6);
  expectTheSameAwayFromTheOrigin("gradient of L", askDirection());
}

TEST(TinyLengths, HaveAGradient) {
  MUELLE_PROPERTY(
      "the gradient of the energy does not vanish when a spring with rest length is very short: 1e-9 m, 1e-100 m");
  MUELLE_EXPECT_ANSWERS(energyGradient);
  expectNothingNewInShortSprings("gradient of the energy", askGradient, 1e-30);
}

TEST(TinyLengths, HaveAForce) {
  MUELLE_PROPERTY("the forces do not vanish when a spring with rest length is very short: 1e-9 m, 1e-100 m");
  MUELLE_EXPECT_ANSWERS(springForces);
  expectNothingNewInShortSprings("forces", askForces, 1e-30);
}

// --- StretchAndRelease ----------------------------------------------------------------------------------------------

namespace {

/// Work [J] of the submission's forces along a path of both nodes, by the trapezoidal rule.
double work(const Case& s, const std::vector<Vec6>& path) {
  double total = 0.0;
  Vec6 before = Vec6::Zero();
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Vec6 now = submission::springForces(path[i], s.k, s.L0);
    if (i > 0) total += 0.5 * (before + now).dot(path[i] - path[i - 1]);
    before = now;
  }
  return total;
}

}  // namespace

TEST(StretchAndRelease, StoresTheWorkAsEnergy) {
  MUELLE_PROPERTY("the work done against springForces to stretch a spring is what springEnergy gains");
  MUELLE_EXPECT_ANSWERS(springEnergy);
  MUELLE_EXPECT_ANSWERS(springForces);
  Random random = testRandom();
  for (int i = 0; i < 4; ++i) {
    const Case s = anySpring(random, i);
    const Vec3 d = s.xa() - s.xb();
    constexpr int steps = 100;
    std::vector<Vec6> path;
    for (int step = 0; step <= steps; ++step) path.push_back(s.x + 1.0 / steps * step * stacked(0.7 * d, -0.4 * d));
    const double stored = submission::springEnergy(path.back(), s.k, s.L0) - submission::springEnergy(s.x, s.k, s.L0);
    // Along the spring the right force is linear in the length, and the rule exact. For any other of a bend or two it
    // is off by (1.1 L / 100)^2 / 8 of its change of slope, some k: 2e-5 of the scale.
    MUELLE_LABEL("work against your springForces, where the gain of your springEnergy is expected", "J");
    EXPECT_NUMBER_NEAR(-work(s, path), stored, 1e-4 * s.energyScale());
  }
}

TEST(StretchAndRelease, GivesTheEnergyBackOverACycle) {
  MUELLE_PROPERTY("over any closed path of the nodes the work of springForces is zero");
  MUELLE_EXPECT_ANSWERS(springForces);
  Random random = testRandom();
  for (int i = 0; i < 2; ++i) {
    const Case s = anySpring(random, i);
    const Vec3 u = random.roundedDirection();
    const Vec3 w = random.roundedDirection();
    const auto on = [&](double angle) -> Vec6 {
      return s.x + 0.2 * s.L() * stacked(std::cos(angle) * u + std::sin(angle) * w, std::sin(angle) * u);
    };
    // The integrand is smooth and periodic: the nodes come no closer than L / 2, since the loop moves them by less than
    // 0.2 (1 + sqrt(2)) L, and the sum over equal steps with the exact tangent converges geometrically. For a force
    // with a bend it is off by (2 pi / 96)^2 / 8 = 5e-4 of (0.2 L)^2 k: 2e-5 of the scale.
    constexpr int n = 96;
    double total = 0.0;
    for (int step = 0; step < n; ++step) {
      const double angle = 2 * M_PI * step / n;
      const Vec6 tangent = (on(angle + M_PI / 2) - s.x);  // the derivative of cos and sin
      total += submission::springForces(on(angle), s.k, s.L0).dot(tangent) * 2 * M_PI / n;
    }
    MUELLE_LABEL("work of your springForces over a closed path", "J");
    EXPECT_NUMBER_NEAR(total, 0.0, 1e-4 * s.energyScale());
  }
}

namespace {

using Forces = std::function<Vec6(const Vec6&)>;

/// Two free nodes joined by the spring, thrown so that they swing and turn, and stretch it and compress it.
struct Swing {
  double k;
  double L0 = 1.07;
  double h = 2e-3;        // [s]
  double duration = 1.2;  // [s], about three swings
  Vec6 start = stacked(Vec3(0.43, -0.31, 0.47), Vec3(-0.37, 0.29, -0.38));
  Vec6 mass = stacked(Vec3::Constant(0.53), Vec3::Constant(0.81));

  Trajectory run(const Forces& forces, const Vec6& first) const {
    const FunctionSystem system(std::vector<double>(mass.begin(), mass.end()), [&](double, In x, In, Out f) {
      const Vec6 F = forces(Eigen::Map<const Vec6>(x.data()));
      std::copy(F.begin(), F.end(), f.begin());
    });
    muelle::State state;
    state.x.assign(first.begin(), first.end());
    state.v = {0.3, 0.8, -0.2, -0.1, -0.4, 0.7};
    muelle::MarchOptions options;
    options.h = h;
    options.duration = duration;
    return muelle::march(system, state, options);
  }
  Trajectory submitted() const {
    return run([this](const Vec6& x) { return submission::springForces(x, k, L0); }, start);
  }
  Trajectory expected(const Vec6& first) const {
    return run([this](const Vec6& x) { return oracle::springForces(x, k, L0); }, first);
  }
};

Swing someSwing() {
  Random random = testRandom();
  return {random.rounded(50.0, 90.0)};
}

Vec6 positions(const Trajectory& run, std::size_t i) { return Eigen::Map<const Vec6>(run.x[i].data()); }
Vec6 velocities(const Trajectory& run, std::size_t i) { return Eigen::Map<const Vec6>(run.v[i].data()); }

/// Where two runs end that start so far aside of one another, at the most [m].
double spread(const Trajectory& one, const Trajectory& other, double aside) {
  double largest = aside;
  for (std::size_t i = 0; i < one.t.size(); ++i) {
    largest = std::max(largest, (positions(one, i) - positions(other, i)).norm());
  }
  return largest;
}

}  // namespace

TEST(StretchAndRelease, SwingsLikeTheReference) {
  MUELLE_PROPERTY("a free pair of nodes on the spring moves as the reference does");
  const Swing swing = someSwing();
  const Trajectory run = swing.submitted();
  MUELLE_EXPECT_WENT_ON(run);
  if (run.stop.stopped) return;
  const Trajectory reference = swing.expected(swing.start);
  // Forces that are right to 1e-6 (inStructure) do less than 1e-6 m at the start do.
  const Vec6 aside = swing.start + 1e-6 * stacked(Vec3(0.6, 0.48, -0.64), Vec3(-0.48, 0.64, 0.6));
  const double tolerance = spread(reference, swing.expected(aside), 1e-6);
  for (std::size_t i = 0; i < reference.t.size(); i += 20) {
    MUELLE_LABEL(fmt::format("positions of a and b at t = {:.2f} s", reference.t[i]), "m");
    ASSERT_VECTOR_NEAR(positions(run, i), positions(reference, i), tolerance);
  }
}

TEST(StretchAndRelease, KeepsTheEnergyWhileItSwings) {
  MUELLE_PROPERTY(
      "kinetic energy plus springEnergy of a free pair of nodes stays what it is, but for the method's ripple");
  MUELLE_EXPECT_ANSWERS(springEnergy);
  MUELLE_EXPECT_ANSWERS(springForces);
  const Swing swing = someSwing();
  const Trajectory run = swing.submitted();
  MUELLE_EXPECT_WENT_ON(run);
  if (run.stop.stopped) return;
  const auto energyAt = [&](std::size_t i) {
    const Vec6 v = velocities(run, i);
    return 0.5 * v.dot(swing.mass.cwiseProduct(v)) + submission::springEnergy(positions(run, i), swing.k, swing.L0);
  };
  // Symplectic Euler keeps E - (h / 2) F . v + O(h^2) (Hairer, Lubich, Wanner, IX.3): the energy departs from its first
  // value by h times the largest power at most; half as much again for the terms in h^2.
  double power = 0.0;
  for (std::size_t i = 0; i < run.t.size(); ++i) {
    const Vec6 F = submission::springForces(positions(run, i), swing.k, swing.L0);
    power = std::max(power, std::abs(F.dot(velocities(run, i))));
  }
  const double start = energyAt(0);
  for (std::size_t i = 0; i < run.t.size(); i += 20) {
    MUELLE_LABEL(fmt::format("kinetic energy plus springEnergy at t = {:.2f} s", run.t[i]), "J");
    ASSERT_NUMBER_NEAR(energyAt(i), start, 1.5 * swing.h * power);
  }
}
