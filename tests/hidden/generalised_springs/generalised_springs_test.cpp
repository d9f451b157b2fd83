#include "generalised_springs.h"

#include "course/testing/expect.h"
#include "course/testing/random.h"
#include "engine/elements/angle/angle.h"
#include "engine/elements/area/area.h"
#include "engine/elements/volume/volume.h"
#include "grader/testing/ladders.h"
#include "grader/testing/of_use.h"
#include "grader/testing/plain_numbers.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <Eigen/Geometry>

using muelle::Random;
using muelle::testRandom;
using muelle::threeDigits;
using muelle::VecX;
using muelle::grader::lengthLadder;
using muelle::grader::stiffnessLadder;
using muelle::grader::tidy;

namespace {

constexpr double smallest = 1e-30;      // [m] and [rad], of the contract
constexpr double widestRest = 3.14159;  // [rad], of the contract
constexpr double largestRest = 1000.0;  // [m^2] and [m^3], of the contract

/// A tolerance for values: some 100 roundings of 1.1e-16 are 1e-14 of the numbers involved; the best central difference
/// is off by 4e-11, single precision by 6e-8.
double inRounding(double scale) { return 1e-13 * scale; }

/// A tolerance for laws, which are about structure and not about digits: a derivative by differences, or single
/// precision, breaks none of them. It loses the criterion of its values.
double inStructure(double scale) { return 1e-6 * scale; }

/// Nodes, and the rest value and the stiffness of what joins them.
template <class Vector>
struct Case {
  Vector x;
  double rest, k;

  int count() const { return static_cast<int>(x.size() / 3); }
  Vec3 node(int i) const { return x.template segment<3>(3 * i); }
  Vec3 edge(int from, int to) const { return node(to) - node(from); }
  double shortestEdge() const {
    double least = edge(0, 1).norm();
    for (int i = 0; i < count(); ++i) {
      for (int j = 0; j < i; ++j) least = std::min(least, edge(i, j).norm());
    }
    return least;
  }
  /// The longest.
  double size() const {
    double most = 0;
    for (int i = 0; i < count(); ++i) {
      for (int j = 0; j < i; ++j) most = std::max(most, edge(i, j).norm());
    }
    return most;
  }
  /// What roundings of positions are to those of edges: far from the origin differences lose digits.
  double distance() const { return 1 + x.cwiseAbs().maxCoeff() / shortestEdge(); }
};
using Three = Case<Vec9>;
using Four = Case<Vec12>;

double angleOf(const Three& c) {
  const Vec3 u = c.edge(0, 1), w = c.edge(1, 2);
  return std::atan2(u.cross(w).norm(), u.dot(w));
}
double areaOf(const Three& c) { return c.edge(0, 1).cross(c.edge(0, 2)).norm() / 2; }
double volumeOf(const Four& c) { return c.edge(0, 1).cross(c.edge(0, 2)).dot(c.edge(0, 3)) / 6; }

Vec9 stacked(const Vec3& x0, const Vec3& x1, const Vec3& x2) {
  Vec9 x;
  x << x0, x1, x2;
  return x;
}
Vec12 stacked(const Vec3& x0, const Vec3& x1, const Vec3& x2, const Vec3& x3) {
  Vec12 x;
  x << x0, x1, x2, x3;
  return x;
}

/// Above the value in every other turn, below it in the others.
double besides(double value, double away, int turn) { return threeDigits(turn % 2 == 0 ? value + away : value - away); }

/// Three nodes about a point that is not the origin: no edge is short, no angle near 0 or pi, no component zero.
Vec9 threeNodes(Random& random) {
  for (;;) {
    const Vec3 middle = random.vector3(0.8) + Vec3(0.9, -1.1, 0.7);
    const Three c{stacked(tidy(middle + random.vector3(1.2)), tidy(middle), tidy(middle + random.vector3(1.2))), 0, 1};
    const double angle = angleOf(c);
    if (angle > 0.5 && angle < 2.5 && areaOf(c) > 0.3 && c.shortestEdge() > 0.5) return c.x;
  }
}

Three anyBend(Random& random, int turn) {
  Three c{threeNodes(random), 0, threeDigits(random.positive(20.0, 150.0))};
  c.rest = besides(angleOf(c), random.number(0.1, 0.45), turn);
  return c;
}
Three anyTriangle(Random& random, int turn) {
  Three c{threeNodes(random), 0, threeDigits(random.positive(20.0, 150.0))};
  c.rest = besides(areaOf(c), random.number(0.1, 0.28), turn);
  return c;
}

/// The two turns of a pair have volumes of two signs, the two pairs are too large and too small.
Four anyTetrahedron(Random& random, int turn) {
  for (;;) {
    const Vec3 middle = random.vector3(0.8) + Vec3(0.9, -1.1, 0.7);
    const auto near = [&] { return tidy(Vec3(middle + random.vector3(1.3))); };
    Four c{stacked(near(), near(), near(), near()), 0, threeDigits(random.positive(20.0, 150.0))};
    const double V = volumeOf(c);
    if (std::abs(V) < 0.2 || c.shortestEdge() < 0.5 || (V > 0) != (turn % 2 == 0)) continue;
    c.rest = besides(V, random.number(0.1, 0.6), turn / 2);
    return c;
  }
}

template <class Vector>
Case<Vector> movedBy(Case<Vector> c, const Vec3& way) {
  for (int i = 0; i < c.count(); ++i) c.x.template segment<3>(3 * i) = tidy(Vec3(c.node(i) + way));
  return c;
}
const Vec3 farAway(61.3, -57.9, 71.8);  // [m]

/// In turn as they come, and two far from the origin.
template <class Any>
auto someOf(Random& random, const Any& any) {
  std::vector<decltype(any(random, 0))> cases;
  for (int turn = 0; turn < 8; ++turn) cases.push_back(any(random, turn));
  for (int turn = 0; turn < 2; ++turn) cases.push_back(movedBy(any(random, turn), farAway));
  return cases;
}

/// Nodes whose edges lie along axes, in every order.
std::vector<Vec9> alignedNodes() {
  std::vector<Vec9> all;
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3 a = 0.7 * Vec3::Unit(axis), b = -1.3 * Vec3::Unit((axis + 1) % 3), o = Vec3::Zero();
    all.push_back(stacked(a, o, b));
    all.push_back(stacked(o, b, a));
    all.push_back(stacked(b, a, o));
  }
  return all;
}

