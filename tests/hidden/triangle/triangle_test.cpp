#include "triangle.h"

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
using muelle::Out;
using muelle::Random;
using muelle::State;
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

constexpr double shortest = 1e-100;     // [m], of the contract
constexpr double longestRest = 1000.0;  // [m], of the contract

/// A tolerance for values: some 40 roundings of 1.1e-16 in any order of the sums, with lengths by any formula, are
/// 4e-15 of the numbers involved; the best central difference is off by 4e-11, single precision by 6e-8.
double inRounding(double scale) { return 1e-13 * scale; }

/// A tolerance for laws, which are about structure and not about digits: a derivative by differences, or single
/// precision, breaks none of them. It loses the criterion of its values.
double inStructure(double scale) { return 1e-6 * scale; }

constexpr int first(int spring) { return spring; }
constexpr int second(int spring) { return (spring + 1) % 3; }
constexpr int opposite(int spring) { return (spring + 2) % 3; }  ///< the node that the spring does not touch
const char* nameOf(int spring) {
  constexpr const char* names[] = {"01", "12", "20"};
  return names[spring];
}

/// A triangle somewhere in space.
struct Case {
  Vec9 x;
  Vec3 k;
  Vec3 L0;

  Vec3 node(int i) const { return x.segment<3>(3 * i); }
  double length(int spring) const { return (node(first(spring)) - node(second(spring))).stableNorm(); }
  /// The largest length there is.
  double lengthScale() const { return std::max({length(0), length(1), length(2), L0.maxCoeff()}); }
  double forceScale() const { return 2 * k.maxCoeff() * lengthScale(); }
  double energyScale() const { return 3 * k.maxCoeff() * lengthScale() * lengthScale(); }
};

Vec9 stacked(const Vec3& x0, const Vec3& x1, const Vec3& x2) {
  Vec9 x;
  x << x0, x1, x2;
  return x;
}

Vec9 moved(const Vec9& x, const Mat3& rotation, const Vec3& shift) {
  Vec9 there;
  for (int i = 0; i < 3; ++i) there.segment<3>(3 * i) = tidy(Vec3(rotation * x.segment<3>(3 * i) + shift), 1e5);
  return there;
}

/// Forces and nothing else are turned to the last digit.
Vec9 turned(const Vec9& F, const Mat3& rotation) {
  return stacked(rotation * F.segment<3>(0), rotation * F.segment<3>(3), rotation * F.segment<3>(6));
}

/// Three stiffnesses, no two of which are within a tenth of each other.
Vec3 someStiffnesses(Random& random) {
  const double k = random.positive(20.0, 150.0);
  const Vec3 apart(k, k * random.number(1.15, 1.5), k * random.number(1.7, 2.4));
  const int shift = random.integer(0, 2);
  return threeDigits(Vec3(apart[shift], apart[(shift + 1) % 3], apart[(shift + 2) % 3]));
}

/// Three nodes no two of which are near each other: the corners (0,0), (2,0), (1,1.6), each moved by less than 0.35 m
/// (so no side is below 1.1 m), then the whole turned and moved.
Vec9 anyNodes(Random& random) {
  const Vec9 plain =
      stacked(random.vector3(0.2), Vec3(2, 0, 0) + random.vector3(0.2), Vec3(1, 1.6, 0) + random.vector3(0.2));
  const Mat3 rotation = random.rotation();
  const Vec3 shift = random.vector3(2.0);
  Vec9 x;
  for (int i = 0; i < 3; ++i) x.segment<3>(3 * i) = tidy(Vec3(rotation * plain.segment<3>(3 * i) + shift));
  return x;
}

/// Every spring is stretched or compressed by a tenth at least, each by a factor of its own.
Vec3 someRestLengths(Random& random, const Case& triangle) {
  Vec3 L0;
  for (int s = 0; s < 3; ++s) {
    const double ratio = random.number(1.15, 2.5);
    L0[s] = random.integer(0, 1) == 0 ? triangle.length(s) * ratio : triangle.length(s) / ratio;
  }
  return threeDigits(L0);
}

Case anyTriangle(Random& random) {
  Case triangle{anyNodes(random), someStiffnesses(random), Vec3::Zero()};
  triangle.L0 = someRestLengths(random, triangle);
  return triangle;
}

/// Hundreds of metres from the origin, where a length that is not one of the difference has lost its digits.
Case farTriangle(Random& random) {
  Case triangle = anyTriangle(random);
  const Vec3 shift(731.4, -612.9, 548.3);
  for (int i = 0; i < 3; ++i) triangle.x.segment<3>(3 * i) = tidy(Vec3(triangle.node(i) + shift));
  return triangle;
}

