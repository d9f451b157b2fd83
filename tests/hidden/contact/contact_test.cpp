#include "contact.h"

#include "course/testing/expect.h"
#include "course/testing/random.h"
#include "grader/testing/ladders.h"
#include "grader/testing/motion.h"
#include "grader/testing/of_use.h"
#include "grader/testing/plain_numbers.h"
#include "grader/testing/power_law.h"
#include "harness/function_system.h"
#include "harness/march.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <cmath>
#include <functional>
#include <numbers>

// The laws behind the bounces, the columns and the incline: tests/hard_cases, H17 (bounce_on_penalty_plane), H18
// (rest_and_stack), H20 (friction_incline_threshold).

namespace {

using muelle::In;
using muelle::Mat3;
using muelle::Node;
using muelle::node3;
using muelle::Out;
using muelle::Random;
using muelle::testRandom;
using muelle::threeDigits;
using muelle::Trajectory;
using muelle::VecX;
using muelle::grader::exactLengthLadder;
using muelle::grader::expectSameMotion;
using muelle::grader::lengthLadder;
using muelle::grader::someTurn;

constexpr double gravity = 9.81;  // [m/s^2]

/// Fifty times the round-off (1.1e-16 each) of the dozen operations that a force takes, relative to the numbers that
/// go into it: far above every sensible order of summation, far below single precision.
constexpr double rounding = 1e-13;

/// Laws are about the structure of the forces and not about their digits: single precision keeps them.
constexpr double structure = 1e-6;

/// A range from which a random number is drawn.
struct Range {
  double low, high;
};

// Leaving speeds in units of k |depth| / d, the speed at which damper and spring are equally strong.
constexpr Range entering{-1.5, -0.2};
constexpr Range leavingSlowly{0.2, 0.8};
constexpr Range leavingQuickly{1.2, 3.0};
constexpr Range enteringQuickly{-3.0, -1.2};

/// A node at a plane.
struct AtPlane {
  Vec3 x, v, p, n;
  double k = 0.0, d = 0.0;

  Vec3 normal() const { return n; }
};

/// A node at a sphere.
struct AtSphere {
  Vec3 x, v, c;
  double R = 0.0, k = 0.0, d = 0.0;

