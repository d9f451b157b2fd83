#include "triangle.h"

#include "course/testing/expect.h"
#include "course/testing/random.h"
#include "harness/function_system.h"
#include "harness/march.h"
#include "harness/symplectic_euler.h"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

using muelle::FunctionSystem;
using muelle::In;
using muelle::Out;
using muelle::Random;
using muelle::roundOff;
using muelle::State;
using muelle::testRandom;
using muelle::Trajectory;
using muelle::VecX;

namespace {

constexpr int first(int spring) { return spring; }
constexpr int second(int spring) { return (spring + 1) % 3; }

/// A triangle somewhere in space.
struct Case {
  Vec9 x;
  Vec3 k;
  Vec3 L0;

  Vec3 node(int i) const { return x.segment<3>(3 * i); }
  double length(int spring) const { return (node(first(spring)) - node(second(spring))).norm(); }
  /// The largest length there is: 0.3 to 8 m.
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
  for (int i = 0; i < 3; ++i) there.segment<3>(3 * i) = rotation * x.segment<3>(3 * i) + shift;
  return there;
}

Vec9 randomDisplacement(Random& random, double scale) {
  return stacked(random.vector3(scale), random.vector3(scale), random.vector3(scale));
}

Vec3 stiffnesses(Random& random) {
  return {random.positive(20.0, 400.0), random.positive(20.0, 400.0), random.positive(20.0, 400.0)};
}

/// Three nodes no two of which are near each other: the corners (0,0), (2,0), (1,1.6), each moved by less than 0.35 m
/// (so no side is below 1.1 m), then the whole turned and moved.
Vec9 anyNodes(Random& random) {
  const Vec9 plain = stacked(Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(1, 1.6, 0)) + randomDisplacement(random, 0.2);
  return moved(plain, random.rotation(), random.vector3(2.0));
}

/// Every spring is stretched or compressed by a tenth at least, each by a factor of its own.
Case anyTriangle(Random& random) {
  Case triangle{anyNodes(random), stiffnesses(random), Vec3::Zero()};
  for (int s = 0; s < 3; ++s) {
    const double ratio = random.number(1.1, 2.5);
    triangle.L0[s] = random.integer(0, 1) == 0 ? triangle.length(s) * ratio : triangle.length(s) / ratio;
  }
  return triangle;
}

/// All springs at rest but one.
Case oneSpringStrained(Random& random, int strained) {
  Case triangle{anyNodes(random), stiffnesses(random), Vec3::Zero()};
  for (int s = 0; s < 3; ++s) triangle.L0[s] = triangle.length(s);
  triangle.L0[strained] *= random.number(0.4, 0.8);
  return triangle;
}

/// The nodes of one spring coincide; rest lengths as they come.
Case oneSpringCollapsed(Random& random, int collapsed) {
  Case triangle = anyTriangle(random);
  triangle.x.segment<3>(3 * second(collapsed)) = triangle.node(first(collapsed));
  triangle.L0[collapsed] = random.number(0.3, 3.0);
  return triangle;
}

/// The nodes of one spring are as good as at one point, and are not. The first is the origin, so that the second keeps
/// all its digits.
Case oneSpringTiny(Random& random, int tiny) {
  Case triangle = anyTriangle(random);
  triangle.x.segment<3>(3 * first(tiny)).setZero();
  triangle.x.segment<3>(3 * second(tiny)) = random.positive(1e-20, 1e-16) * random.direction();
  triangle.x.segment<3>(3 * ((tiny + 2) % 3)) = random.number(0.8, 3.0) * random.direction();
  triangle.L0[tiny] = random.number(0.3, 3.0);
  return triangle;
}

double submittedEnergy(const Case& c) { return submission::triangleEnergy(c.x, c.k, c.L0); }
double expectedEnergy(const Case& c) { return oracle::triangleEnergy(c.x, c.k, c.L0); }
Vec9 submittedForce(const Case& c) { return submission::triangleForce(c.x, c.k, c.L0); }
Vec9 expectedForce(const Case& c) { return oracle::triangleForce(c.x, c.k, c.L0); }

}  // namespace