/// Triangles in the planes of two axes, whose sides lie along axes, numbered from each corner.
std::vector<Case> alignedTriangles(Random& random) {
  std::vector<Case> triangles;
  for (int axis = 0; axis < 3; ++axis) {
    for (int start = 0; start < 3; ++start) {
      const Vec3 corner = start == 0 ? Vec3(Vec3::Zero()) : tidy(random.vector3(2.0));
      const std::array<Vec3, 3> corners = {corner, tidy(Vec3(corner + 0.7 * Vec3::Unit(axis))),
                                           tidy(Vec3(corner - 1.3 * Vec3::Unit((axis + 1) % 3)))};
      const auto at = [&](int i) { return corners[static_cast<std::size_t>((start + i) % 3)]; };
      Case triangle{stacked(at(0), at(1), at(2)), someStiffnesses(random), Vec3::Zero()};
      triangle.L0 = someRestLengths(random, triangle);
      triangles.push_back(triangle);
    }
  }
  return triangles;
}

/// Two springs at rest to the rounding of their lengths, one stretched or compressed.
Case oneSpringStrained(Random& random, int strained) {
  Case triangle{anyNodes(random), someStiffnesses(random), Vec3::Zero()};
  for (int s = 0; s < 3; ++s) triangle.L0[s] = triangle.length(s);
  triangle.L0[strained] = tidy(triangle.L0[strained] * (random.integer(0, 1) == 0 ? 0.61 : 1.43));
  return triangle;
}

Vec9 sized(const Vec9& x, double size) {
  Vec9 there;
  for (int i = 0; i < 3; ++i) there.segment<3>(3 * i) = tidy(Vec3(size * x.segment<3>(3 * i)), 1e5);
  return there;
}

/// Every stiffness with every rest length, the ends of the contract among them, small triangles and large ones.
std::vector<Case> trianglesOfTheWholeRange() {
  std::vector<Case> triangles;
  const Vec9 corners = stacked(Vec3(-0.41, 0.23, 0.17), Vec3(0.37, 0.31, -0.29), Vec3(0.13, -0.43, 0.19));
  for (const double k : stiffnessLadder) {
    const Vec3 stiffnesses = k < 1e9 ? Vec3(k, 1.37 * k, 2.2 * k) : Vec3(0.41 * k, k, 0.73 * k);
    for (const Vec3& L0 : {Vec3(0, 0, 0), Vec3(0.043, 0, 1.7), Vec3(1.3, longestRest, 0.67)}) {
      for (const double size : {0.1, 7.0, 1000.0}) triangles.push_back({sized(corners, size), stiffnesses, L0});
    }
  }
  return triangles;
}

/// Triangles one spring of which is short, away from the origin: (2, -3, 6) 2^-n m, of length 7 2^-n m, exactly.
/// \param least its length [m]
std::vector<Case> exactShortSprings(double least) {
  std::vector<Case> triangles;
  for (const double unit : exactLengthLadder()) {
    if (7 * unit < least) break;
    for (int s = 0; s < 3; ++s) {
      Case triangle{Vec9::Zero(), Vec3(310, 270, 190), Vec3(1.7, 0.9, 1.3)};
      triangle.x.segment<3>(3 * first(s)) = Vec3(1.25, -1.75, 1.5) + unit * Vec3(2, -3, 6);
      triangle.x.segment<3>(3 * second(s)) = Vec3(1.25, -1.75, 1.5);
      triangle.x.segment<3>(3 * opposite(s)) = Vec3(-0.63, 0.41, 0.87);
      triangles.push_back(triangle);
    }
  }
  return triangles;
}

/// Triangles whose springs are nearly at rest, each by a stretch of its own that is exact: down to 2^-n m, either way.
/// \param least the smallest stretch [m]
std::vector<Case> nearlyRelaxedTriangles(double least) {
  std::vector<Case> triangles;
  for (const double stretch : exactLengthLadder()) {
    if (stretch < least) break;
    // Sides of 3, 5 and 4 m; a stretch is exact from 2^-50 m on.
    const Vec3 strained = Vec3(3, 5, 4) + stretch * Vec3(4, -8, 16);
    triangles.push_back({stacked(Vec3(0, 0, 0), Vec3(3, 0, 0), Vec3(0, 0, 4)), Vec3(73, 48, 59), strained});
  }
  return triangles;
}

double submittedEnergy(const Case& c) { return submission::triangleEnergy(c.x, c.k, c.L0); }
Vec9 submittedForce(const Case& c) { return submission::triangleForce(c.x, c.k, c.L0); }