  Vec3 normal() const { return (x - c).stableNormalized(); }
};

Vec3 across(const Vec3& n, Random& random, double scale) { return n.cross(random.vector3(scale)); }

/// A random velocity that leaves at some multiple of the speed at which damper and spring are equally strong.
Vec3 leavingVelocity(Random& random, const Vec3& n, double depth, double k, double d, Range leaving) {
  const double unit = d > 0.0 ? k * std::abs(depth) / d : 1.7;
  const double speed = random.number(leaving.low, leaving.high) * unit;
  return threeDigits(Vec3(speed * n + across(n, random, 3.0 * std::min(1.0, unit))));
}

/// A node at about the given depth (negative: outside) somewhere along a random plane.
AtPlane atPlane(Random& random, double depth, Range leaving) {
  AtPlane at;
  at.n = random.roundedDirection();
  at.p = threeDigits(random.vector3(3.0));
  at.k = random.rounded(200.0, 2000.0);
  at.d = random.rounded(3.0, 10.0);
  at.x = threeDigits(Vec3(at.p - depth * at.n + across(at.n, random, 2.0)));
  at.v = leavingVelocity(random, at.n, depth, at.k, at.d, leaving);
  return at;
}

/// The same at a random sphere.
AtSphere atSphere(Random& random, double depth, Range leaving) {
  AtSphere at;
  const Vec3 n = random.roundedDirection();
  at.c = threeDigits(random.vector3(3.0));
  at.R = random.rounded(1.6, 3.0);
  at.k = random.rounded(200.0, 2000.0);
  at.d = random.rounded(3.0, 10.0);
  at.x = threeDigits(Vec3(at.c + (at.R - depth) * n));
  at.v = leavingVelocity(random, n, depth, at.k, at.d, leaving);
  return at;
}

/// A node inside a sphere of radius R about the origin, to 0.3 R.
AtSphere atSphereOfRadius(Random& random, double R, double k, double d) {
  AtSphere at;
  const Vec3 n = random.roundedDirection();
  at.c.setZero();
  at.R = R;
  at.k = k;
  at.d = d;
  at.x = threeDigits(Vec3(0.7 * R * n));
  at.v = leavingVelocity(random, n, 0.3 * R, k, d, entering);
  return at;
}

/// A node at a horizontal plane, which is z = p.z: its depth is a difference of heights in whatever order it is summed
/// up, so that it may be as small as it likes.
AtPlane atFloor(Random& random, double p) {
  AtPlane at = atPlane(random, 0.1, entering);
  at.n = Vec3::UnitZ();
  at.p.z() = p;
  at.x.z() = p;
  at.v.z() = -random.rounded(3.0, 9.0);
  return at;
}

/// A node on the surface of a sphere, beside, before or behind the centre, on its way in. The distance is exact by
/// every formula.
AtSphere onSphere(Random& random, int side) {
  AtSphere at = atSphere(random, 0.1, entering);
  const int axis = side % 2;
  const double sign = side < 2 ? 1.0 : -1.0;
  at.R = 2.0;
  at.c[axis] = sign;
  at.x = at.c;
  at.x[axis] = 3.0 * sign;
  at.v[axis] = -sign * random.rounded(3.0, 9.0);
  return at;
}

double randomDepth(Random& random) { return random.number(0.06, 0.3); }

Vec3 submitted(const AtPlane& at) { return submission::planeContact(at.x, at.v, at.p, at.n, at.k, at.d); }
Vec3 expected(const AtPlane& at) { return oracle::planeContact(at.x, at.v, at.p, at.n, at.k, at.d); }
Vec3 submitted(const AtSphere& at) { return submission::sphereContact(at.x, at.v, at.c, at.R, at.k, at.d); }
Vec3 expected(const AtSphere& at) { return oracle::sphereContact(at.x, at.v, at.c, at.R, at.k, at.d); }

/// The numbers that a force is a difference of.
double forceScale(const AtPlane& at) { return at.k * (at.x.norm() + at.p.norm()) + at.d * at.v.norm(); }

/// The normal, too, is off by the round-off of x - c over its length.
double forceScale(const AtSphere& at) {
  const double ofNormal = 1.0 + (at.x.norm() + at.c.norm()) / (at.x - at.c).norm();
  return (at.k * at.R + at.d * at.v.norm()) * ofNormal;
}

template <class At>
void expectForce(const At& at) {
  MUELLE_LABEL("force on the node", "N");
  EXPECT_VECTOR_NEAR(submitted(at), expected(at), rounding * forceScale(at));
}

template <class At>
void expectNoForce(const At& at) {
  MUELLE_LABEL("force on the node", "N");
  EXPECT_VECTOR_NEAR(submitted(at), Vec3::Zero(), 0.0);
}

/// What is asked of a node that leaves or comes so quickly that damper or spring alone would pull: no more than the
/// force's own law at rest and at a low speed says, so that a wrong stiffness or damping costs nothing here.
template <class At>
void expectNeverPulls(At at, double depth) {
  const Vec3 n = at.normal();
  const Vec3 along = threeDigits(Vec3(n.cross(at.v)));
  const double unit = at.k * depth / at.d;
  at.v.setZero();
  const Vec3 atRest = submitted(at);
  const double size = atRest.norm();
  if (!(size > 0.0) || !std::isfinite(size)) return;  // a wrong value, which the values' criterion tells
  const auto pushAt = [&](double speed) {
    at.v = speed * n + along;
    return submitted(at).dot(atRest) / size;
  };
  const double lostPerSpeed = (size - pushAt(0.5 * unit)) / (0.5 * unit);
  for (const double factor : {1.3, 2.9, 31.0, -1.3, -31.0}) {
    const double speed = factor * unit, push = pushAt(speed);
    MUELLE_LABEL(fmt::format("push of a node that {} at {:.3g} m/s, along the push at rest",
                             factor > 0.0 ? "leaves" : "comes in", std::abs(speed)),
                 "N");
    const bool mustBeZero = size - lostPerSpeed * speed < -0.1 * size;
    const bool pulls = !(push >= -structure * size);
    EXPECT_NUMBER_NEAR(mustBeZero || pulls ? push : 0.0, 0.0, structure * size);
  }
}

/// Nodes at rest at distances or depths down to the smallest.
/// \param place moves the node to a length
template <class At, class Place>
void expectOneLaw(At at, const std::vector<double>& lengths, const Place& place, const char* what, double bend) {
  at.v.setZero();
  const auto force = [&](double length) {
    place(at, length);
    return submitted(at);
  };
  muelle::grader::expectPowerLaw(lengths, force, what, bend);
}

// ---- Motion of one node ----------------------------------------------------------------------------------------

using NodeForce = std::function<Vec3(const Vec3& x, const Vec3& v)>;

Trajectory run(const Node& node, const NodeForce& force, double h, double duration) {
  const muelle::FunctionSystem system(
      muelle::massesOf({node}), [&](double, In x, In v, Out f) { node3(f, 0) = force(node3(x, 0), node3(v, 0)); });
  muelle::MarchOptions options;
  options.h = h;
  options.duration = duration;
  return muelle::march(system, muelle::stateOf({node}), options);
}

Vec3 positionAt(const Trajectory& trajectory, std::size_t i) { return node3(In(trajectory.x[i]), 0); }
Vec3 velocityAt(const Trajectory& trajectory, std::size_t i) { return node3(In(trajectory.v[i]), 0); }
Vec3 lastPosition(const Trajectory& trajectory) { return positionAt(trajectory, trajectory.x.size() - 1); }
Vec3 lastVelocity(const Trajectory& trajectory) { return velocityAt(trajectory, trajectory.v.size() - 1); }

/// Runs with the student's force and with the reference's; both take the same steps. What motions are asked about are
/// forces that are plainly wrong: 1e-6 of the motion's size lets single precision pass (1e-7 of the force in a contact
/// of omega t < 300).
Trajectory compareMotions(const Node& node, const NodeForce& student, const NodeForce& reference, double h,
                          double duration, double size) {
  const Trajectory trajectory = run(node, student, h, duration);
  expectSameMotion(trajectory, run(node, reference, h, duration), structure * size);
  return trajectory;
}

/// A plane of some tilt, away from the origin.
struct Slab {
  Vec3 p{0.5, -1.0, 2.0};
  Vec3 n = Vec3(2, -1, 2) / 3.0;
  double k = 1e5;
  double d = 0.0;

  NodeForce student() const {
    return [*this](const Vec3& x, const Vec3& v) { return submission::planeContact(x, v, p, n, k, d); };
  }
  NodeForce reference() const {
    return [*this](const Vec3& x, const Vec3& v) { return oracle::planeContact(x, v, p, n, k, d); };
  }
};

// ---- A column on the plane -------------------------------------------------------------------------------------

struct Column {
  std::vector<double> m;
  double k = 0.0, L0 = 0.0, kPlane = 0.0, g = gravity;
};

Column randomColumn(Random& random, int nodes) {
  Column column;
  for (int i = 0; i < nodes; ++i) column.m.push_back(random.rounded(0.1, 0.49));
  column.k = random.rounded(110.0, 300.0);
  column.L0 = random.rounded(0.55, 0.95);
  column.kPlane = random.rounded(310.0, 600.0);
  column.g = random.rounded(2.1, 9.7);
  return column;
}

VecX toVector(const std::vector<double>& values) {
  return Eigen::Map<const VecX>(values.data(), static_cast<Eigen::Index>(values.size()));
}

std::vector<double> submitted(const Column& column) {
  return submission::columnAtRest(column.m, column.k, column.L0, column.kPlane, column.g);
}

VecX expected(const Column& column) {
  return toVector(oracle::columnAtRest(column.m, column.k, column.L0, column.kPlane, column.g));
}

/// The numbers that the highest height is a sum of [m].
double heightScale(const Column& column) {
  double load = 0.0;
  for (const double m : column.m) load += m * column.g;
  return load / column.kPlane + static_cast<double>(column.m.size() - 1) * (column.L0 + load / column.k);
}

/// Each height is a sum of up to forty terms, each of which may be one of forty: 1600 round-offs at the very most. Who
/// solves the equations of the forces loses their condition, at most 4 n (k / kPlane + n), times round-off.
void expectHeights(const Column& column) {
  const std::vector<double> z = submitted(column);
  const double n = static_cast<double>(column.m.size());
  const double condition = 4.0 * n * (column.k / column.kPlane + n);
  MUELLE_LABEL("heights z of the nodes, bottom first", "m");
  EXPECT_VECTOR_NEAR(toVector(z), expected(column), std::max(2.0 * rounding, 1e-15 * condition) * heightScale(column));
}

/// Sum of the vertical forces on a node: its weight, the springs above and below, the plane.
double netForce(const Column& column, const std::vector<double>& z, std::size_t i) {
  double force = -column.m[i] * column.g;
  if (i == 0) force += column.kPlane * std::max(0.0, -z[0]);
  if (i > 0) force += column.k * (column.L0 - (z[i] - z[i - 1]));
  if (i + 1 < z.size()) force -= column.k * (column.L0 - (z[i + 1] - z[i]));
  return force;
}

// ---- A node that slides ----------------------------------------------------------------------------------------

/// A surface that carries a node's weight, tilted by theta from the horizontal towards a random side.
struct Incline {
  double theta;    ///< [rad]
  double mu, c;    ///< friction coefficient; slope at rest [N s/m]
  double azimuth;  ///< [rad]
  double m = 1.3;  ///< [kg]