// --- MassMatrix -----------------------------------------------------------------------------------------------------

namespace {

Vec3 masses(Random& random) {
  return {random.positive(0.1, 10.0), random.positive(0.1, 10.0), random.positive(0.1, 10.0)};
}

}  // namespace

TEST(MassMatrix, HasTheMassesOnItsDiagonal) {
  MUELLE_PROPERTY("the mass of a node stands on the diagonal once for each of its components, and all else is zero");
  Random random = testRandom();
  for (int i = 0; i < 5; ++i) {
    const Vec3 m = masses(random);
    EXPECT_MATRIX_NEAR(submission::massMatrix(m), oracle::massMatrix(m), roundOff(10));
  }
}

TEST(MassMatrix, GivesTheKineticEnergy) {
  MUELLE_PROPERTY("v . M v / 2 is the sum of the kinetic energies of the nodes");
  Random random = testRandom();
  for (int i = 0; i < 3; ++i) {
    const Vec3 m = masses(random);
    const Vec9 v = randomDisplacement(random, 3.0);
    double expected = 0.0;
    for (int node = 0; node < 3; ++node) expected += 0.5 * m[node] * v.segment<3>(3 * node).squaredNorm();
    EXPECT_NUMBER_NEAR(0.5 * v.dot(submission::massMatrix(m) * v), expected, roundOff(expected));
  }
}

// --- TriangleEnergy -------------------------------------------------------------------------------------------------

TEST(TriangleEnergy, IsTheSumOverTheSprings) {
  MUELLE_PROPERTY("the energy is the sum of the energies of the springs 01, 12 and 20, each with its own k and L0");
  Random random = testRandom();
  for (int i = 0; i < 8; ++i) {
    const Case c = anyTriangle(random);
    EXPECT_NUMBER_NEAR(submittedEnergy(c), expectedEnergy(c), roundOff(c.energyScale()));
  }
}

TEST(TriangleEnergy, OfOneStrainedSpringIsThatOfTheSpring) {
  MUELLE_PROPERTY("with two springs at rest the energy is that of the third, for each of the three");
  Random random = testRandom();
  for (int s = 0; s < 3; ++s) {
    const Case c = oneSpringStrained(random, s);
    const double stretch = c.length(s) - c.L0[s];
    EXPECT_NUMBER_NEAR(submittedEnergy(c), 0.5 * c.k[s] * stretch * stretch, roundOff(c.energyScale()));
  }
}

TEST(TriangleEnergy, IsZeroAtRest) {
  MUELLE_PROPERTY("the energy is zero where all springs are at rest, and only there");
  Random random = testRandom();
  Case c{stacked(Vec3(0, 0, 0), Vec3(3, 0, 0), Vec3(0, 0, 4)), stiffnesses(random), Vec3(3, 5, 4)};
  EXPECT_NUMBER_NEAR(submittedEnergy(c), 0.0, roundOff(c.energyScale()));
  for (int s = 0; s < 3; ++s) {
    Case strained = c;
    strained.L0[s] += 0.5;
    EXPECT_NUMBER_NEAR(submittedEnergy(strained), 0.125 * c.k[s], roundOff(c.energyScale()));
  }
}

// --- TriangleForce --------------------------------------------------------------------------------------------------

TEST(TriangleForce, AddsTheForcesOfTheSprings) {
  MUELLE_PROPERTY("the force on each node is the sum of the forces of its two springs, each with its own k and L0");
  Random random = testRandom();
  for (int i = 0; i < 8; ++i) {
    const Case c = anyTriangle(random);
    EXPECT_VECTOR_NEAR(submittedForce(c), expectedForce(c), roundOff(c.forceScale()));
  }
}