/// Every stiffness with every rest value, the ends of the contract among them, small ones and large ones.
template <class Vector>
std::vector<Case<Vector>> wholeRange(const Vector& x, const std::vector<double>& rests) {
  std::vector<Case<Vector>> cases;
  for (const double k : stiffnessLadder) {
    for (const double rest : rests) {
      for (const double size : {0.13, 1.0, 83.0}) cases.push_back({size * x, rest, k});
    }
  }
  return cases;
}
const Vec9 unequal = stacked(Vec3(-0.41, 0.23, 0.17), Vec3(0.37, 1, -0.29), Vec3(0.13, -0.43, 0.83));
const Vec12 uneven =
    stacked(Vec3(-0.41, 0.23, 0.17), Vec3(0.37, 1, -0.29), Vec3(0.13, -0.43, 0.83), Vec3(0.71, 0.2, 0.6));

double ownBendingEnergy(const Three& c) { return submission::bendingEnergy(c.x, c.rest, c.k); }
Vec9 ownBendingForce(const Three& c) { return submission::bendingForce(c.x, c.rest, c.k); }
double ownAreaEnergy(const Three& c) { return submission::areaEnergy(c.x, c.rest, c.k); }
Vec9 ownAreaForce(const Three& c) { return submission::areaForce(c.x, c.rest, c.k); }
double ownVolumeEnergy(const Four& c) { return submission::volumeEnergy(c.x, c.rest, c.k); }
Vec12 ownVolumeForce(const Four& c) { return submission::volumeForce(c.x, c.rest, c.k); }