  Vec3 sideways() const { return {std::cos(azimuth), std::sin(azimuth), 0.0}; }
  Vec3 normal() const { return std::sin(theta) * sideways() + std::cos(theta) * Vec3::UnitZ(); }
  Vec3 downhill() const { return std::cos(theta) * sideways() - std::sin(theta) * Vec3::UnitZ(); }
  double N() const { return m * gravity * std::cos(theta); }
  /// The speed at which friction reaches mu N.
  double slidingSpeed() const { return mu * N() / c; }

  NodeForce student() const {
    return [*this](const Vec3&, const Vec3& v) {
      return Vec3(carried() + submission::frictionForce(v, normal(), N(), mu, c));
    };
  }
  NodeForce reference() const {
    return [*this](const Vec3&, const Vec3& v) {
      return Vec3(carried() + oracle::frictionForce(v, normal(), N(), mu, c));
    };
  }
  /// What gravity leaves when the surface carries the node: the pull downhill.
  Vec3 carried() const { return m * gravity * std::sin(theta) * downhill(); }
};

constexpr double degree = std::numbers::pi / 180.0;

void expectFriction(const Vec3& v, const Vec3& n, double N, double mu, double c) {
  // v_t is off by the round-off of v.
  const Vec3 force = oracle::frictionForce(v, n, N, mu, c);
  const double loss = v.norm() / (v - v.dot(n) * n).norm();
  EXPECT_VECTOR_NEAR(submission::frictionForce(v, n, N, mu, c), force, rounding * loss * force.norm());
}

void expectNoFriction(const Vec3& v, const Vec3& n, double N, double mu, double c) {
  EXPECT_VECTOR_NEAR(submission::frictionForce(v, n, N, mu, c), Vec3::Zero(), 0.0);
}

}  // namespace

// ---- Plane -----------------------------------------------------------------------------------------------------

TEST(PlaneContact, PushesANodeInside) {
  MUELLE_PROPERTY("a node inside is pushed along n with k depth - d v_n");
  Random random = testRandom();
  for (int i = 0; i < 6; ++i) {
    expectForce(atPlane(random, randomDepth(random), entering));
    expectForce(atPlane(random, randomDepth(random), leavingSlowly));
  }
}

TEST(PlaneContact, IsElasticWithoutDamping) {
  MUELLE_PROPERTY("with d = 0 the force is k depth along n, whatever the velocity");
  Random random = testRandom();
  for (int i = 0; i < 4; ++i) {
    AtPlane at = atPlane(random, randomDepth(random), {-1.0, 1.0});
    at.d = 0.0;
    expectForce(at);
  }
}

TEST(PlaneContact, AnyStiffnessAndDamping) {
  MUELLE_PROPERTY("the softest and the hardest plane push with k depth - d v_n, damped little or much");
  Random random = testRandom();
  for (const double k : muelle::grader::stiffnessLadder) {
    for (const double d : {0.0, 23.0, 1e6}) {
      const double depth = randomDepth(random);
      AtPlane at = atPlane(random, depth, entering);
      at.k = k;
      at.d = d;
      at.v = leavingVelocity(random, at.n, depth, k, d, entering);
      expectForce(at);
    }
  }
}

TEST(PlaneNeverPulls, FollowsFromAllArguments) {
  MUELLE_PROPERTY("what never pulls has to push: the force follows from all arguments");
  MUELLE_EXPECT_OF_USE(planeContact);
}

TEST(PlaneNeverPulls, LetsANodeGo) {
  MUELLE_PROPERTY("a node that leaves so quickly that the damper would hold it back feels no force");
  Random random = testRandom();
  for (int i = 0; i < 4; ++i) {
    const double depth = randomDepth(random);
    AtPlane at = atFloor(random, random.rounded(-3.0, 3.0));
    at.x.z() = at.p.z() - depth;
    expectNeverPulls(at, depth);
  }
}

TEST(PlaneNeverPulls, DoesNotActBeforeTheContact) {
  MUELLE_PROPERTY("a node still outside feels no force, however near it is and however quickly it comes");
  Random random = testRandom();
  for (int i = 0; i < 6; ++i) {
    AtPlane at = atPlane(random, -0.2, entering);
    at.n.z() = std::abs(at.n.z());
    // Beyond the plane along each axis: outside by any part of the sum (x - p) . n.
    for (int axis = 0; axis < 3; ++axis) at.x[axis] = threeDigits(at.p[axis] + random.number(0.2, 2.0) * at.n[axis]);
    const double height = (at.x - at.p).dot(at.n);
    at.v = leavingVelocity(random, at.n, height, at.k, at.d, i % 2 == 0 ? enteringQuickly : leavingSlowly);
    expectNoForce(at);
  }
  for (const double height : exactLengthLadder()) {
    AtPlane at = atFloor(random, 1.0);
    at.x.z() = 1.0 + height;
    expectNoForce(at);
  }
  for (const double height : lengthLadder(1e-30)) {
    AtPlane at = atFloor(random, 0.0);
    at.x.z() = height;
    expectNoForce(at);
  }
}