TEST(TriangleForce, OfOneStrainedSpringActsOnItsTwoNodes) {
  MUELLE_PROPERTY(
      "with two springs at rest the third pulls its own two nodes together and leaves the other node alone");
  Random random = testRandom();
  for (int s = 0; s < 3; ++s) {
    const Case c = oneSpringStrained(random, s);
    const Vec3 towardsSecond = (c.node(second(s)) - c.node(first(s))).normalized();
    const double tension = c.k[s] * (c.length(s) - c.L0[s]);
    Vec9 expected = Vec9::Zero();
    expected.segment<3>(3 * first(s)) = tension * towardsSecond;
    expected.segment<3>(3 * second(s)) = -tension * towardsSecond;
    EXPECT_VECTOR_NEAR(submittedForce(c), expected, roundOff(c.forceScale()));
  }
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
  Random random = testRandom();
  for (int i = 0; i < 4; ++i) {
    const Case c = anyTriangle(random);
    const double h = 1e-4;
    // E''' = -k L0 L''' for each of two springs, with |L'''| <= 1.16 / L^2 (see 3 u (1 - u^2)) and L >= 1.1 m; the
    // energies carry a few roundings, some 1e-15 of their scale, and those of the positions (a few metres), which enter
    // through the force.
    const double truncation = 2 * h * h * c.k.maxCoeff() * c.L0.maxCoeff() / (5 * 1.1 * 1.1);
    const double rounding = 1e-15 * (c.energyScale() + c.forceScale() * 10) / h;
    const Vec9 force = submittedForce(c);
    EXPECT_VECTOR_NEAR(force, expectedForce(c), roundOff(c.forceScale()));
    EXPECT_VECTOR_NEAR(slopes(c, h), -force, truncation + rounding);
  }
}

TEST(MinusTheGradient, IsApproachedWithOrderTwo) {
  MUELLE_PROPERTY(
      "halving the step of the central difference of triangleEnergy divides its distance to minus triangleForce by "
      "four");
  Random random = testRandom();
  for (int i = 0; i < 2; ++i) {
    const Case c = anyTriangle(random);
    const Vec9 force = submittedForce(c);
    EXPECT_VECTOR_NEAR(force, expectedForce(c), roundOff(c.forceScale()));
    const double h = 0.005;
    const double coarse = (slopes(c, h) + force).norm();
    const double fine = (slopes(c, h / 2) + force).norm();
    // The next term of the error is of relative size 2 (h / L)^2 < 1e-4 a spring, which moves the order by 1e-4; where
    // the leading terms of two springs cancel in part the share grows, but they would have to cancel to 1 %. Rounding,
    // 1e-15 E / h, is a millionth of the error.
    EXPECT_NUMBER_NEAR(std::log2(coarse / fine), 2.0, 0.01);
  }
}

TEST(MinusTheGradient, DoesNoWorkOverACycle) {
  MUELLE_PROPERTY("over any closed path of the three nodes the work of triangleForce is zero");
  Random random = testRandom();
  const Case c = anyTriangle(random);
  const Vec9 u = randomDisplacement(random, 0.1);
  const Vec9 w = randomDisplacement(random, 0.1);
  // The integrand is smooth and periodic: two nodes approach each other by 0.7 m at most of 1.1 m, and the sum over
  // equal steps with the exact tangent converges geometrically. 128 points leave round-off.
  constexpr int n = 128;
  double total = 0.0;
  for (int step = 0; step < n; ++step) {
    const double angle = 2 * M_PI * step / n;
    Case there = c;
    there.x += std::cos(angle) * u + std::sin(angle) * w;
    const Vec9 tangent = -std::sin(angle) * u + std::cos(angle) * w;
    const Vec9 force = submittedForce(there);
    EXPECT_VECTOR_NEAR(force, expectedForce(there), roundOff(2 * c.forceScale()));
    total += force.dot(tangent) * 2 * M_PI / n;
  }
  EXPECT_NUMBER_NEAR(total, 0.0, roundOff(c.energyScale()));
}

// --- NewtonsThirdLaw ------------------------------------------------------------------------------------------------