void expectAngle(const Three& c) {
  EXPECT_NUMBER_NEAR(submission::bendingAngle(c.x), oracle::bendingAngle(c.x), inRounding(10 * c.distance()));
}
void expectBendingEnergy(const Three& c) {
  EXPECT_NUMBER_NEAR(submission::bendingEnergy(c.x, c.rest, c.k), oracle::bendingEnergy(c.x, c.rest, c.k),
                     inRounding(20 * c.k * c.distance()));
}
void expectBendingForce(const Three& c) {
  EXPECT_VECTOR_NEAR(submission::bendingForce(c.x, c.rest, c.k), oracle::bendingForce(c.x, c.rest, c.k),
                     inRounding(20 * c.k * c.distance() / c.shortestEdge()));
}
/// \param c with its rest value
double areaScale(const Three& c) { return c.size() * c.size() * c.distance() + c.rest; }
void expectArea(const Three& c) {
  EXPECT_NUMBER_NEAR(submission::triangleArea(c.x), oracle::triangleArea(c.x),
                     inRounding(c.size() * c.size() * c.distance()));
}
void expectAreaEnergy(const Three& c) {
  EXPECT_NUMBER_NEAR(submission::areaEnergy(c.x, c.rest, c.k), oracle::areaEnergy(c.x, c.rest, c.k),
                     inRounding(c.k * areaScale(c) * areaScale(c)));
}
void expectAreaForce(const Three& c) {
  EXPECT_VECTOR_NEAR(submission::areaForce(c.x, c.rest, c.k), oracle::areaForce(c.x, c.rest, c.k),
                     inRounding(c.k * areaScale(c) * c.size() * c.distance()));
}
double volumeScale(const Four& c) { return std::pow(c.size(), 3) * c.distance() + std::abs(c.rest); }
void expectVolume(const Four& c) {
  EXPECT_NUMBER_NEAR(submission::tetrahedronVolume(c.x), oracle::tetrahedronVolume(c.x),
                     inRounding(std::pow(c.size(), 3) * c.distance()));
}
void expectVolumeEnergy(const Four& c) {
  EXPECT_NUMBER_NEAR(submission::volumeEnergy(c.x, c.rest, c.k), oracle::volumeEnergy(c.x, c.rest, c.k),
                     inRounding(c.k * volumeScale(c) * volumeScale(c)));
}
void expectVolumeForce(const Four& c) {
  EXPECT_VECTOR_NEAR(submission::volumeForce(c.x, c.rest, c.k), oracle::volumeForce(c.x, c.rest, c.k),
                     inRounding(c.k * volumeScale(c) * c.size() * c.size() * c.distance()));
}

/// Energy and force of one element of the reference simulator.
template <class Element, class Vector>
struct Simulated {
  Case<Vector> at;
  muelle::engine::ElementBatch<3, Element> batch;

  Simulated(const Case<Vector>& c, const Element& element) : at(c), batch({element}) {
    batch.setLayout({3, 1, static_cast<int>(c.x.size())});
  }
  double energy() const { return batch.energy({.x = at.x.data()}); }
  Vector force() const {
    Vector F = Vector::Zero();
    batch.addForce({.x = at.x.data()}, F.data());
    return F;
  }
};

using EngineAngle = muelle::engine::Angle<3>;
using EngineArea = muelle::engine::Area<3>;
using EngineVolume = muelle::engine::Volume;

/// The simulator has the area along a given normal: here that of the triangle.
EngineArea engineArea(const Three& c, double k, double A0) {
  const Vec3 n = c.edge(0, 1).cross(c.edge(0, 2)).normalized();
  EngineArea area{{0, 1, 2}, k, A0, {}};
  area.S << 0, n[2], -n[1], -n[2], 0, n[0], n[1], -n[0], 0;  // u . S w = n . (u x w)
  return area;
}

}  // namespace

// --- bending --------------------------------------------------------------------------------------------------------

TEST(BendingAngle, IsBetweenTheSegments) {
  MUELLE_PROPERTY("the angle is the one between x1 - x0 and x2 - x1: 0 where the line goes straight on");
  Random random = testRandom();
  for (const Three& c : someOf(random, anyBend)) expectAngle(c);
  for (const Vec9& x : alignedNodes()) expectAngle({x, 0, 1});
}