TEST(PlaneNeverPulls, TheSurfaceIsOutside) {
  MUELLE_PROPERTY("a node exactly on the surface feels no force, even on its way in");
  Random random = testRandom();
  for (int i = 0; i < 4; ++i) {
    AtPlane at = atPlane(random, randomDepth(random), entering);
    at.p = 2.0 * Vec3::Unit(i % 3);  // then p . n - x . n is 0 in whatever order it is summed up
    at.x = at.p;
    expectNoForce(at);
    expectNoForce(atFloor(random, random.rounded(-3.0, 3.0)));
  }
}

TEST(PlaneNeverPulls, ActsFromTheFirstTouch) {
  MUELLE_PROPERTY("a node inside is in contact, however little it is: at half the depth there is half the push");
  Random random = testRandom();
  // Below the floor z = 1 the depth is exact; below a plane of any tilt through the origin it is right to round-off.
  // 0.1: a push that does not grow with the depth itself, as with its square, follows no power exactly.
  expectOneLaw(
      atFloor(random, 1.0), exactLengthLadder(), [](AtPlane& at, double depth) { at.x.z() = 1.0 - depth; },
      "force at a depth", 0.1);
  for (int i = 0; i < 2; ++i) {
    AtPlane at = atPlane(random, 0.1, entering);
    at.p.setZero();
    expectOneLaw(
        at, lengthLadder(1e-30), [](AtPlane& node, double depth) { node.x = -depth * node.n; }, "force at a depth",
        0.1);
  }
}

// ---- Sphere ----------------------------------------------------------------------------------------------------

TEST(SphereContact, PushesANodeInside) {
  MUELLE_PROPERTY("a node inside is pushed away from the centre with k depth - d v_n");
  Random random = testRandom();
  for (int i = 0; i < 6; ++i) {
    expectForce(atSphere(random, randomDepth(random), entering));
    expectForce(atSphere(random, randomDepth(random), leavingSlowly));
  }
  for (int i = 0; i < 3; ++i) expectForce(atSphere(random, random.number(0.8, 1.2), entering));
}

TEST(SphereContact, IsElasticWithoutDamping) {
  MUELLE_PROPERTY("with d = 0 the force is k depth away from the centre, whatever the velocity");
  Random random = testRandom();
  for (int i = 0; i < 4; ++i) {
    AtSphere at = atSphere(random, randomDepth(random), {-1.0, 1.0});
    at.d = 0.0;
    expectForce(at);
  }
}

TEST(SphereContact, AnyStiffnessDampingAndRadius) {
  MUELLE_PROPERTY(
      "the softest and the hardest sphere push with k depth - d v_n, small or large, damped little or much");
  Random random = testRandom();
  for (const double k : muelle::grader::stiffnessLadder) {
    for (const double R : {1e-3, 0.043, 37.0, 1e3}) {
      for (const double d : {0.0, 23.0, 1e6}) expectForce(atSphereOfRadius(random, R, k, d));
    }
  }
}

TEST(SphereEdges, FollowsFromAllArguments) {
  MUELLE_PROPERTY("what never pulls has to push: the force follows from all arguments");
  MUELLE_EXPECT_OF_USE(sphereContact);
}

TEST(SphereEdges, LetsANodeGo) {
  MUELLE_PROPERTY("a node that leaves so quickly that the damper would hold it back feels no force");
  Random random = testRandom();
  for (int i = 0; i < 4; ++i) {
    const double depth = randomDepth(random);
    expectNeverPulls(atSphere(random, depth, entering), depth);
  }
}

TEST(SphereEdges, DoesNotActBeforeTheContact) {
  MUELLE_PROPERTY("a node still outside feels no force, however near it is and however quickly it comes");
  Random random = testRandom();
  for (int i = 0; i < 6; ++i) {
    // At more than twice the radius along a slanted line: outside by any two of the three components.
    AtSphere at = atSphere(random, -0.2, entering);
    at.x = threeDigits(Vec3(at.c + random.number(2.1, 3.0) * at.R * at.normal()));
    const double height = (at.x - at.c).norm() - at.R;
    at.v = leavingVelocity(random, at.normal(), height, at.k, at.d, i % 2 == 0 ? enteringQuickly : leavingSlowly);
    expectNoForce(at);
  }
  for (const double height : exactLengthLadder()) {
    // Lengths by other formulas than the root of the sum of squares are an ulp off.
    if (height < 1e-14) break;
    for (const int side : {0, 1, 2, 3}) {
      AtSphere at = onSphere(random, side);
      at.x[side % 2] *= 1.0 + height;
      expectNoForce(at);
    }
  }
}

TEST(SphereEdges, TheSurfaceIsOutside) {
  MUELLE_PROPERTY("a node exactly on the surface feels no force, even on its way in");
  Random random = testRandom();
  for (const int side : {0, 1, 2, 3}) expectNoForce(onSphere(random, side));
}

TEST(SphereEdges, ActsFromTheFirstTouch) {
  MUELLE_PROPERTY("a node inside is in contact, however little it is: at half the depth there is half the push");
  Random random = testRandom();
  std::vector<double> depths = exactLengthLadder();
  // The round-off of a distance of 2 m is 4e-16 m; 0.25 of the smallest depth (2^-44 m) is more than ten times that.
  std::erase_if(depths, [](double depth) { return depth < 5e-14; });
  // 0.25: the distance itself, by which a wrong normal may be too long, changes by an eighth from the first depth on.
  for (const int side : {0, 3}) {
    expectOneLaw(
        onSphere(random, side), depths,
        [side](AtSphere& at, double depth) { at.x[side % 2] = at.c[side % 2] * (3.0 - depth); }, "force at a depth",
        0.25);
  }
}

TEST(SphereEdges, TheCentreHasNoDirection) {
  MUELLE_PROPERTY("at the very centre the force is zero, and finite");
  Random random = testRandom();
  for (int i = 0; i < 4; ++i) {
    AtSphere at = atSphere(random, randomDepth(random), entering);
    at.x = at.c;
    expectNoForce(at);
    at.d = 0.0;
    expectNoForce(at);
    at.v.setZero();
    expectNoForce(at);
    at.c.setZero();
    at.x.setZero();
    expectNoForce(at);
  }
}