TEST(NewtonsThirdLaw, LeavesNoNetForce) {
  MUELLE_PROPERTY("the forces on the three nodes add up to zero");
  Random random = testRandom();
  for (int i = 0; i < 6; ++i) {
    const Case c = anyTriangle(random);
    const Vec9 F = submittedForce(c);
    EXPECT_VECTOR_NEAR(F, expectedForce(c), roundOff(c.forceScale()));
    EXPECT_VECTOR_NEAR(Vec3(F.segment<3>(0) + F.segment<3>(3) + F.segment<3>(6)), Vec3(Vec3::Zero()),
                       roundOff(3 * c.forceScale()));
  }
}

TEST(NewtonsThirdLaw, LeavesNoNetTorque) {
  MUELLE_PROPERTY("the torques of the three forces about any point add up to zero");
  Random random = testRandom();
  for (int i = 0; i < 6; ++i) {
    const Case c = anyTriangle(random);
    const Vec9 F = submittedForce(c);
    EXPECT_VECTOR_NEAR(F, expectedForce(c), roundOff(c.forceScale()));
    Vec3 torque = Vec3::Zero();
    for (int node = 0; node < 3; ++node) torque += c.node(node).cross(Vec3(F.segment<3>(3 * node)));
    EXPECT_VECTOR_NEAR(torque, Vec3(Vec3::Zero()), roundOff(3 * c.forceScale() * 10));
  }
}

// --- Equivariance ---------------------------------------------------------------------------------------------------

TEST(Equivariance, ATurnedTriangleHasTurnedForces) {
  MUELLE_PROPERTY("moving the triangle changes neither energy nor forces; turning it turns the forces with it");
  Random random = testRandom();
  for (int i = 0; i < 5; ++i) {
    const Case c = anyTriangle(random);
    const Mat3 rotation = random.rotation();
    Case there = c;
    there.x = moved(c.x, rotation, random.vector3(3.0));
    EXPECT_VECTOR_NEAR(submittedForce(there), moved(expectedForce(c), rotation, Vec3::Zero()),
                       roundOff(c.forceScale()));
    EXPECT_NUMBER_NEAR(submittedEnergy(there), expectedEnergy(c), roundOff(c.energyScale()));
  }
}

TEST(Equivariance, ARenumberedTriangleHasRenumberedForces) {
  MUELLE_PROPERTY(
      "numbering the nodes, and with them the springs, from another corner or the other way round renumbers the "
      "forces");
  Random random = testRandom();
  for (int i = 0; i < 5; ++i) {
    const Case c = anyTriangle(random);
    const double E = expectedEnergy(c);
    const Vec9 F = expectedForce(c);

    // From corner 1: nodes 1, 2, 0 and springs 12, 20, 01.
    const Case round{stacked(c.node(1), c.node(2), c.node(0)), {c.k[1], c.k[2], c.k[0]}, {c.L0[1], c.L0[2], c.L0[0]}};
    EXPECT_VECTOR_NEAR(submittedForce(round), stacked(F.segment<3>(3), F.segment<3>(6), F.segment<3>(0)),
                       roundOff(c.forceScale()));
    EXPECT_NUMBER_NEAR(submittedEnergy(round), E, roundOff(c.energyScale()));

    // The other way round: nodes 0, 2, 1 and springs 02, 21, 10.
    const Case back{stacked(c.node(0), c.node(2), c.node(1)), {c.k[2], c.k[1], c.k[0]}, {c.L0[2], c.L0[1], c.L0[0]}};
    EXPECT_VECTOR_NEAR(submittedForce(back), stacked(F.segment<3>(0), F.segment<3>(6), F.segment<3>(3)),
                       roundOff(c.forceScale()));
    EXPECT_NUMBER_NEAR(submittedEnergy(back), E, roundOff(c.energyScale()));
  }
}

// --- CoincidentNodes: partial, so every test stands on generic values of its own -----------------------------------

TEST(CoincidentNodes, KeepTheEnergyOfFullCompression) {
  MUELLE_PROPERTY("a spring whose nodes coincide keeps the energy of being compressed by all of its rest length");
  Random random = testRandom();
  for (int i = 0; i < 6; ++i) {
    const Case c = oneSpringCollapsed(random, i % 3);
    EXPECT_NUMBER_NEAR(submittedEnergy(c), expectedEnergy(c), roundOff(c.energyScale()));
  }
}