TEST(BendingAngle, IsWhatTheReferenceSimulatorHas) {
  MUELLE_PROPERTY("the angle is that of the bending springs of the reference simulator");
  Random random = testRandom();
  for (int turn = 0; turn < 3; ++turn) {
    const Three c = anyBend(random, turn);
    const Simulated<EngineAngle, Vec9> plain(c, {{0, 1, 2}, 2.0, 0.0});
    EXPECT_NUMBER_NEAR(submission::bendingAngle(c.x), std::sqrt(plain.energy()), inRounding(10 * c.distance()));
    // What is expected elsewhere is what the simulator says.
    const Simulated<EngineAngle, Vec9> spring(c, {{0, 1, 2}, c.k, c.rest});
    ASSERT_LE((spring.force() - oracle::bendingForce(c.x, c.rest, c.k)).norm(), 1e-10 * c.k);
    ASSERT_LE(std::abs(spring.energy() - oracle::bendingEnergy(c.x, c.rest, c.k)), 1e-10 * c.k);
  }
}

TEST(BendingEnergy, GrowsWithTheSquare) {
  MUELLE_PROPERTY("the energy is half of kb times the square of what the angle is above or below theta0");
  Random random = testRandom();
  for (const Three& c : someOf(random, anyBend)) expectBendingEnergy(c);
  for (const Three& c : wholeRange(unequal, {0, 0.037, 1.7, widestRest})) expectBendingEnergy(c);
}

TEST(BendingForce, TurnsTheSegments) {
  MUELLE_PROPERTY("each end is pushed at right angles to its segment, the middle node takes the opposite of both");
  Random random = testRandom();
  for (const Three& c : someOf(random, anyBend)) expectBendingForce(c);
  for (const Vec9& x : alignedNodes()) expectBendingForce({x, 0.73, 37.0});
}

TEST(BendingForce, HoldsForEveryStiffnessAndAngle) {
  MUELLE_PROPERTY("the force is right for any stiffness, any rest angle, 0 too, and any length of the segments");
  for (const Three& c : wholeRange(unequal, {0, 0.037, 1.7, widestRest})) expectBendingForce(c);
}

// --- area -----------------------------------------------------------------------------------------------------------

TEST(TriangleArea, IsHalfOfTheParallelogram) {
  MUELLE_PROPERTY("the area is half of the length of the cross product of two sides");
  Random random = testRandom();
  for (const Three& c : someOf(random, anyTriangle)) expectArea(c);
  for (const Vec9& x : alignedNodes()) expectArea({x, 0, 1});
  for (const Three& c : wholeRange(unequal, {0})) expectArea(c);
}

TEST(TriangleArea, IsWhatTheReferenceSimulatorHas) {
  MUELLE_PROPERTY("the area is that of the area springs of the reference simulator");
  Random random = testRandom();
  for (int turn = 0; turn < 3; ++turn) {
    const Three c = anyTriangle(random, turn);
    const Simulated<EngineArea, Vec9> plain(c, engineArea(c, 2.0, 0.0));
    EXPECT_NUMBER_NEAR(submission::triangleArea(c.x), std::sqrt(plain.energy()), inRounding(10 * areaScale(c)));
    const Simulated<EngineArea, Vec9> spring(c, engineArea(c, c.k, c.rest));
    ASSERT_LE((spring.force() - oracle::areaForce(c.x, c.rest, c.k)).norm(), 1e-10 * c.k);
    ASSERT_LE(std::abs(spring.energy() - oracle::areaEnergy(c.x, c.rest, c.k)), 1e-10 * c.k);
  }
}

TEST(AreaEnergy, GrowsWithTheSquare) {
  MUELLE_PROPERTY("the energy is half of kA times the square of what the area is above or below A0");
  Random random = testRandom();
  for (const Three& c : someOf(random, anyTriangle)) expectAreaEnergy(c);
  for (const Three& c : wholeRange(unequal, {0, 0.43, 1.7, largestRest})) expectAreaEnergy(c);
}

TEST(AreaForce, PullsEachCornerTowardsItsSide) {
  MUELLE_PROPERTY(
      "each corner is pushed at right angles to the opposite side, in proportion to the length of that side");
  Random random = testRandom();
  for (const Three& c : someOf(random, anyTriangle)) expectAreaForce(c);
  for (const Vec9& x : alignedNodes()) expectAreaForce({x, 0.73, 37.0});
}