void expectEnergy(const Case& c) {
  EXPECT_NUMBER_NEAR(submission::triangleEnergy(c.x, c.k, c.L0), oracle::triangleEnergy(c.x, c.k, c.L0),
                     inRounding(c.energyScale()));
}
void expectForce(const Case& c) {
  EXPECT_VECTOR_NEAR(submission::triangleForce(c.x, c.k, c.L0), oracle::triangleForce(c.x, c.k, c.L0),
                     inRounding(c.forceScale()));
}

}  // namespace

// --- MassMatrix -----------------------------------------------------------------------------------------------------

namespace {

/// No two alike, none a power of another, none whole or half.
Vec3 someMasses(Random& random) {
  const double m = random.positive(0.33, 3.1);
  return threeDigits(Vec3(tidy(m, 10) + 0.03, tidy(m * random.number(1.2, 1.7), 10) + 0.07,
                          tidy(m * random.number(2.1, 3.1), 10) + 0.01));
}

}  // namespace

TEST(MassMatrix, HasTheMassesOnItsDiagonal) {
  MUELLE_PROPERTY("the mass of a node stands on the diagonal once for each of its components, and all else is zero");
  Random random = testRandom();
  std::vector<Vec3> all = {Vec3(1e-6, 1.7e-6, 1.3e-6), Vec3(1e6, 0.7e6, 0.3e6), Vec3(0.3, 17.0, 4.1)};
  for (int i = 0; i < 5; ++i) all.push_back(someMasses(random));
  for (const Vec3& m : all) {
    EXPECT_MATRIX_NEAR(submission::massMatrix(m), oracle::massMatrix(m), inRounding(m.maxCoeff()));
  }
}

TEST(MassMatrix, GivesTheKineticEnergy) {
  MUELLE_PROPERTY("v . M v / 2 is the sum of the kinetic energies of the nodes");
  Random random = testRandom();
  for (int i = 0; i < 3; ++i) {
    const Vec3 m = someMasses(random);
    const Vec9 v = stacked(tidy(random.vector3(3.0)), tidy(random.vector3(3.0)), tidy(random.vector3(3.0)));
    double expected = 0.0;
    for (int node = 0; node < 3; ++node) expected += 0.5 * m[node] * v.segment<3>(3 * node).squaredNorm();
    MUELLE_LABEL("kinetic energy v . M v / 2 with your M", "J");
    EXPECT_NUMBER_NEAR(0.5 * v.dot(submission::massMatrix(m) * v), expected, inRounding(expected));
  }
}

// --- TriangleEnergy -------------------------------------------------------------------------------------------------

TEST(TriangleEnergy, IsTheSumOverTheSprings) {
  MUELLE_PROPERTY("the energy is the sum of the energies of the springs 01, 12 and 20, each with its own k and L0");
  Random random = testRandom();
  for (int i = 0; i < 10; ++i) expectEnergy(anyTriangle(random));
  for (int i = 0; i < 4; ++i) expectEnergy(farTriangle(random));
  for (const Case& c : alignedTriangles(random)) expectEnergy(c);
}

TEST(TriangleEnergy, OfOneStrainedSpringIsThatOfTheSpring) {
  MUELLE_PROPERTY("with two springs at rest the energy is that of the third, for each of the three");
  Random random = testRandom();
  for (int s = 0; s < 3; ++s) expectEnergy(oneSpringStrained(random, s));
}

TEST(TriangleEnergy, IsLeastAtRest) {
  MUELLE_PROPERTY("the energy is zero where all springs are at rest, and only there");
  const Case rest{stacked(Vec3(0, 0, 0), Vec3(3, 0, 0), Vec3(0, 0, 4)), Vec3(73, 48, 59), Vec3(3, 5, 4)};
  expectEnergy(rest);
  for (const Case& c : nearlyRelaxedTriangles(1e-6)) expectEnergy(c);
}

TEST(TriangleEnergy, KeepsItsDigitsNearRest) {
  MUELLE_PROPERTY("near rest the lengths are subtracted before they are squared: the energy keeps its digits");
  // Sides of 1.5, 2 and 2.5 m, which every formula gives exactly or with three roundings, 7e-16 m: of a stretch of
  // 2^-30 m that is 8e-7, and twice as much of its square. What squares first is off by 5e-16 of L^2: 6e-4 of the
  // energy at 2^-20 m and hundreds of times the energy at 2^-30 m.
  const Vec9 x = stacked(Vec3(0, 0, 0), Vec3(1.5, 0, 0), Vec3(0, 0, 2));
  for (const double stretch : {0x1p-10, -0x1p-20, 0x1p-30}) {
    const Vec3 k(73, 48, 59), L0 = Vec3(1.5, 2.5, 2).array() - stretch;
    const double E = oracle::triangleEnergy(x, k, L0);
    EXPECT_NUMBER_NEAR(submission::triangleEnergy(x, k, L0), E, 1e-5 * E);
  }
}