TEST(CoincidentNodes, FeelTheOtherSpringsAlone) {
  MUELLE_PROPERTY("a spring whose nodes coincide contributes no force, and the two others act as usual");
  Random random = testRandom();
  for (int i = 0; i < 6; ++i) {
    const Case c = oneSpringCollapsed(random, i % 3);
    EXPECT_VECTOR_NEAR(submittedForce(c), expectedForce(c), roundOff(c.forceScale()));
  }
  const Vec3 point = random.vector3(2.0);
  const Case all{stacked(point, point, point), stiffnesses(random), Vec3(1, 2, 3)};
  EXPECT_VECTOR_NEAR(submittedForce(all), Vec9(Vec9::Zero()), 0.0);
  for (int i = 0; i < 3; ++i) {  // and without coincident nodes the force is as it should be
    const Case c = anyTriangle(random);
    EXPECT_VECTOR_NEAR(submittedForce(c), expectedForce(c), roundOff(c.forceScale()));
  }
}

// --- TinyLengths ----------------------------------------------------------------------------------------------------

TEST(TinyLengths, HaveADirection) {
  MUELLE_PROPERTY("a spring of any length above zero has a direction, and so a force");
  Random random = testRandom();
  for (int i = 0; i < 9; ++i) {
    const Case c = oneSpringTiny(random, i % 3);
    EXPECT_VECTOR_NEAR(submittedForce(c), expectedForce(c), roundOff(c.forceScale()));
  }
}

// --- FreeFlight -----------------------------------------------------------------------------------------------------

namespace {

using Forces = std::function<Vec9(const Vec9&)>;

/// A triangle thrown into empty space, turning and swinging.
struct Flight {
  Vec9 start;
  Vec9 velocity;
  Vec3 m{0.5, 0.8, 0.6};
  Vec3 k{60, 45, 80};
  Vec3 L0{1.0, 1.1, 0.9};
  double h = 2e-3;        // [s]
  double duration = 1.0;  // [s], some three swings

  /// No side is far from 1 m at the start, and the motion is gentle enough that none shrinks below half of it.
  explicit Flight(Random& random) {
    const Mat3 rotation = random.rotation();
    const Vec9 plain = stacked(Vec3(-0.55, -0.3, 0), Vec3(0.6, -0.35, 0), Vec3(0.05, 0.65, 0));
    start = moved(plain, rotation, random.vector3(0.5));
    const Vec9 thrown = stacked(Vec3(0.9, -0.8, 0.3), Vec3(0.6, 0.9, -0.2), Vec3(-0.8, 0.2, 0.4));
    velocity = moved(thrown, rotation, random.vector3(0.2));
  }

  Trajectory fly(const Forces& forces, const Vec9& aside) const {
    std::vector<double> mass;
    for (int c = 0; c < 9; ++c) mass.push_back(m[c / 3]);
    const FunctionSystem system(mass, [&](double, In x, In, Out f) {
      const Vec9 F = forces(Eigen::Map<const Vec9>(x.data()));
      std::copy(F.begin(), F.end(), f.begin());
    });
    State state;
    const Vec9 from = start + aside;
    state.x.assign(from.begin(), from.end());
    state.v.assign(velocity.begin(), velocity.end());
    muelle::MarchOptions options;
    options.h = h;
    options.duration = duration;
    return muelle::march(system, state, options);
  }

  Trajectory submitted() const {
    return fly([this](const Vec9& x) { return submission::triangleForce(x, k, L0); }, Vec9::Zero());
  }
  Trajectory expected(const Vec9& aside = Vec9::Zero()) const {
    return fly([this](const Vec9& x) { return oracle::triangleForce(x, k, L0); }, aside);
  }