TEST(AreaForce, HoldsForEveryStiffnessAndArea) {
  MUELLE_PROPERTY("the force is right for any stiffness and any area at rest, 0 too, and triangles of any size");
  for (const Three& c : wholeRange(unequal, {0, 0.43, 1.7, largestRest})) expectAreaForce(c);
}

// --- volume ---------------------------------------------------------------------------------------------------------

TEST(TetrahedronVolume, HasASign) {
  MUELLE_PROPERTY("the volume is a sixth of the triple product of three edges from node 0, with its sign");
  Random random = testRandom();
  for (const Four& c : someOf(random, anyTetrahedron)) expectVolume(c);
  for (const Four& c : wholeRange(uneven, {0})) expectVolume(c);
}

TEST(TetrahedronVolume, IsWhatTheReferenceSimulatorHas) {
  MUELLE_PROPERTY("the volume is that of the volume springs of the reference simulator");
  Random random = testRandom();
  for (int turn = 0; turn < 4; ++turn) {
    const Four c = anyTetrahedron(random, turn);
    // With a rest volume of -1000 m^3 the root has one sign.
    const Simulated<EngineVolume, Vec12> plain(c, {{0, 1, 2, 3}, 2.0, -largestRest});
    EXPECT_NUMBER_NEAR(submission::tetrahedronVolume(c.x), std::sqrt(plain.energy()) - largestRest,
                       inRounding(10 * largestRest));
    const Simulated<EngineVolume, Vec12> spring(c, {{0, 1, 2, 3}, c.k, c.rest});
    ASSERT_LE((spring.force() - oracle::volumeForce(c.x, c.rest, c.k)).norm(), 1e-10 * c.k);
    ASSERT_LE(std::abs(spring.energy() - oracle::volumeEnergy(c.x, c.rest, c.k)), 1e-10 * c.k);
  }
}

TEST(VolumeEnergy, GrowsWithTheSquare) {
  MUELLE_PROPERTY("the energy is half of kV times the square of what the signed volume is above or below V0");
  Random random = testRandom();
  for (const Four& c : someOf(random, anyTetrahedron)) expectVolumeEnergy(c);
  for (const Four& c : wholeRange(uneven, {-largestRest, 0, 0.43, largestRest})) expectVolumeEnergy(c);
}

TEST(VolumeForce, PushesEachNodeAwayFromItsFace) {
  MUELLE_PROPERTY(
      "each node is pushed at right angles to the opposite face, in proportion to its area, by sign of V - V0");
  Random random = testRandom();
  for (const Four& c : someOf(random, anyTetrahedron)) expectVolumeForce(c);
}

TEST(VolumeForce, HoldsForEveryStiffnessAndVolume) {
  MUELLE_PROPERTY("the force is right for any stiffness, any volume at rest, and a tetrahedron that is flat");
  for (const Four& c : wholeRange(uneven, {-largestRest, 0, 0.43, largestRest})) expectVolumeForce(c);
  expectVolumeForce({stacked(Vec3(0, 0, 0), Vec3(1.3, 0, 0), Vec3(0, 0.7, 0), Vec3(0.9, 0.8, 0)), 0.31, 47.0});
}

// --- laws: the student's own energies and forces --------------------------------------------------------------------

namespace {

/// Central differences of an energy in all components. \param step [m]
template <class Vector, class Energy>
Vector slopes(const Case<Vector>& c, const Energy& energy, double step) {
  Vector slope;
  for (Eigen::Index i = 0; i < slope.size(); ++i) {
    Case<Vector> forward = c, backward = c;
    forward.x[i] += step;
    backward.x[i] -= step;
    slope[i] = (energy(forward) - energy(backward)) / (forward.x[i] - backward.x[i]);
  }
  return slope;
}

/// With edges of 0.5 m and areas of 0.3 m^2 at least, third derivatives of angle and area are below 100: the error is
/// h^2 / 6 times that, 2e-7 of the scale, and less for the volume, which is a polynomial.
constexpr double step = 1e-4;

template <class Vector>
Vec3 sumOf(const Vector& F) {
  Vec3 sum = Vec3::Zero();
  for (int i = 0; i < F.size(); i += 3) sum += F.template segment<3>(i);
  return sum;
}

template <class Vector>
Vec3 torqueOf(const Vector& x, const Vector& F) {
  Vec3 torque = Vec3::Zero();
  for (int i = 0; i < F.size(); i += 3) torque += Vec3(x.template segment<3>(i)).cross(Vec3(F.template segment<3>(i)));
  return torque;
}

template <class Any, class Force>
void expectNoNetForce(const char* kind, const Any& any, const Force& force) {
  Random random = testRandom();
  for (int turn = 0; turn < 6; ++turn) {
    const auto c = any(random, turn);
    const auto F = force(c);
    {
      MUELLE_LABEL(fmt::format("sum of the forces of the {} spring on its nodes", kind), "N");
      EXPECT_VECTOR_NEAR(sumOf(F), Vec3(Vec3::Zero()), inStructure(F.norm()));
    }
    MUELLE_LABEL(fmt::format("sum of the torques of the {} spring about the origin", kind), "N m");
    EXPECT_VECTOR_NEAR(torqueOf(c.x, F), Vec3(Vec3::Zero()), inStructure(F.norm() * c.x.norm()));
  }
}

}  // namespace