TEST(TriangleEnergy, HoldsForEveryStiffnessAndLength) {
  MUELLE_PROPERTY("the energy is right for the softest and the hardest springs, and for any rest length, 0 too");
  for (const Case& c : trianglesOfTheWholeRange()) expectEnergy(c);
  for (const Case& c : exactShortSprings(0.01)) expectEnergy(c);
}

// --- TriangleForce --------------------------------------------------------------------------------------------------

TEST(TriangleForce, AddsTheForcesOfTheSprings) {
  MUELLE_PROPERTY("the force on each node is the sum of the forces of its two springs, each with its own k and L0");
  Random random = testRandom();
  for (int i = 0; i < 10; ++i) expectForce(anyTriangle(random));
  for (int i = 0; i < 4; ++i) expectForce(farTriangle(random));
  for (const Case& c : alignedTriangles(random)) expectForce(c);
}

TEST(TriangleForce, OfOneStrainedSpringActsOnItsTwoNodes) {
  MUELLE_PROPERTY(
      "with two springs at rest the third acts on its own two nodes alone: it pulls when stretched, pushes when "
      "compressed");
  Random random = testRandom();
  for (int s = 0; s < 3; ++s) expectForce(oneSpringStrained(random, s));
  for (const Case& c : nearlyRelaxedTriangles(1e-15)) expectForce(c);
}

TEST(TriangleForce, HoldsForEveryStiffnessAndLength) {
  MUELLE_PROPERTY("the force is right for the softest and the hardest springs, and for any rest length, 0 too");
  for (const Case& c : trianglesOfTheWholeRange()) expectForce(c);
  for (const Case& c : exactShortSprings(0.1)) expectForce(c);
}

// --- MinusTheGradient -----------------------------------------------------------------------------------------------

namespace {

/// Central differences of the submission's energy in all nine components.
Vec9 slopes(const Case& c, double h) {
  Vec9 slope;
  for (int i = 0; i < 9; ++i) {
    Case forward = c;
    Case backward = c;
    forward.x[i] += h;
    backward.x[i] -= h;
    slope[i] = (submittedEnergy(forward) - submittedEnergy(backward)) / (forward.x[i] - backward.x[i]);
  }
  return slope;
}

}  // namespace

TEST(MinusTheGradient, OfTheEnergyIsTheForce) {
  MUELLE_PROPERTY(
      "each component of triangleForce is minus the slope of triangleEnergy when that component of x moves");
  MUELLE_EXPECT_ANSWERS(triangleEnergy);
  MUELLE_EXPECT_ANSWERS(triangleForce);
  Random random = testRandom();
  for (int i = 0; i < 6; ++i) {
    Case c = anyTriangle(random);
    if (i >= 4) c.L0.setZero();
    // E''' = -k L0 L''' for each of two springs, with |L'''| <= 1.16 / L^2 and L >= 1.1 m: h^2 / 3 k L0, 3e-9 of the
    // scale. The energies carry some 1e-15 of their scale, divided by h: 1e-11. The law allows more: see inStructure.
    const double h = 1e-4;
    const Vec9 force = submittedForce(c);
    MUELLE_LABEL("minus the slope of your triangleEnergy, where your triangleForce is expected", "N");
    EXPECT_VECTOR_NEAR(Vec9(-slopes(c, h)), force, inStructure(c.forceScale()));
  }
}

TEST(MinusTheGradient, IsApproachedWithOrderTwo) {
  MUELLE_PROPERTY(
      "halving the step of the central difference of triangleEnergy divides its distance to minus triangleForce by "
      "four");
  MUELLE_EXPECT_ANSWERS(triangleEnergy);
  MUELLE_EXPECT_ANSWERS(triangleForce);
  Random random = testRandom();
  for (int i = 0; i < 2; ++i) {
    const Case c = anyTriangle(random);
    const Vec9 force = submittedForce(c);
    const double h = 0.04;
    const double coarse = (slopes(c, h) + force).norm();
    const double fine = (slopes(c, h / 2) + force).norm();
    // The next term of the error is of relative size 2 (h / L)^2 = 3e-3 a spring.
    MUELLE_LABEL("distance of slope and force with half the step, where a quarter is expected", "N");
    EXPECT_NUMBER_NEAR(fine, coarse / 4, 0.02 * coarse + inStructure(c.forceScale()));
  }
}