TEST(SphereEdges, AnyOtherPointHasOne) {
  MUELLE_PROPERTY(
      "however near the centre a node is, it is pushed along the line from the centre, as it is farther out");
  Random random = testRandom();
  AtSphere at = atSphere(random, 0.1, entering);
  at.R = 1024.0;  // so that the depth hardly changes: by 0.0008 from 0.75 m to the centre
  at.c.setZero();
  for (int i = 0; i < 2; ++i) {
    const Vec3 n = random.roundedDirection();
    expectOneLaw(
        at, lengthLadder(1e-100), [&](AtSphere& node, double distance) { node.x = distance * n; },
        "force at a distance from the centre", 2e-3);
  }
  // 1 m and a third or two of the distance is exact.
  at.c = Vec3(1, 1, 1);
  std::vector<double> distances = exactLengthLadder();
  for (double& distance : distances) distance *= 3.0;
  expectOneLaw(
      at, distances, [](AtSphere& node, double distance) { node.x = node.c + distance / 3.0 * Vec3(1, -2, 2); },
      "force at a distance from the centre", 2e-3);
}

// ---- Laws ------------------------------------------------------------------------------------------------------

TEST(ContactLaws, FollowFromAllArguments) {
  MUELLE_PROPERTY("a law needs a force: that of each obstacle follows from all arguments");
  MUELLE_EXPECT_OF_USE(planeContact);
  MUELLE_EXPECT_OF_USE(sphereContact);
}

TEST(ContactLaws, NoFrameIsSpecial) {
  MUELLE_PROPERTY("turning and moving node and obstacle together turns the force and changes nothing else");
  Random random = testRandom();
  int number = 0;
  for (const double side : {1.0, 1.0, 1.0, -1.0, -1.0, -1.0}) {  // inside, outside
    // About no axis: exchanged axes and signs would let a sum of sizes pass for a length.
    const Mat3 turn = someTurn(number++);
    const Vec3 shift = threeDigits(random.vector3(3.0));
    MUELLE_LABEL("force on the node after both were turned and moved", "N");
    const AtPlane plane = atPlane(random, side * randomDepth(random), {-0.8, -0.2});
    AtPlane movedPlane = plane;
    movedPlane.x = turn * plane.x + shift;
    movedPlane.p = turn * plane.p + shift;
    movedPlane.v = turn * plane.v;
    movedPlane.n = turn * plane.n;
    const Vec3 ofPlane = turn * submitted(plane);
    EXPECT_VECTOR_NEAR(submitted(movedPlane), ofPlane, structure * forceScale(plane));
    const AtSphere sphere = atSphere(random, side * randomDepth(random), {-0.8, -0.2});
    AtSphere movedSphere = sphere;
    movedSphere.x = turn * sphere.x + shift;
    movedSphere.c = turn * sphere.c + shift;
    movedSphere.v = turn * sphere.v;
    const Vec3 ofSphere = turn * submitted(sphere);
    EXPECT_VECTOR_NEAR(submitted(movedSphere), ofSphere, structure * forceScale(sphere));
  }
}

TEST(ContactLaws, DampingTakesEnergy) {
  MUELLE_PROPERTY("what the velocity adds to the force never has positive power");
  Random random = testRandom();
  const auto expectLoss = [](const auto& at) {
    auto still = at;
    still.v.setZero();
    const Vec3 atRest = submitted(still);
    const double power = (submitted(at) - atRest).dot(at.v);
    MUELLE_LABEL("power of what the velocity adds, if positive", "W");
    EXPECT_NUMBER_NEAR(std::max(0.0, power), 0.0, structure * forceScale(at) * at.v.norm());
  };
  for (int i = 0; i < 3; ++i) {
    expectLoss(atPlane(random, randomDepth(random), entering));
    expectLoss(atPlane(random, randomDepth(random), leavingSlowly));
    expectLoss(atSphere(random, randomDepth(random), entering));
    expectLoss(atSphere(random, randomDepth(random), leavingSlowly));
  }
}

TEST(ContactLaws, KeepsEnergyWithoutDamping) {
  MUELLE_PROPERTY("with d = 0 the force is the same on the way in, at rest and on the way out");
  Random random = testRandom();
  const auto expectElastic = [](auto at) {
    at.d = 0.0;
    auto still = at;
    still.v.setZero();
    const Vec3 atRest = submitted(still);
    MUELLE_LABEL("force on the moving node, less that on one at rest", "N");
    EXPECT_VECTOR_NEAR(Vec3(submitted(at) - atRest), Vec3::Zero(), structure * forceScale(at));
  };
  for (int i = 0; i < 2; ++i) {
    expectElastic(atPlane(random, randomDepth(random), entering));
    expectElastic(atPlane(random, randomDepth(random), leavingSlowly));
    expectElastic(atSphere(random, randomDepth(random), entering));
    expectElastic(atSphere(random, randomDepth(random), leavingSlowly));
  }
}

TEST(ContactLaws, ActsAlongTheNormal) {
  MUELLE_PROPERTY(
      "contact without friction has no component along the surface: a sphere exerts no torque about its centre");
  Random random = testRandom();
  for (int i = 0; i < 3; ++i) {
    const AtPlane plane = atPlane(random, randomDepth(random), entering);
    const Vec3 force = submitted(plane);
    {
      MUELLE_LABEL("part of the force along the plane", "N");
      EXPECT_VECTOR_NEAR(Vec3(force - force.dot(plane.n) * plane.n), Vec3::Zero(), structure * forceScale(plane));
    }
    const AtSphere sphere = atSphere(random, randomDepth(random), entering);
    MUELLE_LABEL("torque about the centre", "N m");
    EXPECT_VECTOR_NEAR((sphere.x - sphere.c).cross(submitted(sphere)).eval(), Vec3::Zero(),
                       structure * forceScale(sphere) * sphere.R);
  }
}

// ---- Bounces ---------------------------------------------------------------------------------------------------

// While the node is inside, symplectic Euler keeps w^2 s^2 + u^2 - h w^2 s u exactly (s height above the surface, u its
// rate, w^2 = k / m); outside it keeps u. At the first step inside, s is between 0 and h u, so that entering and
// leaving change u^2 by at most u^2 (w h)^2 / 4 each, in opposite senses: together by at most u^2 (w h)^2 / 4.