TEST(MinusTheGradient, OfTheBendingEnergy) {
  MUELLE_PROPERTY("each component of bendingForce is minus the slope of bendingEnergy when that component of x moves");
  MUELLE_EXPECT_ANSWERS(bendingEnergy);
  MUELLE_EXPECT_ANSWERS(bendingForce);
  Random random = testRandom();
  for (int turn = 0; turn < 4; ++turn) {
    const Three c = anyBend(random, turn);
    MUELLE_LABEL("minus the slope of your bendingEnergy, where your bendingForce is expected", "N");
    EXPECT_VECTOR_NEAR(Vec9(-slopes(c, ownBendingEnergy, step)), ownBendingForce(c), inStructure(10 * c.k));
  }
}

TEST(MinusTheGradient, OfTheAreaEnergy) {
  MUELLE_PROPERTY("each component of areaForce is minus the slope of areaEnergy when that component of x moves");
  MUELLE_EXPECT_ANSWERS(areaEnergy);
  MUELLE_EXPECT_ANSWERS(areaForce);
  Random random = testRandom();
  for (int turn = 0; turn < 4; ++turn) {
    const Three c = anyTriangle(random, turn);
    MUELLE_LABEL("minus the slope of your areaEnergy, where your areaForce is expected", "N");
    EXPECT_VECTOR_NEAR(Vec9(-slopes(c, ownAreaEnergy, step)), ownAreaForce(c), inStructure(10 * c.k));
  }
}

TEST(MinusTheGradient, OfTheVolumeEnergy) {
  MUELLE_PROPERTY("each component of volumeForce is minus the slope of volumeEnergy when that component of x moves");
  MUELLE_EXPECT_ANSWERS(volumeEnergy);
  MUELLE_EXPECT_ANSWERS(volumeForce);
  Random random = testRandom();
  for (int turn = 0; turn < 6; ++turn) {
    Four c = anyTetrahedron(random, turn);
    if (turn >= 4) c.rest = -c.rest;  // turned inside out
    MUELLE_LABEL("minus the slope of your volumeEnergy, where your volumeForce is expected", "N");
    EXPECT_VECTOR_NEAR(Vec12(-slopes(c, ownVolumeEnergy, step)), ownVolumeForce(c), inStructure(10 * c.k));
  }
}

TEST(NoNetForce, OfABendingSpring) {
  MUELLE_PROPERTY("moving or turning all three nodes bends nothing: forces and torques of bending add up to zero");
  MUELLE_EXPECT_ANSWERS(bendingForce);
  expectNoNetForce("bending", anyBend, ownBendingForce);
}

TEST(NoNetForce, OfAnAreaSpring) {
  MUELLE_PROPERTY(
      "moving or turning all three nodes changes no area: forces and torques of an area spring add up to zero");
  MUELLE_EXPECT_ANSWERS(areaForce);
  expectNoNetForce("area", anyTriangle, ownAreaForce);
}

TEST(NoNetForce, OfAVolumeSpring) {
  MUELLE_PROPERTY("moving or turning all four nodes changes no volume: forces and torques of it add up to zero");
  MUELLE_EXPECT_ANSWERS(volumeForce);
  expectNoNetForce("volume", anyTetrahedron, ownVolumeForce);
}