TEST(MinusTheGradient, DoesNoWorkOverACycle) {
  MUELLE_PROPERTY("over any closed path of the three nodes the work of triangleForce is zero");
  MUELLE_EXPECT_ANSWERS(triangleForce);
  Random random = testRandom();
  const Case c = anyTriangle(random);
  const Vec9 u = stacked(random.vector3(0.1), random.vector3(0.1), random.vector3(0.1));
  const Vec9 w = stacked(random.vector3(0.1), random.vector3(0.1), random.vector3(0.1));
  // The integrand is smooth and periodic: two nodes approach each other by 0.7 m at most of 1.1 m, and the sum over
  // equal steps with the exact tangent converges geometrically. For a force with a bend it is off by
  // (2 pi / 128)^2 / 8 = 3e-4 of (0.1 m)^2 k.
  constexpr int n = 128;
  double total = 0.0;
  for (int step = 0; step < n; ++step) {
    const double angle = 2 * M_PI * step / n;
    Case there = c;
    there.x += std::cos(angle) * u + std::sin(angle) * w;
    const Vec9 tangent = -std::sin(angle) * u + std::cos(angle) * w;
    total += submittedForce(there).dot(tangent) * 2 * M_PI / n;
  }
  MUELLE_LABEL("work of your triangleForce over a closed path", "J");
  EXPECT_NUMBER_NEAR(total, 0.0, 1e-5 * c.energyScale());
}

// --- NewtonsThirdLaw ------------------------------------------------------------------------------------------------

TEST(NewtonsThirdLaw, LeavesNoNetForce) {
  MUELLE_PROPERTY("the forces on the three nodes add up to zero");
  MUELLE_EXPECT_ANSWERS(triangleForce);
  Random random = testRandom();
  for (int i = 0; i < 6; ++i) {
    const Vec9 F = submittedForce(anyTriangle(random));
    MUELLE_LABEL("sum of the forces on the three nodes", "N");
    EXPECT_VECTOR_NEAR(Vec3(F.segment<3>(0) + F.segment<3>(3) + F.segment<3>(6)), Vec3(Vec3::Zero()),
                       inStructure(F.norm()));
  }
}

TEST(NewtonsThirdLaw, LeavesNoNetTorque) {
  MUELLE_PROPERTY("the torques of the three forces about any point add up to zero");
  MUELLE_EXPECT_ANSWERS(triangleForce);
  Random random = testRandom();
  for (int i = 0; i < 6; ++i) {
    const Case c = anyTriangle(random);
    const Vec9 F = submittedForce(c);
    Vec3 torque = Vec3::Zero();
    for (int node = 0; node < 3; ++node) torque += c.node(node).cross(Vec3(F.segment<3>(3 * node)));
    MUELLE_LABEL("sum of the torques of the three forces about the origin", "N m");
    EXPECT_VECTOR_NEAR(torque, Vec3(Vec3::Zero()), inStructure(F.norm() * c.x.norm()));
  }
}

// --- Equivariance ---------------------------------------------------------------------------------------------------

namespace {

/// What a triangle and the same one seen in another way answer.
void expectSame(const std::string& what, const Case& before, const Case& after, const Vec9& expectedForce) {
  {
    MUELLE_LABEL("energy after " + what, "J");
    EXPECT_NUMBER_NEAR(submittedEnergy(after), submittedEnergy(before), inStructure(before.energyScale()));
  }
  MUELLE_LABEL("forces after " + what, "N");
  EXPECT_VECTOR_NEAR(submittedForce(after), expectedForce, inStructure(expectedForce.norm()));
}

}  // namespace

TEST(Equivariance, ATurnedTriangleHasTurnedForces) {
  MUELLE_PROPERTY("moving the triangle changes neither energy nor forces; turning it turns the forces with it");
  MUELLE_EXPECT_ANSWERS(triangleEnergy);
  MUELLE_EXPECT_ANSWERS(triangleForce);
  Random random = testRandom();
  for (int i = 0; i < 6; ++i) {
    const Case c = anyTriangle(random);
    const Mat3 rotation = someTurn(i);
    const Vec9 F = submittedForce(c);
    const Vec3 shift = threeDigits(Vec3(random.vector3(9.0) + Vec3(10, -10, 10)));
    expectSame("the triangle has moved", c, {moved(c.x, Mat3::Identity(), shift), c.k, c.L0}, F);
    expectSame("the triangle is turned", c, {moved(c.x, rotation, Vec3::Zero()), c.k, c.L0}, turned(F, rotation));
  }
}