// Above the slab [m], at 1.1 m/s and steps of 1e-5 s, 9.43 steps away: the nearest steps are 4.7e-6 m above the surface
// and 6.3e-6 m below it. A node that met the surface exactly would feel the damper or not by the order in which its
// depth is summed up: each sum of six products of about 2 m is off by some 1e-15 m.
constexpr double startHeight = 1.037e-4;
constexpr double startSpeed = 1.1;

/// A node of 1.3 kg that comes to a slab, and slides along it.
Node thrownAt(const Slab& slab, const Vec3& along) {
  return {slab.p + startHeight * slab.n, -startSpeed * slab.n + along, 1.3};
}

/// Along the slab [m/s].
const Vec3 sliding(0.21, 0.42, 0.0);

TEST(Bounce, TakesHalfAPeriodAndNoEnergy) {
  MUELLE_PROPERTY("without damping and gravity a contact lasts half a period, pi sqrt(m / k), and returns the speed");
  const Slab slab;
  const Node node = thrownAt(slab, sliding);
  const double h = 1e-5, omega = std::sqrt(slab.k / node.m), omegaH = omega * h;
  const Trajectory trajectory = compareMotions(node, slab.student(), slab.reference(), h, 0.0116, 10.0);
  if (trajectory.stop.stopped) return;
  {
    MUELLE_LABEL("velocity after the bounce", "m/s");
    EXPECT_VECTOR_NEAR(lastVelocity(trajectory), Vec3(startSpeed * slab.n + sliding),
                       startSpeed * omegaH * omegaH / 8.0 + structure);
  }
  int inside = 0;
  for (std::size_t i = 0; i < trajectory.t.size(); ++i)
    if ((positionAt(trajectory, i) - slab.p).dot(slab.n) < 0.0) ++inside;
  // The steps inside lie on a sine of half period pi / w' that changes sign between steps; 2 sin(w' h / 2) = w h.
  MUELLE_LABEL("duration of the contact", "s");
  EXPECT_NUMBER_NEAR(inside * h, std::numbers::pi / omega, h * (1.0 + omegaH));
}

TEST(Bounce, DampingSlowsABallAndLetsItGo) {
  MUELLE_PROPERTY("a damped contact ends when its force has fallen to zero: the ball leaves with that speed");
  Slab slab;
  const Node node = thrownAt(slab, sliding);
  const double omega0 = std::sqrt(slab.k / node.m), gamma = 0.3 * omega0;
  const double omega = std::sqrt(omega0 * omega0 - gamma * gamma);
  slab.d = 2.0 * gamma * node.m;
  const double h = 1e-5;
  const Trajectory trajectory = compareMotions(node, slab.student(), slab.reference(), h, 0.02, 10.0);
  if (trajectory.stop.stopped) return;
  // The force of s = -exp(-gamma t) sin(omega t) / omega first falls to zero at omega t = 2 atan(omega / gamma), with
  // the speed exp(-gamma t) (Schwager and Poeschel 2007). A contact that pulls holds on until omega t = pi: 0.37, not
  // 0.45. The method's velocity is half a step late in the force, and it enters up to one step late: gamma, omega and
  // the exponent are off by a fraction of omega0 h each.
  const double restitution = std::exp(-gamma * 2.0 * std::atan2(omega, gamma) / omega);
  {
    MUELLE_LABEL("speed out of the plane after the bounce", "m/s");
    EXPECT_NUMBER_NEAR(lastVelocity(trajectory).dot(slab.n), startSpeed * restitution, startSpeed * 2.0 * omega0 * h);
  }
  MUELLE_LABEL("velocity along the plane after the bounce", "m/s");
  EXPECT_VECTOR_NEAR(Vec3(lastVelocity(trajectory) - lastVelocity(trajectory).dot(slab.n) * slab.n), sliding,
                     structure);
}

TEST(Bounce, GlancesOffASphere) {
  MUELLE_PROPERTY("a node that glances off a sphere keeps its angular momentum about the centre and loses energy");
  const Vec3 c(0.3, -0.2, 0.55);
  const double R = 0.7, k = 2100.0, d = 21.0;
  const Node node{c + Vec3(0.8, 0.07, 0.3), Vec3(-2.1, 0.3, 0.2), 1.6};
  const auto student = [&](const Vec3& x, const Vec3& v) { return submission::sphereContact(x, v, c, R, k, d); };
  const auto reference = [&](const Vec3& x, const Vec3& v) { return oracle::sphereContact(x, v, c, R, k, d); };
  const Trajectory trajectory = compareMotions(node, student, reference, 4.3e-4, 0.5, 3.0);
  if (trajectory.stop.stopped) return;
  {
    MUELLE_LABEL("angular momentum about the centre, over the mass", "m^2/s");
    EXPECT_VECTOR_NEAR((lastPosition(trajectory) - c).cross(lastVelocity(trajectory)).eval(),
                       (node.x - c).cross(node.v).eval(), structure * 3.0);
  }
  MUELLE_LABEL("speed that is left, beyond nine tenths of the first", "m/s");
  EXPECT_NUMBER_NEAR(std::max(0.0, lastVelocity(trajectory).norm() - 0.9 * node.v.norm()), 0.0, 0.0);
}