  /// How far a run drifts that starts 1e-9 m aside: more than round-off in the forces can do.
  double drift(const Trajectory& reference, Random& random) const {
    const Trajectory aside = expected(1e-9 * stacked(random.direction(), random.direction(), random.direction()));
    double largest = 1e-9;
    for (std::size_t i = 0; i < reference.t.size(); ++i) {
      const Vec9 x = Eigen::Map<const Vec9>(aside.x[i].data());
      largest = std::max(largest, (x - Eigen::Map<const Vec9>(reference.x[i].data())).norm());
    }
    return largest;
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

Vec9 positions(const Trajectory& run, std::size_t i) { return Eigen::Map<const Vec9>(run.x[i].data()); }
Vec9 velocities(const Trajectory& run, std::size_t i) { return Eigen::Map<const Vec9>(run.v[i].data()); }

}  // namespace

TEST(FreeFlight, FollowsTheReference) {
  MUELLE_PROPERTY("a triangle thrown into empty space flies, turns and swings as the reference does");
  Random random = testRandom();
  const Flight flight(random);
  const Trajectory run = flight.submitted();
  ASSERT_FALSE(run.stop.stopped) << run.stop.message;
  const Trajectory reference = flight.expected();
  const double tolerance = flight.drift(reference, random);
  for (std::size_t i = 0; i < reference.t.size(); i += 10) {
    ASSERT_VECTOR_NEAR(positions(run, i), positions(reference, i), tolerance);
  }
}

TEST(FreeFlight, KeepsItsEnergy) {
  MUELLE_PROPERTY("elastic plus kinetic energy of a free triangle is kept, but for the small ripple of the method");
  Random random = testRandom();
  const Flight flight(random);
  const Trajectory run = flight.submitted();
  ASSERT_FALSE(run.stop.stopped) << run.stop.message;
  const Trajectory reference = flight.expected();
  const double drift = flight.drift(reference, random);
  // Symplectic Euler keeps E - (h / 2) F . v + O(h^2) (Hairer, Lubich, Wanner, IX.3): the energy departs from its first
  // value by h times the largest power at most; half as much again for the terms in h^2.
  double power = 0.0;
  for (std::size_t i = 0; i < reference.t.size(); ++i) {
    const Vec9 F = oracle::triangleForce(positions(reference, i), flight.k, flight.L0);
    power = std::max(power, std::abs(F.dot(velocities(reference, i))));
  }
  double start = 0.0;
  for (std::size_t i = 0; i < reference.t.size(); i += 10) {
    const double elastic = submission::triangleEnergy(positions(run, i), flight.k, flight.L0);
    // The slope of the energy is at most the force: three springs of up to 80 N/m, strained by less than 1 m.
    const double tolerance = 2 * 3 * 80 * drift;
    ASSERT_NUMBER_NEAR(elastic, oracle::triangleEnergy(positions(reference, i), flight.k, flight.L0), tolerance);
    const double total = elastic + flight.kinetic(velocities(run, i));
    if (i == 0) start = total;
    ASSERT_NUMBER_NEAR(total, start, 1.5 * flight.h * power);
  }
}

TEST(FreeFlight, KeepsBothMomenta) {
  MUELLE_PROPERTY("linear and angular momentum of a free triangle are kept");
  Random random = testRandom();
  const Flight flight(random);
  const Trajectory run = flight.submitted();
  ASSERT_FALSE(run.stop.stopped) << run.stop.message;
  const Trajectory reference = flight.expected();
  ASSERT_VECTOR_NEAR(positions(run, run.t.size() - 1), positions(reference, reference.t.size() - 1),
                     flight.drift(reference, random));
  const Vec3 p = flight.momentum(flight.velocity);
  const Vec3 L = flight.angularMomentum(flight.start, flight.velocity);
  // Symplectic Euler keeps both exactly for any forces without net force and torque; 500 steps of round-off remain.
  for (std::size_t i = 0; i < run.t.size(); i += 10) {
    ASSERT_VECTOR_NEAR(flight.momentum(velocities(run, i)), p, roundOff(1));
    ASSERT_VECTOR_NEAR(flight.angularMomentum(positions(run, i), velocities(run, i)), L, roundOff(1));
  }
}