TEST(Equivariance, ARenumberedTriangleHasRenumberedForces) {
  MUELLE_PROPERTY(
      "numbering the nodes, and with them the springs, from another corner or the other way round renumbers the "
      "forces");
  MUELLE_EXPECT_ANSWERS(triangleEnergy);
  MUELLE_EXPECT_ANSWERS(triangleForce);
  Random random = testRandom();
  for (int i = 0; i < 5; ++i) {
    const Case c = anyTriangle(random);
    const Vec9 F = submittedForce(c);
    // From corner 1: nodes 1, 2, 0 and springs 12, 20, 01.
    const Case round{stacked(c.node(1), c.node(2), c.node(0)), {c.k[1], c.k[2], c.k[0]}, {c.L0[1], c.L0[2], c.L0[0]}};
    expectSame("the numbering begins at node 1", c, round, stacked(F.segment<3>(3), F.segment<3>(6), F.segment<3>(0)));
    // The other way round: nodes 0, 2, 1 and springs 02, 21, 10.
    const Case back{stacked(c.node(0), c.node(2), c.node(1)), {c.k[2], c.k[1], c.k[0]}, {c.L0[2], c.L0[1], c.L0[0]}};
    expectSame("nodes 1 and 2 have exchanged their numbers", c, back,
               stacked(F.segment<3>(0), F.segment<3>(6), F.segment<3>(3)));
  }
}

// --- edges: partial, one test a function ----------------------------------------------------------------------------

namespace {

/// One spring is short, or its nodes coincide; the third node is far away, and its springs feel nothing of that.
struct Scene {
  int spring;
  Vec3 middle = Vec3::Zero();  ///< of the spring

  static constexpr double from = 0.3, past = 0.03;  ///< lengths that answers are followed from [m]

  /// \param d from the second node of the spring to the first
  Case with(const Vec3& d, double L0) const {
    Case c{Vec9::Zero(), Vec3(73, 48, 59), Vec3::Constant(L0)};
    c.x.segment<3>(3 * first(spring)) = middle + d / 2;
    c.x.segment<3>(3 * second(spring)) = middle - d / 2;
    c.x.segment<3>(3 * opposite(spring)) = middle + Vec3(330, -270, 260);
    return c;
  }
  /// Along no axis.
  static Vec3 along(double L) { return L / 7 * Vec3(2, -3, 6); }

  /// Half of the difference of the forces for d and for -d: that of the short spring, for the others cancel out.
  Vec9 forceOfShort(const Vec3& d) const {
    return 0.5 * (submittedForce(with(d, longestRest)) - submittedForce(with(-d, longestRest)));
  }
};

/// Where the short spring may lie, of each of the three.
std::vector<Scene> scenes() {
  std::vector<Scene> all;
  for (int s = 0; s < 3; ++s) {
    all.push_back({s});
    all.push_back({s, Vec3(0.25, -0.75, 1.5)});
  }
  return all;
}

/// Whether the force of short springs neither grows nor fades as they get shorter; else it is wrong at any length.
bool isSteady(const Vec9& at, const Vec9& below) { return at.norm() > 0 && (at - below).norm() < 0.01 * at.norm(); }

std::string placeOf(const Scene& scene, double L) {
  return fmt::format("with spring {} of L = {:.2g} m{}", nameOf(scene.spring), L,
                     scene.middle.isZero() ? "" : ", away from the origin");
}

}  // namespace

TEST(CoincidentNodes, KeepTheEnergyOfFullCompression) {
  MUELLE_PROPERTY("a spring whose nodes coincide keeps the energy of being compressed by all of its rest length");
  MUELLE_EXPECT_ANSWERS(triangleEnergy);
  for (const Scene& scene : scenes()) {
    // Half of a metre in a thousand is 1e-3 of the energy.
    const double near = submittedEnergy(scene.with(Scene::along(Scene::from), longestRest));
    MUELLE_LABEL("energy " + placeOf(scene, 0) + ", expected about as at L = 0.3 m", "J");
    EXPECT_NUMBER_NEAR(submittedEnergy(scene.with(Vec3::Zero(), longestRest)), near, 3e-3 * std::abs(near));
  }
}

TEST(CoincidentNodes, FeelTheOtherSpringsAlone) {
  MUELLE_PROPERTY("a spring whose nodes coincide contributes no force, and the two others act as usual");
  MUELLE_EXPECT_ANSWERS(triangleForce);
  const Vec3 small = Scene::along(1e-6);
  for (const Scene& scene : scenes()) {
    // Without rest lengths a short spring hardly pulls, and the others act as at L = 0, but for 1e-6 / 500.
    const Vec9 slack = submittedForce(scene.with(small, 0.0));
    {
      MUELLE_LABEL("forces " + placeOf(scene, 0) + ", expected about as at L = 1e-6 m; all L0 = 0", "N");
      EXPECT_VECTOR_NEAR(submittedForce(scene.with(Vec3::Zero(), 0.0)), slack, inStructure(slack.norm()));
    }
    // With rest lengths it pushes as hard to one side for d as to the other for -d, and not at all between.
    const Case collapsed = scene.with(Vec3::Zero(), longestRest);
    Case harder = collapsed;
    harder.k[scene.spring] *= 2;
    const Vec9 got = submittedForce(collapsed);
    const double tolerance = inStructure(got.norm());
    if ((submittedForce(harder) - got).norm() <= tolerance) continue;  // it contributes nothing, as is asked
    const Vec9 oneSide = submittedForce(scene.with(small, longestRest));
    const Vec9 otherSide = submittedForce(scene.with(-small, longestRest));
    MUELLE_LABEL("forces " + placeOf(scene, 0) + ", expected between those at 1e-6 m to either side", "N");
    EXPECT_VECTOR_NEAR(got, Vec9(0.5 * (oneSide + otherSide)), inStructure(oneSide.norm()));
  }
}