TEST(Bounce, ReturnsABallToItsHeight) {
  MUELLE_PROPERTY(
      "a ball of 1.3 kg that falls from 1.1 m on an undamped plane enters it by 16.9 mm and returns to 1.1 m");
  Slab ground;
  ground.p = Vec3::Zero();
  ground.n = Vec3::UnitZ();
  const double height = 1.1, mass = 1.3;
  const double h = 2e-4, omegaH = std::sqrt(ground.k / mass) * h;
  const Vec3 weight = -mass * gravity * Vec3::UnitZ();
  const auto with = [&](const NodeForce& contact) {
    return [contact, weight](const Vec3& x, const Vec3& v) { return Vec3(contact(x, v) + weight); };
  };
  const Node node{Vec3(0.4, -0.7, height), Vec3::Zero(), mass};
  const Trajectory trajectory = compareMotions(node, with(ground.student()), with(ground.reference()), h, 0.97, 10.0);
  if (trajectory.stop.stopped) return;
  double lowest = height, apex = 0.0;
  for (std::size_t i = 0; i < trajectory.t.size(); ++i) {
    lowest = std::min(lowest, trajectory.x[i][2]);
    if (trajectory.t[i] > 0.5) apex = std::max(apex, trajectory.x[i][2]);
  }
  // g times the height is u^2 / 2 at the surface. At the bottom: (w h)^2 / 8 each for entering, the shape of the kept
  // ellipse and the step nearest to the bottom. The last term is g h v / 2 of the step nearest to the apex.
  {
    MUELLE_LABEL("height to which the ball returns", "m");
    EXPECT_NUMBER_NEAR(apex, height, height * omegaH * omegaH / 4.0 + gravity * h * h);
  }
  // m g (height + s) = k s^2 / 2.
  const double rest = mass * gravity / ground.k;
  const double deepest = rest + std::sqrt(rest * rest + 2.0 * rest * height);
  MUELLE_LABEL("lowest height of the ball", "m");
  EXPECT_NUMBER_NEAR(lowest, -deepest, deepest * omegaH * omegaH / 2.0);
}

// ---- A column at rest ------------------------------------------------------------------------------------------

TEST(ColumnAtRest, EachSpringCarriesWhatIsAboveIt) {
  MUELLE_PROPERTY("the heights follow from the weight that the plane and each spring carry");
  Random random = testRandom();
  for (int nodes = 1; nodes <= 6; ++nodes) expectHeights(randomColumn(random, nodes));
}

TEST(ColumnAtRest, TheForcesOnEveryNodeSumToZero) {
  MUELLE_PROPERTY("at rest weight, springs and plane sum to zero at every node");
  Random random = testRandom();
  for (int nodes = 1; nodes <= 5; ++nodes) {
    const Column column = randomColumn(random, nodes);
    const std::vector<double> z = submitted(column);
    if (z.size() != column.m.size()) continue;
    for (std::size_t i = 0; i < z.size(); ++i) {
      MUELLE_LABEL(fmt::format("sum of the forces on node {} of {}, counted from 0 at the bottom", i, nodes), "N");
      EXPECT_NUMBER_NEAR(netForce(column, z, i), 0.0,
                         2.0 * rounding * heightScale(column) * (4.0 * column.k + column.kPlane));
    }
  }
}

TEST(ColumnAtRest, AnyNumberOfNodes) {
  MUELLE_PROPERTY("one node stands on the plane alone; forty stand on each other, light or heavy");
  Random random = testRandom();
  for (const int nodes : {1, 2, 3, 9, 40}) {
    Column column = randomColumn(random, nodes);
    column.k = 1e9;
    column.kPlane = 2.9e5;
    for (double& m : column.m) m = threeDigits(random.positive(1e-3, 1e3));
    column.m.back() = nodes % 2 == 0 ? 1e3 : 1e-3;
    expectHeights(column);
    column.L0 = 100.0;
    column.g = 30.0;
    expectHeights(column);
  }
}

TEST(ColumnAtRest, AnyStiffness) {
  MUELLE_PROPERTY("springs and plane may be soft or hard: the heights follow from what they carry");
  Random random = testRandom();
  for (const double k : muelle::grader::stiffnessLadder) {
    Column column = randomColumn(random, 1);
    column.kPlane = k;
    column.k = 1e6 / k;
    expectHeights(column);
    column = randomColumn(random, 4);
    column.k = k;
    column.L0 = 92.0;
    // No spring is pressed to length zero: the lowest is pressed by a third of its length.
    column.g = std::min(7.3, threeDigits(k * column.L0 / 3.0 / (column.m[1] + column.m[2] + column.m[3])));
    expectHeights(column);
  }
}

TEST(ColumnAtRest, HasItsRestLengthsWithoutGravity) {
  MUELLE_PROPERTY("without gravity the springs have their rest lengths, and the lowest node touches the surface");
  Random random = testRandom();
  for (const double L0 : {0.73, 0.0}) {
    for (const int nodes : {1, 4}) {
      Column column = randomColumn(random, nodes);
      column.g = 0.0;
      column.L0 = L0;
      expectHeights(column);
    }
  }
  Column alone = randomColumn(random, 1);
  alone.L0 = 0.0;
  expectHeights(alone);
}

// ---- Friction --------------------------------------------------------------------------------------------------

TEST(Friction, IsTheSmallerOfItsTwoSizes) {
  MUELLE_PROPERTY("friction is against the tangential velocity, of size c |v_t| up to mu N");
  Random random = testRandom();
  for (int i = 0; i < 10; ++i) {
    const Vec3 n = random.roundedDirection();
    const Vec3 v = threeDigits(Vec3(random.number(-3.0, 3.0) * n + across(n, random, 3.0)));
    const double c = random.rounded(2.1, 20.0), mu = random.rounded(0.21, 1.2);
    const double ramp = c * (v - v.dot(n) * n).norm();
    // Half of them creep, half of them slide.
    const double N = threeDigits(ramp / mu * (i % 2 == 0 ? random.number(1.2, 3.0) : random.number(0.3, 0.8)));
    expectFriction(v, n, N, mu, c);
  }
}

TEST(Friction, AnyForceAndSlope) {
  MUELLE_PROPERTY("pressed little or much, rough or smooth: the smaller of mu N and c |v_t|");
  Random random = testRandom();
  for (const double N : {3e-4, 47.0, 1e6}) {
    for (const double mu : {0.013, 0.7, 10.0}) {
      for (const double c : {0.03, 17.0, 1e6}) {
        const Vec3 n = random.roundedDirection();
        expectFriction(threeDigits(Vec3(random.number(-3.0, 3.0) * n + across(n, random, 3.0))), n, N, mu, c);
      }
    }
  }
}