// --- edges: partial, one test a function
// ------------------------------------------------------------------------------

namespace {

/// Three nodes on a line that is along no axis, exactly: at these multiples of (0.5, -0.75, 1.5) from a point.
Vec9 onALine(double a, double b, double c) {
  const Vec3 point(0.25, 1.5, -0.75), way(0.5, -0.75, 1.5);
  return stacked(Vec3(point + a * way), Vec3(point + b * way), Vec3(point + c * way));
}

const std::vector<Vec9> straight = {onALine(0, 1, 2), onALine(1, -2, -3)};
const std::vector<Vec9> folded = {onALine(0, 2, 1), onALine(1, -2, 2)};
const std::vector<Vec9> coincident = {onALine(1, 1, 2), onALine(-1, 2, 2), onALine(1, 1, 1)};

/// The last node moved a little across the line.
Three nearby(Three c, double way) {
  c.x.segment<3>(6) += way * Vec3(0.6, 0.8, 0.2);
  return c;
}

/// A line along an axis whose last segment turns off by a small angle, exactly; x1 is at the origin.
/// \param onwards 1: nearly straight, -1: nearly folded back
Three narrow(double small, int axis, double onwards, double rest) {
  const Vec3 along = Vec3::Unit(axis), across = 0.6 * Vec3::Unit((axis + 1) % 3) - 0.8 * Vec3::Unit((axis + 2) % 3);
  return {stacked(Vec3(-0.7 * along), Vec3(Vec3::Zero()), Vec3(onwards * 1.3 * along + small * across)), rest, 57.0};
}

/// Whether answers for one size and a smaller one are the same, but for two hundredths; else they are wrong at any
/// size.
bool isSteady(const VecX& at, const VecX& below) { return at.norm() > 0 && (at - below).norm() < 0.02 * at.norm(); }

/// What `steady` gives at small sizes is expected to be what it gives at a hundredth.
template <class Steady>
void expectSteady(const std::string& what, const std::string& unit, const Steady& steady) {
  const VecX large = steady(0.01);
  if (!isSteady(large, steady(0.003))) return;
  for (const double size : lengthLadder(smallest)) {
    if (size > 0.01) continue;
    MUELLE_LABEL(fmt::format(fmt::runtime(what), size), unit);
    EXPECT_VECTOR_NEAR(steady(size), large, 0.03 * large.norm());  // (0.01 m)^2 and theta / theta0 are left out
  }
}

VecX one(double number) { return VecX::Constant(1, number); }

}  // namespace

TEST(OneLine, HasNoBendingForce) {
  MUELLE_PROPERTY("three nodes on one line, straight or folded, have no bending force, whatever theta0 is; never NaN");
  MUELLE_EXPECT_ANSWERS(bendingForce);
  for (const auto* list : {&straight, &folded, &coincident}) {
    for (const Vec9& x : *list) {
      EXPECT_VECTOR_NEAR(submission::bendingForce(x, 1.3, 57.0), Vec9(Vec9::Zero()), inRounding(57));
    }
  }
}

TEST(OneLine, KeepsItsBendingEnergy) {
  MUELLE_PROPERTY("the energy of bending does not jump where the line is straight or folded back");
  MUELLE_EXPECT_ANSWERS(bendingEnergy);
  for (const auto* list : {&straight, &folded}) {
    for (const Vec9& x : *list) {
      const Three c{x, 1.3, 57.0};
      MUELLE_LABEL("bendingEnergy of nodes on one line, expected about as with one a micrometre beside it", "J");
      const double near = ownBendingEnergy(nearby(c, 1e-6));
      EXPECT_NUMBER_NEAR(ownBendingEnergy(c), near, 1e-3 * std::max(c.k, std::abs(near)));
    }
  }
}

TEST(OneLine, HasNoAngleWithoutLength) {
  MUELLE_PROPERTY("where a segment has no length there is no angle: the energy of bending is zero, never NaN");
  MUELLE_EXPECT_ANSWERS(bendingEnergy);
  for (const Vec9& x : coincident) {
    EXPECT_NUMBER_NEAR(submission::bendingEnergy(x, 1.3, 57.0), 0.0, inRounding(57));
  }
}