TEST(CoincidentNodes, AllThreeFeelNothing) {
  MUELLE_PROPERTY("where all three nodes coincide there is no force, not NaN, whatever the rest lengths are");
  MUELLE_EXPECT_ANSWERS(triangleForce);
  for (const Vec3& L0 : {Vec3(1.1, 2.3, 3.7), Vec3(0, 0, 0), Vec3(0, 1.9, longestRest)}) {
    for (const Vec3& point : {Vec3(0, 0, 0), Vec3(0.3, -0.7, 1.1), Vec3(-870, 640, -390)}) {
      const Vec9 x = stacked(point, point, point);
      EXPECT_VECTOR_NEAR(submission::triangleForce(x, Vec3(73, 48, 59), L0), Vec9(Vec9::Zero()),
                         inStructure(73 * (L0.maxCoeff() + 1)));
    }
  }
}

TEST(TinyLengths, HaveAnEnergy) {
  MUELLE_PROPERTY("the energy does not jump when a spring gets shorter and shorter, down to 1e-100 m");
  MUELLE_EXPECT_ANSWERS(triangleEnergy);
  for (int s = 0; s < 3; ++s) {
    const Scene scene{s};
    const double near = submittedEnergy(scene.with(Scene::along(Scene::from), longestRest));
    for (const double L : lengthLadder(shortest)) {
      MUELLE_LABEL("energy " + placeOf(scene, L) + ", expected about as at L = 0.3 m", "J");
      EXPECT_NUMBER_NEAR(submittedEnergy(scene.with(Scene::along(L), longestRest)), near, 3e-3 * std::abs(near));
    }
  }
}

TEST(TinyLengths, HaveADirection) {
  MUELLE_PROPERTY("a spring of any length above zero, 1e-9 m or 1e-100 m, has a direction, and pushes along it");
  MUELLE_EXPECT_ANSWERS(triangleForce);
  for (int s = 0; s < 3; ++s) {
    const Scene scene{s};
    const Vec9 near = scene.forceOfShort(Scene::along(Scene::from));
    if (!isSteady(near, scene.forceOfShort(Scene::along(Scene::past)))) continue;
    for (const double L : lengthLadder(shortest)) {
      MUELLE_LABEL("force of the short spring " + placeOf(scene, L) + ", expected about as at L = 0.3 m", "N");
      EXPECT_VECTOR_NEAR(scene.forceOfShort(Scene::along(L)), near, 3e-3 * near.norm());
    }
  }
}

TEST(TinyLengths, HaveADirectionAwayFromTheOrigin) {
  MUELLE_PROPERTY("two nodes that differ in the last digits only have a direction between them");
  MUELLE_EXPECT_ANSWERS(triangleForce);
  for (int s = 0; s < 3; ++s) {
    const Scene scene{s, Vec3(1.25, -1.75, 1.5)};
    const auto at = [&](double unit) { return scene.forceOfShort(2 * unit * Vec3(2, -3, 6)); };
    const std::vector<double> units = exactLengthLadder();
    const Vec9 near = at(units[1]);
    if (!isSteady(at(units[0]), near)) continue;
    for (const double unit : units) {
      MUELLE_LABEL("force of the short spring " + placeOf(scene, 14 * unit) + ", expected about as at L = 0.44 m", "N");
      EXPECT_VECTOR_NEAR(at(unit), near, 0.02 * near.norm());
    }
  }
}

// --- FreeFlight -----------------------------------------------------------------------------------------------------

namespace {

/// A triangle thrown into empty space, turning and swinging; its springs are stretched and compressed.
struct Flight {
  Vec3 k;
  Vec3 m{0.53, 0.81, 0.62};
  Vec3 L0{1.03, 1.12, 0.91};
  double h = 2e-3;        // [s]
  double duration = 1.0;  // [s], some three swings
  Vec9 start = stacked(Vec3(-0.55, -0.31, 0.27), Vec3(0.63, -0.35, -0.12), Vec3(0.07, 0.66, 0.34));
  Vec9 velocity = stacked(Vec3(0.9, -0.8, 0.3), Vec3(0.6, 0.9, -0.2), Vec3(-0.8, 0.2, 0.4));