TEST(Friction, IsZeroAtRest) {
  MUELLE_PROPERTY("without tangential velocity, without normal force, with mu = 0 or with c = 0 there is no friction");
  Random random = testRandom();
  for (const double side : {1.0, -1.0}) {
    const Vec3 n = random.roundedDirection(), v = threeDigits(random.vector3(2.0));
    const Vec3 up = side * Vec3::UnitZ(), bouncing(0, 0, random.rounded(-3.0, 3.0));
    for (const double N : {random.rounded(1.1, 5.0), 0.0}) {
      for (const double mu : {random.rounded(0.2, 1.2), 0.0}) {
        for (const double c : {random.rounded(2.1, 20.0), 0.0}) {
          expectNoFriction(Vec3::Zero(), n, N, mu, c);
          expectNoFriction(bouncing, up, N, mu, c);
          if (N * mu * c == 0.0) expectNoFriction(v, n, N, mu, c);
        }
      }
    }
  }
}

TEST(Friction, HoldsAtAnySpeed) {
  MUELLE_PROPERTY("the slowest motion is against friction too: it is c |v_t|, while the node bounces as well");
  Random random = testRandom();
  for (const double speed : lengthLadder(1e-100)) {
    const double c = random.rounded(2.1, 20.0);
    const Vec3 n = random.roundedDirection();
    Vec3 slanted = random.roundedDirection();
    while (std::abs(slanted.dot(n)) > 0.9) slanted = random.roundedDirection();
    expectFriction(speed * slanted, n, 53.0, 0.55, c);
    // Along an axis the normal velocity is taken off exactly.
    const Vec3 slow(0.6 * speed, -0.8 * speed, -2.3);
    EXPECT_VECTOR_NEAR(submission::frictionForce(slow, Vec3::UnitZ(), 53.0, 0.55, c),
                       oracle::frictionForce(slow, Vec3::UnitZ(), 53.0, 0.55, c), rounding * c * speed);
  }
}

TEST(FrictionMotion, CreepsBelowTheFrictionAngle) {
  MUELLE_PROPERTY("where tan(theta) < mu a node let go creeps downhill at m g sin(theta) / c, and no faster");
  Random random = testRandom();
  for (const double angle : {27.5, 11.0}) {
    const Incline incline{angle * degree, 0.55, 1100.0, random.rounded(0.1, 6.0)};
    const Node node{Vec3(0.3, -0.4, 0.7), Vec3::Zero(), incline.m};
    const double h = 1e-4, duration = 0.024, creep = incline.m * gravity * std::sin(incline.theta) / incline.c;
    const Trajectory trajectory = compareMotions(node, incline.student(), incline.reference(), h, duration, creep);
    if (trajectory.stop.stopped) continue;
    // Linear until mu N, which is not reached: the distance to the creep's speed shrinks by exp(-20).
    const double way = (lastPosition(trajectory) - node.x).norm();
    {
      MUELLE_LABEL(fmt::format("velocity after {} s", duration), "m/s");
      EXPECT_VECTOR_NEAR(lastVelocity(trajectory), Vec3(creep * incline.downhill()), creep * structure);
    }
    const double late = incline.m / incline.c;
    MUELLE_LABEL(fmt::format("way after {} s", duration), "m");
    EXPECT_NUMBER_NEAR(way, creep * (duration - late / 2.0), creep * late / 2.0);
  }
}

TEST(FrictionMotion, SlidesAboveTheFrictionAngle) {
  MUELLE_PROPERTY("where tan(theta) > mu a node let go slides with acceleration g (sin(theta) - mu cos(theta))");
  Random random = testRandom();
  const Incline incline{31.0 * degree, 0.47, 1100.0, random.rounded(0.1, 6.0)};
  const Node node{Vec3(0.3, -0.4, 0.7), Vec3::Zero(), incline.m};
  const double h = 4e-4, duration = 0.9;
  const Trajectory trajectory = compareMotions(node, incline.student(), incline.reference(), h, duration, 3.0);
  if (trajectory.stop.stopped) return;
  // Friction is at most mu N, so that the speed is at least a t; it gains on that only while it is below the speed at
  // which friction reaches mu N, and by at most one step of free fall more.
  const double a = gravity * (std::sin(incline.theta) - incline.mu * std::cos(incline.theta));
  const double lead = incline.slidingSpeed() + h * gravity * std::sin(incline.theta);
  {
    MUELLE_LABEL(fmt::format("speed downhill after {} s", duration), "m/s");
    EXPECT_NUMBER_NEAR(lastVelocity(trajectory).dot(incline.downhill()), a * duration + lead / 2.0, lead / 2.0);
  }
  MUELLE_LABEL(fmt::format("way downhill after {} s", duration), "m");
  EXPECT_NUMBER_NEAR((lastPosition(trajectory) - node.x).dot(incline.downhill()),
                     a * duration * duration / 2.0 + lead * duration / 2.0,
                     lead * duration / 2.0 + a * h * duration / 2.0);
}

TEST(FrictionMotion, StopsOnTheFlatAndStays) {
  MUELLE_PROPERTY("a node thrown along the flat stops after v^2 / (2 mu g) and does not turn back");
  Random random = testRandom();
  const Incline flat{0.0, 0.47, 1100.0, random.rounded(0.1, 6.0)};
  const double speed = 2.7;
  const Node node{Vec3(0.3, -0.4, 0.7), speed * flat.downhill(), flat.m};
  const double h = 4e-4;
  const Trajectory trajectory = compareMotions(node, flat.student(), flat.reference(), h, 0.63, 3.0);
  if (trajectory.stop.stopped) return;
  // A constant deceleration shortens the method's way by h v / 2. Below the speed v* at which friction falls under mu N
  // the way is v*^2 / (2 mu g) longer than Coulomb's; the step at v* adds less than h v*.
  const double slow = flat.slidingSpeed();
  {
    MUELLE_LABEL("way until the node stops", "m");
    EXPECT_NUMBER_NEAR((lastPosition(trajectory) - node.x).dot(flat.downhill()),
                       speed * speed / (2.0 * flat.mu * gravity),
                       h * speed / 2.0 + h * slow + slow * slow / (2.0 * flat.mu * gravity));
  }
  for (std::size_t i = 0; i < trajectory.t.size(); ++i) {
    const double back = std::max(0.0, -velocityAt(trajectory, i).dot(flat.downhill()));
    if (back == 0.0) continue;
    MUELLE_LABEL(fmt::format("speed back at t = {:.4g} s", trajectory.t[i]), "m/s");
    EXPECT_NUMBER_NEAR(back, 0.0, 0.0);
    return;
  }
}