TEST(OneLine, HasNoAreaForce) {
  MUELLE_PROPERTY("a triangle without area has no area force, whatever A0 is; never NaN");
  MUELLE_EXPECT_ANSWERS(areaForce);
  for (const auto* list : {&straight, &folded, &coincident}) {
    for (const Vec9& x : *list) {
      EXPECT_VECTOR_NEAR(submission::areaForce(x, 1.3, 57.0), Vec9(Vec9::Zero()), inRounding(57));
    }
  }
}

TEST(OneLine, KeepsItsAreaEnergy) {
  MUELLE_PROPERTY("a triangle without area has the energy of one that is squeezed to nothing");
  MUELLE_EXPECT_ANSWERS(areaEnergy);
  for (const auto* list : {&straight, &folded}) {
    for (const Vec9& x : *list) {
      const Three c{x, 1.3, 57.0};
      MUELLE_LABEL("areaEnergy of nodes on one line, expected about as with one a micrometre beside it", "J");
      const double near = ownAreaEnergy(nearby(c, 1e-6));
      EXPECT_NUMBER_NEAR(ownAreaEnergy(c), near, 1e-3 * std::max(c.k, std::abs(near)));
    }
  }
}

TEST(Narrow, AnglesKeepTheirDigits) {
  MUELLE_PROPERTY("an angle is in proportion to how far the last node is off the line, down to 1e-30 rad");
  MUELLE_EXPECT_ANSWERS(bendingAngle);
  for (int axis = 0; axis < 3; ++axis) {
    expectSteady("angle over the distance of the last node from the line, at {:.2g} m, expected about as at 1 cm",
                 "rad/m",
                 [axis](double small) { return one(submission::bendingAngle(narrow(small, axis, 1, 0).x) / small); });
  }
}

TEST(Narrow, BendsHaveADirection) {
  MUELLE_PROPERTY("a line that is bent by any angle above zero has a plane, and a bending force in it");
  MUELLE_EXPECT_ANSWERS(bendingForce);
  for (int axis = 0; axis < 3; ++axis) {
    for (const double onwards : {1.0, -1.0}) {
      const std::string how = onwards > 0 ? "straight" : "folded back";
      expectSteady("bendingForce of a line nearly " + how + ", off by {:.2g} m, expected about as with 1 cm", "N",
                   [&](double small) { return VecX(ownBendingForce(narrow(small, axis, onwards, 1.3))); });
    }
  }
}

TEST(Narrow, BendsHaveNoSize) {
  MUELLE_PROPERTY("a bent line of any size, down to 1e-30 m, has its angle, and a force over that size");
  MUELLE_EXPECT_ANSWERS(bendingForce);
  expectSteady("bendingForce times the size, at {:.2g} m, expected about as at 1 cm", "N m",
               [](double size) { return VecX(size * submission::bendingForce(Vec9(size * unequal), 0.7, 57.0)); });
}

TEST(Narrow, AreasKeepTheirDigits) {
  MUELLE_PROPERTY("the area of a triangle is in proportion to its height, down to 1e-30 m");
  MUELLE_EXPECT_ANSWERS(triangleArea);
  for (int axis = 0; axis < 3; ++axis) {
    expectSteady("area over the height of a triangle that is {:.2g} m high, expected about as with 1 cm", "m",
                 [axis](double small) { return one(submission::triangleArea(narrow(small, axis, 1, 0).x) / small); });
  }
}

TEST(Narrow, TrianglesHaveADirection) {
  MUELLE_PROPERTY("a triangle that has any area has a plane, and an area force in it");
  MUELLE_EXPECT_ANSWERS(areaForce);
  for (int axis = 0; axis < 3; ++axis) {
    expectSteady("areaForce of a triangle that is {:.2g} m high, expected about as with 1 cm", "N",
                 [axis](double small) { return VecX(ownAreaForce(narrow(small, axis, 1, largestRest))); });
  }
  expectSteady("areaForce over the size, at {:.2g} m, expected about as at 1 cm", "N/m",
               [](double size) { return VecX(submission::areaForce(Vec9(size * unequal), largestRest, 57.0) / size); });
}