  Trajectory fly() const {
    std::vector<double> mass;
    for (int c = 0; c < 9; ++c) mass.push_back(m[c / 3]);
    const FunctionSystem system(mass, [&](double, In x, In, Out f) {
      const Vec9 F = submission::triangleForce(Eigen::Map<const Vec9>(x.data()), k, L0);
      std::copy(F.begin(), F.end(), f.begin());
    });
    State state;
    state.x.assign(start.begin(), start.end());
    state.v.assign(velocity.begin(), velocity.end());
    muelle::MarchOptions options;
    options.h = h;
    options.duration = duration;
    return muelle::march(system, state, options);
  }

  double kinetic(const Vec9& v) const {
    double T = 0.0;
    for (int c = 0; c < 9; ++c) T += 0.5 * m[c / 3] * v[c] * v[c];
    return T;
  }
  Vec3 momentum(const Vec9& v) const {
    return m[0] * v.segment<3>(0) + m[1] * v.segment<3>(3) + m[2] * v.segment<3>(6);
  }
  Vec3 angularMomentum(const Vec9& x, const Vec9& v) const {
    Vec3 L = Vec3::Zero();
    for (int i = 0; i < 3; ++i) L += m[i] * Vec3(x.segment<3>(3 * i)).cross(Vec3(v.segment<3>(3 * i)));
    return L;
  }
};

Flight someFlight() {
  Random random = testRandom();
  return {tidy(Vec3(random.number(55, 65), random.number(40, 50), random.number(70, 85)), 10)};
}

Vec9 positions(const Trajectory& run, std::size_t i) { return Eigen::Map<const Vec9>(run.x[i].data()); }
Vec9 velocities(const Trajectory& run, std::size_t i) { return Eigen::Map<const Vec9>(run.v[i].data()); }

}  // namespace

TEST(FreeFlight, KeepsItsEnergy) {
  MUELLE_PROPERTY("elastic plus kinetic energy of a free triangle is kept, but for the small ripple of the method");
  MUELLE_EXPECT_ANSWERS(triangleEnergy);
  MUELLE_EXPECT_ANSWERS(triangleForce);
  const Flight flight = someFlight();
  const Trajectory run = flight.fly();
  MUELLE_EXPECT_WENT_ON(run);
  if (run.stop.stopped) return;
  // Symplectic Euler keeps E - (h / 2) F . v + O(h^2) (Hairer, Lubich, Wanner, IX.3): the energy departs from its first
  // value by h times the largest power at most; half as much again for the terms in h^2.
  double power = 0.0;
  for (std::size_t i = 0; i < run.t.size(); ++i) {
    const Vec9 F = submission::triangleForce(positions(run, i), flight.k, flight.L0);
    power = std::max(power, std::abs(F.dot(velocities(run, i))));
  }
  const auto energyAt = [&](std::size_t i) {
    return submission::triangleEnergy(positions(run, i), flight.k, flight.L0) + flight.kinetic(velocities(run, i));
  };
  const double start = energyAt(0);
  for (std::size_t i = 0; i < run.t.size(); i += 10) {
    MUELLE_LABEL(fmt::format("elastic plus kinetic energy at t = {:.2f} s", run.t[i]), "J");
    ASSERT_NUMBER_NEAR(energyAt(i), start, 1.5 * flight.h * power);
  }
}

TEST(FreeFlight, KeepsBothMomenta) {
  MUELLE_PROPERTY("linear and angular momentum of a free triangle are kept");
  MUELLE_EXPECT_ANSWERS(triangleForce);
  const Flight flight = someFlight();
  const Trajectory run = flight.fly();
  MUELLE_EXPECT_WENT_ON(run);
  if (run.stop.stopped) return;
  const Vec3 p = flight.momentum(flight.velocity);
  const Vec3 L = flight.angularMomentum(flight.start, flight.velocity);
  // Symplectic Euler keeps both exactly for any forces without net force and torque.
  for (std::size_t i = 0; i < run.t.size(); i += 10) {
    {
      MUELLE_LABEL(fmt::format("linear momentum at t = {:.2f} s", run.t[i]), "kg m/s");
      ASSERT_VECTOR_NEAR(flight.momentum(velocities(run, i)), p, inStructure(1));
    }
    MUELLE_LABEL(fmt::format("angular momentum at t = {:.2f} s", run.t[i]), "kg m^2/s");
    ASSERT_VECTOR_NEAR(flight.angularMomentum(positions(run, i), velocities(run, i)), L, inStructure(1));
  }
}
