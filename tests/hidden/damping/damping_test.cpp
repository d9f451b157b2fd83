#include "damping.h"

#include "course/testing/expect.h"
#include "course/testing/random.h"
#include "harness/function_system.h"
#include "harness/march.h"
#include "harness/symplectic_euler.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <cmath>
#include <functional>
#include <numbers>

// Rates and reference values of the rotating pair: tests/hard_cases, H07 (rotating_dumbbell_damping_rates).

namespace {

using muelle::In;
using muelle::Node;
using muelle::node3;
using muelle::Out;
using muelle::Random;
using muelle::roundOff;
using muelle::State;
using muelle::testRandom;
using muelle::Trajectory;
using muelle::VecX;

/// Two nodes as a damper sees them, and its coefficient.
struct Pair {
  Vec3 xa, xb, va, vb;
  double d = 0.0;
};

Pair randomPair(Random& random) {
  return {random.vector3(2.0), random.vector3(2.0), random.vector3(3.0), random.vector3(3.0),
          random.positive(0.2, 20.0)};
}

/// The largest force of such a pair, for tolerances: d (|va| + |vb|).
double forceScale(const Pair& pair) { return pair.d * (pair.va.norm() + pair.vb.norm()); }

Vec3 projectedOnA(const Pair& p) { return submission::projectedDamping(p.xa, p.xb, p.va, p.vb, p.d); }
Vec3 projectedOnB(const Pair& p) { return submission::projectedDamping(p.xb, p.xa, p.vb, p.va, p.d); }
Vec3 oracleProjected(const Pair& p) { return oracle::projectedDamping(p.xa, p.xb, p.va, p.vb, p.d); }

void expectProjected(const Pair& pair) {
  EXPECT_VECTOR_NEAR(projectedOnA(pair), oracleProjected(pair), roundOff(forceScale(pair)));
}

// ---- Motion of a pair that a spring joins ----------------------------------------------------------------------

/// Force of a damper on the first of two nodes.
using Damper = std::function<Vec3(const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb)>;

/// Two nodes, their spring and gravity along -z.
struct Scene {
  std::vector<Node> nodes;
  double k = 252.0;
  double L0 = 1.0;
  double g = 0.0;
  double h = 4e-3;
  double duration = 5.0;
};

Vec3 elasticForceOnA(const Scene& scene, const Vec3& xa, const Vec3& xb) {
  const double L = (xa - xb).norm();
  return -scene.k * (L - scene.L0) / L * (xa - xb);
}

Trajectory run(const Scene& scene, const Damper& damper) {
  const auto forces = [&](double, In x, In v, Out f) {
    const Vec3 xa = node3(x, 0), xb = node3(x, 1), va = node3(v, 0), vb = node3(v, 1);
    const Vec3 elastic = elasticForceOnA(scene, xa, xb);
    node3(f, 0) = elastic + damper(xa, xb, va, vb) - scene.nodes[0].m * scene.g * Vec3::UnitZ();
    node3(f, 1) = -elastic + damper(xb, xa, vb, va) - scene.nodes[1].m * scene.g * Vec3::UnitZ();
  };
  const muelle::FunctionSystem system(muelle::massesOf(scene.nodes), forces);
  muelle::MarchOptions options;
  options.h = scene.h;
  options.duration = scene.duration;
  options.outputEvery = 25;
  return muelle::march(system, muelle::stateOf(scene.nodes), options);
}

/// Every recorded position and velocity, as one vector.
VecX states(const Trajectory& trajectory) {
  std::vector<double> all;
  for (std::size_t i = 0; i < trajectory.t.size(); ++i) {
    all.insert(all.end(), trajectory.x[i].begin(), trajectory.x[i].end());
    all.insert(all.end(), trajectory.v[i].begin(), trajectory.v[i].end());
  }
  return Eigen::Map<const VecX>(all.data(), static_cast<Eigen::Index>(all.size()));
}

/// Runs the scene with the student's damper and with the reference; both take the same steps, so that they agree to
/// round-off (1e-9 m and m/s: some thousand steps of 1e-16, none of which the damped motion amplifies).
Trajectory expectSameMotion(const Scene& scene, const Damper& student, const Damper& reference) {
  const Trajectory trajectory = run(scene, student);
  EXPECT_FALSE(trajectory.stop.stopped) << trajectory.stop.message;
  EXPECT_VECTOR_NEAR(states(trajectory), states(run(scene, reference)), roundOff(1.0));
  return trajectory;
}

Damper studentNode(double d) {
  return [d](const Vec3&, const Vec3&, const Vec3& va, const Vec3&) { return submission::nodeDamping(va, d); };
}
Damper oracleNode(double d) {
  return [d](const Vec3&, const Vec3&, const Vec3& va, const Vec3&) { return oracle::nodeDamping(va, d); };
}
Damper studentRelative(double d) {
  return
      [d](const Vec3&, const Vec3&, const Vec3& va, const Vec3& vb) { return submission::relativeDamping(va, vb, d); };
}
Damper oracleRelative(double d) {
  return [d](const Vec3&, const Vec3&, const Vec3& va, const Vec3& vb) { return oracle::relativeDamping(va, vb, d); };
}
Damper studentProjected(double d) {
  return [d](const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb) {
    return submission::projectedDamping(xa, xb, va, vb, d);
  };
}
Damper oracleProjected(double d) {
  return [d](const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb) {
    return oracle::projectedDamping(xa, xb, va, vb, d);
  };
}

double lengthOf(const State& state) { return (node3(In(state.x), 0) - node3(In(state.x), 1)).norm(); }

double angularMomentumZ(const Scene& scene, const State& state) {
  double Lz = 0.0;
  for (int i = 0; i < 2; ++i) {
    const Vec3 x = node3(In(state.x), i), v = node3(In(state.v), i);
    Lz += scene.nodes[static_cast<std::size_t>(i)].m * x.cross(v).z();
  }
  return Lz;
}

Vec3 meanVelocity(const Scene& scene, const State& state) {
  const double ma = scene.nodes[0].m, mb = scene.nodes[1].m;
  return (ma * node3(In(state.v), 0) + mb * node3(In(state.v), 1)) / (ma + mb);
}

/// H07: a pair that turns at 4 rad/s about its centre of mass, at the length 1.05 m at which that is an equilibrium.
Scene rotatingPair(double ma, double mb) {
  const double ra = 1.05 * mb / (ma + mb), rb = -1.05 * ma / (ma + mb);
  Scene scene;
  scene.nodes = {Node{{ra, 0, 0}, {0, 4.0 * ra, 0}, ma}, Node{{rb, 0, 0}, {0, 4.0 * rb, 0}, mb}};
  // H07 turns with the reduced mass 3/4 kg in all its variants.
  return scene;
}

/// H07's angular momentum at 5 s, with damping at the rate 0.4 / s.
constexpr double SlowedAngularMomentum = 0.447621449305096478;

/// Angular momentum after damping at `rate`. The method's own law is exact: each step multiplies it by 1 - h rate. That
/// differs from exp(-rate t) by the relative error rate^2 t h / 2 to leading order.
void expectSlowedRotation(const Scene& scene, const Trajectory& trajectory, double rate) {
  ASSERT_FALSE(trajectory.stop.stopped);
  const State start = muelle::stateOf(scene.nodes), end = trajectory.last();
  const double steps = std::round(scene.duration / scene.h);
  const double slowed = angularMomentumZ(scene, start) * std::pow(1.0 - scene.h * rate, steps);
  EXPECT_NUMBER_NEAR(angularMomentumZ(scene, end), slowed, roundOff(3.0));
  const double relativeError = 1.1 * rate * rate * scene.duration * scene.h / 2.0;
  EXPECT_NUMBER_NEAR(angularMomentumZ(scene, end), SlowedAngularMomentum, relativeError * SlowedAngularMomentum);
}

/// How far the length may stray from the circle's. Symplectic Euler is leapfrog that takes the start velocity for the
/// one half a step earlier: the pair gets the radial speed h a / 2 with a = 4^2 * 1.05, and so swings by that over the
/// radial frequency omega_r^2 = k / mu + 3 * 4^2, mu = 3/4 kg.
double lengthTolerance(const Scene& scene) {
  const double acceleration = 16.0 * 1.05, radialFrequency = std::sqrt(scene.k / 0.75 + 48.0);
  return 1.1 * scene.h * acceleration / (2.0 * radialFrequency);
}

/// A pair along a direction, stretched by 0.1 m and let go.
Scene vibratingPair(double ma, double mb) {
  const Vec3 u = Vec3(1, 2, -2) / 3.0;
  Scene scene;
  scene.nodes = {Node{1.1 * u, Vec3::Zero(), ma}, Node{Vec3::Zero(), Vec3::Zero(), mb}};
  scene.h = 1e-3;
  scene.duration = 1.0;
  return scene;
}

/// Stretch of a damped oscillator let go at `stretch`: decay gamma, undamped frequency omega0 > gamma.
double dampedStretch(double stretch, double gamma, double omega0, double t) {
  const double omega = std::sqrt(omega0 * omega0 - gamma * gamma);
  return stretch * std::exp(-gamma * t) * (std::cos(omega * t) + gamma / omega * std::sin(omega * t));
}

/// The length follows the damped oscillator with decay gamma. Symplectic Euler has the velocity half a step late: that
/// starts the oscillator with a speed of h omega0^2 stretch / 2, and makes gamma and omega larger by h gamma / 2 to
/// h gamma; together at most stretch h (omega0 / 2 + omega0 / (2 e) + gamma / e) < stretch h omega0, as gamma < omega0
/// / 3.
void expectDampedVibration(const Scene& scene, const Trajectory& trajectory, double gamma) {
  ASSERT_FALSE(trajectory.stop.stopped);
  const double ma = scene.nodes[0].m, mb = scene.nodes[1].m;
  const double omega0 = std::sqrt(scene.k * (ma + mb) / (ma * mb));
  ASSERT_LT(gamma, omega0 / 3.0);
  VecX lengths(static_cast<Eigen::Index>(trajectory.t.size())), exact(lengths.size());
  for (std::size_t i = 0; i < trajectory.t.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    lengths[row] = lengthOf(State{trajectory.t[i], trajectory.x[i], trajectory.v[i], {}});
    exact[row] = scene.L0 + dampedStretch(0.1, gamma, omega0, trajectory.t[i]);
  }
  EXPECT_VECTOR_NEAR(lengths, exact, 0.1 * scene.h * omega0);
}

/// A pair that is thrown, turns and vibrates while it falls.
Scene tumblingFall() {
  Scene scene;
  scene.nodes = {Node{{0.9, 0.2, 3.0}, {0.3, 2.0, 1.0}, 1.0}, Node{{-0.3, 0.0, 3.1}, {-0.2, -1.0, 0.5}, 3.0}};
  scene.g = 9.81;
  scene.h = 1e-3;
  scene.duration = 0.5;
  return scene;
}

/// The centre of mass has the velocity of free fall (exact for the method too: gravity is constant).
void expectFreeFall(const Scene& scene, const Trajectory& trajectory) {
  ASSERT_FALSE(trajectory.stop.stopped);
  const Vec3 fallen = meanVelocity(scene, muelle::stateOf(scene.nodes)) - scene.g * scene.duration * Vec3::UnitZ();
  EXPECT_VECTOR_NEAR(meanVelocity(scene, trajectory.last()), fallen, roundOff(scene.g * scene.duration));
}

}  // namespace

// ---- Values ----------------------------------------------------------------------------------------------------

TEST(NodeDamping, OpposesTheVelocity) {
  MUELLE_PROPERTY("the force on a node is against its velocity and d times as large");
  Random random = testRandom();
  for (int i = 0; i < 6; ++i) {
    const Vec3 va = random.vector3(5.0);
    const double d = random.positive(0.2, 20.0);
    EXPECT_VECTOR_NEAR(submission::nodeDamping(va, d), oracle::nodeDamping(va, d), roundOff(d * va.norm()));
  }
}

TEST(NodeDamping, IsZeroAtRestAndWithoutDamping) {
  MUELLE_PROPERTY("a node at rest is not damped, and d = 0 damps nothing");
  Random random = testRandom();
  for (int i = 0; i < 3; ++i) {
    EXPECT_VECTOR_NEAR(submission::nodeDamping(Vec3::Zero(), random.positive(0.2, 20.0)), Vec3::Zero(), 0.0);
    EXPECT_VECTOR_NEAR(submission::nodeDamping(random.vector3(5.0), 0.0), Vec3::Zero(), 0.0);
  }
}

TEST(RelativeDamping, OpposesTheRelativeVelocity) {
  MUELLE_PROPERTY("the force on a is against the velocity of a as seen from b, and d times as large");
  Random random = testRandom();
  for (int i = 0; i < 6; ++i) {
    const Pair p = randomPair(random);
    EXPECT_VECTOR_NEAR(submission::relativeDamping(p.va, p.vb, p.d), oracle::relativeDamping(p.va, p.vb, p.d),
                       roundOff(forceScale(p)));
  }
}

TEST(RelativeDamping, DoesNotSeeACommonVelocity) {
  MUELLE_PROPERTY("two nodes with the same velocity are not damped, and adding one velocity to both changes nothing");
  Random random = testRandom();
  for (int i = 0; i < 3; ++i) {
    const Pair p = randomPair(random);
    const Vec3 common = random.vector3(5.0);
    EXPECT_VECTOR_NEAR(submission::relativeDamping(common, common, p.d), Vec3::Zero(), 0.0);
    EXPECT_VECTOR_NEAR(submission::relativeDamping(p.va + common, p.vb + common, p.d),
                       oracle::relativeDamping(p.va, p.vb, p.d), roundOff(forceScale(p) + p.d * common.norm()));
  }
}

TEST(ProjectedDamping, OpposesTheStretching) {
  MUELLE_PROPERTY("the force is along the spring, against the rate at which its length changes, and d times as large");
  Random random = testRandom();
  for (int i = 0; i < 8; ++i) expectProjected(randomPair(random));
}

TEST(ProjectedDamping, HoldsForAnyLength) {
  MUELLE_PROPERTY("the force depends on the direction of the spring, not on its length");
  Random random = testRandom();
  for (const double L : {0.05, 1.0, 40.0}) {
    Pair pair = randomPair(random);
    pair.xa = pair.xb + L * random.direction();
    expectProjected(pair);
  }
  Pair unit = randomPair(random);
  unit.xb = Vec3(1, 2, 3);
  unit.xa = Vec3(1, 3, 3);  // a length of 1 without rounding
  expectProjected(unit);
}

TEST(ProjectedDamping, SeparatesStretchingFromTurning) {
  MUELLE_PROPERTY("velocity along the spring is damped in full, velocity across the spring not at all");
  Random random = testRandom();
  for (int i = 0; i < 3; ++i) {
    Pair pair = randomPair(random);
    const Vec3 u = (pair.xa - pair.xb).normalized();
    const double rate = random.number(-3.0, 3.0);
    const Vec3 across = u.cross(random.vector3(3.0));
    pair.va = pair.vb + rate * u + across;
    EXPECT_VECTOR_NEAR(projectedOnA(pair), Vec3(-pair.d * rate * u), roundOff(forceScale(pair)));
    pair.va = pair.vb + across;
    EXPECT_VECTOR_NEAR(projectedOnA(pair), Vec3::Zero(), roundOff(forceScale(pair)));
  }
}

TEST(ShortSpring, HasADirectionHoweverShort) {
  MUELLE_PROPERTY("a spring of length 1e-9 m, or shorter, is damped like any other");
  Random random = testRandom();
  for (const double L : {2.5, 0.4, 1e-9, 1e-9, 1e-9, 1e-9, 3e-13, 3e-13, 3e-13, 3e-13}) {
    Pair pair = randomPair(random);
    pair.xa = L * random.direction();
    pair.xb = Vec3::Zero();
    expectProjected(pair);
  }
}

TEST(ShortSpring, HasNoDirectionAtLengthZero) {
  MUELLE_PROPERTY("with both nodes at one place the force is zero, and finite");
  Random random = testRandom();
  for (int i = 0; i < 4; ++i) {
    Pair pair = randomPair(random);
    pair.xa = pair.xb;
    EXPECT_VECTOR_NEAR(projectedOnA(pair), Vec3::Zero(), 0.0);
  }
}

// ---- Laws: always at inputs where the value is asked for too ----------------------------------------------------

TEST(PairLaws, ActionIsReaction) {
  MUELLE_PROPERTY("exchanging the ends of the spring turns the force round: momentum is conserved");
  Random random = testRandom();
  for (int i = 0; i < 4; ++i) {
    const Pair p = randomPair(random);
    const Vec3 relativeA = submission::relativeDamping(p.va, p.vb, p.d);
    const Vec3 relativeB = submission::relativeDamping(p.vb, p.va, p.d);
    EXPECT_VECTOR_NEAR(relativeA, oracle::relativeDamping(p.va, p.vb, p.d), roundOff(forceScale(p)));
    EXPECT_VECTOR_NEAR(relativeB, Vec3(-relativeA), roundOff(forceScale(p)));
    expectProjected(p);
    EXPECT_VECTOR_NEAR(projectedOnB(p), Vec3(-oracleProjected(p)), roundOff(forceScale(p)));
  }
}

TEST(PairLaws, DampingTakesEnergy) {
  MUELLE_PROPERTY("the power of a spring's damping is never positive");
  Random random = testRandom();
  for (int i = 0; i < 4; ++i) {
    const Pair p = randomPair(random);
    const Vec3 relative = submission::relativeDamping(p.va, p.vb, p.d), projected = projectedOnA(p);
    const Vec3 v = p.va - p.vb;
    const double rate = v.dot((p.xa - p.xb).normalized());
    EXPECT_LE(relative.dot(v), 0.0);
    EXPECT_LE(projected.dot(v), roundOff(p.d * v.squaredNorm()));
    EXPECT_NUMBER_NEAR(relative.dot(v), -p.d * v.squaredNorm(), roundOff(p.d * v.squaredNorm()));
    EXPECT_NUMBER_NEAR(projected.dot(v), -p.d * rate * rate, roundOff(p.d * v.squaredNorm()));
  }
}

TEST(PairLaws, ProjectedDampingHasNoTorque) {
  MUELLE_PROPERTY("projected damping acts along the spring: it does not change the angular momentum");
  Random random = testRandom();
  for (int i = 0; i < 4; ++i) {
    const Pair p = randomPair(random);
    const Vec3 force = projectedOnA(p);
    EXPECT_VECTOR_NEAR((p.xa - p.xb).cross(force).eval(), Vec3::Zero(), roundOff(forceScale(p) * (p.xa - p.xb).norm()));
    EXPECT_VECTOR_NEAR(force, oracleProjected(p), roundOff(forceScale(p)));
  }
}

TEST(PairLaws, NoFrameIsSpecial) {
  MUELLE_PROPERTY("turning, moving and speeding up both nodes together turns the force and changes nothing else");
  Random random = testRandom();
  for (int i = 0; i < 4; ++i) {
    const Pair p = randomPair(random);
    const muelle::Mat3 R = random.rotation();
    const Vec3 shift = random.vector3(3.0), boost = random.vector3(3.0);
    const Pair moved{R * p.xa + shift, R * p.xb + shift, R * p.va + boost, R * p.vb + boost, p.d};
    EXPECT_VECTOR_NEAR(submission::relativeDamping(moved.va, moved.vb, p.d),
                       Vec3(R * oracle::relativeDamping(p.va, p.vb, p.d)), roundOff(forceScale(moved)));
    EXPECT_VECTOR_NEAR(projectedOnA(moved), Vec3(R * oracleProjected(p)), roundOff(forceScale(moved)));
  }
}

TEST(PairLaws, ARigidMotionIsNotDampedByProjection) {
  MUELLE_PROPERTY(
      "a pair that moves and turns as one body feels no projected damping, but feels that of the relative velocity");
  Random random = testRandom();
  for (int i = 0; i < 3; ++i) {
    Pair p = randomPair(random);
    const Vec3 velocity = random.vector3(3.0), spin = random.vector3(3.0);
    p.va = velocity + spin.cross(p.xa);
    p.vb = velocity + spin.cross(p.xb);
    EXPECT_VECTOR_NEAR(projectedOnA(p), Vec3::Zero(), roundOff(forceScale(p)));
    EXPECT_VECTOR_NEAR(submission::relativeDamping(p.va, p.vb, p.d), Vec3(-p.d * spin.cross(p.xa - p.xb)),
                       roundOff(forceScale(p)));
  }
}

// ---- Motion ----------------------------------------------------------------------------------------------------

TEST(NodeMotion, AFallEndsAtASteadySpeed) {
  MUELLE_PROPERTY("a falling node with damping ends at the speed m g / d");
  const double m = 2.0, d = 5.0, rate = d / m;
  Scene scene;
  scene.nodes = {Node{{0, 0, 1}, Vec3::Zero(), m}, Node{{1, 0, 1}, Vec3::Zero(), m}};  // at rest length
  scene.g = 9.81;
  scene.duration = 4.0;
  const Trajectory trajectory = expectSameMotion(scene, studentNode(d), oracleNode(d));
  ASSERT_FALSE(trajectory.stop.stopped);
  // The method multiplies the distance to the final speed by 1 - h rate a step, where the exact solution has
  // exp(-h rate): the difference is at most rate h / (2 e) of the final speed, to leading order.
  const double finalSpeed = m * scene.g / d, tolerance = 1.1 * finalSpeed * rate * scene.h / (2.0 * std::numbers::e);
  for (const std::size_t i : {trajectory.t.size() / 8, trajectory.t.size() / 4, trajectory.t.size() - 1}) {
    const double speed = finalSpeed * (1.0 - std::exp(-rate * trajectory.t[i]));
    MUELLE_LABEL(fmt::format("velocity along z at t = {:.4g} s", trajectory.t[i]), "m/s");
    EXPECT_NUMBER_NEAR(trajectory.v[i][2], -speed, tolerance);
    EXPECT_NUMBER_NEAR(trajectory.v[i][5], -speed, tolerance);
  }
  EXPECT_NUMBER_NEAR(trajectory.last().v[2], -finalSpeed, finalSpeed * std::exp(-rate * scene.duration));
}

TEST(NodeMotion, ARotationFades) {
  MUELLE_PROPERTY("node damping slows a rotation at the rate d / m");
  const double m = 1.5, d = 0.6;
  const Scene scene = rotatingPair(m, m);
  const Trajectory trajectory = expectSameMotion(scene, studentNode(d), oracleNode(d));
  expectSlowedRotation(scene, trajectory, d / m);
  EXPECT_NUMBER_NEAR(lengthOf(trajectory.last()), 1.00054056875938777, lengthTolerance(scene));
}

TEST(NodeMotion, AVibrationFades) {
  MUELLE_PROPERTY("node damping makes a vibration of two equal nodes decay at the rate d / (2 m)");
  const double m = 1.5, d = 6.0;
  const Scene scene = vibratingPair(m, m);
  const Trajectory trajectory = expectSameMotion(scene, studentNode(d), oracleNode(d));
  expectDampedVibration(scene, trajectory, d / (2.0 * m));
}

TEST(RelativeMotion, AFallIsNotBraked) {
  MUELLE_PROPERTY("damping by relative velocity leaves the fall of the centre of mass alone");
  const Scene scene = tumblingFall();
  expectFreeFall(scene, expectSameMotion(scene, studentRelative(2.0), oracleRelative(2.0)));
}

TEST(RelativeMotion, ARotationFades) {
  MUELLE_PROPERTY("damping by relative velocity slows a rotation at the rate d / mu, mu the reduced mass");
  const double d = 0.3, mu = 0.75;
  const Scene scene = rotatingPair(1.0, 3.0);
  const Trajectory trajectory = expectSameMotion(scene, studentRelative(d), oracleRelative(d));
  expectSlowedRotation(scene, trajectory, d / mu);
  EXPECT_NUMBER_NEAR(lengthOf(trajectory.last()), 1.00054056875938777, lengthTolerance(scene));
}

TEST(RelativeMotion, AVibrationFades) {
  MUELLE_PROPERTY("damping by relative velocity makes a vibration decay at the rate d / (2 mu), mu the reduced mass");
  const double d = 3.0, mu = 0.75;
  const Scene scene = vibratingPair(1.0, 3.0);
  const Trajectory trajectory = expectSameMotion(scene, studentRelative(d), oracleRelative(d));
  expectDampedVibration(scene, trajectory, d / (2.0 * mu));
}

TEST(ProjectedMotion, AFallIsNotBraked) {
  MUELLE_PROPERTY("projected damping leaves the fall of the centre of mass alone");
  const Scene scene = tumblingFall();
  expectFreeFall(scene, expectSameMotion(scene, studentProjected(2.0), oracleProjected(2.0)));
}

TEST(ProjectedMotion, ARotationGoesOn) {
  MUELLE_PROPERTY("projected damping does not slow a rotation");
  const Scene scene = rotatingPair(1.0, 3.0);
  const Trajectory trajectory = expectSameMotion(scene, studentProjected(0.3), oracleProjected(0.3));
  ASSERT_FALSE(trajectory.stop.stopped);
  EXPECT_NUMBER_NEAR(angularMomentumZ(scene, trajectory.last()), 3.3075, roundOff(3.3075));
  EXPECT_NUMBER_NEAR(lengthOf(trajectory.last()), 1.05, lengthTolerance(scene));
}

TEST(ProjectedMotion, AVibrationFades) {
  MUELLE_PROPERTY("projected damping makes a vibration decay at the rate d / (2 mu), mu the reduced mass");
  const double d = 3.0, mu = 0.75;
  const Scene scene = vibratingPair(1.0, 3.0);
  const Trajectory trajectory = expectSameMotion(scene, studentProjected(d), oracleProjected(d));
  expectDampedVibration(scene, trajectory, d / (2.0 * mu));
}

TEST(ProjectedMotion, AVibrationFadesWhileTheRotationGoesOn) {
  MUELLE_PROPERTY("projected damping brings a rotating, vibrating pair to the circle of its angular momentum");
  const double d = 3.0;
  Scene scene;  // H07 "vibrate"
  scene.nodes = {Node{{0.9, 0, 0}, {0, 3.6, 0}, 1.0}, Node{{-0.3, 0, 0}, {0, -1.2, 0}, 3.0}};
  const Trajectory trajectory = expectSameMotion(scene, studentProjected(d), oracleProjected(d));
  ASSERT_FALSE(trajectory.stop.stopped);
  EXPECT_NUMBER_NEAR(angularMomentumZ(scene, trajectory.last()), 4.32, roundOff(4.32));
  // The method's velocity, half a step late, has a radial part r omega^2 h / 2 on the circle (omega = 4.95 rad/s),
  // which the damper opposes: the length is off by d r omega^2 h / 2 over the radial stiffness k + 3 mu omega^2 = 307
  // N/m, that is 0.13 m/s times h. What is left of the vibration, 0.12 m exp(-10), is 5e-6 m.
  EXPECT_NUMBER_NEAR(lengthOf(trajectory.last()), 1.07868002605827197, 0.14 * scene.h + 6e-6);
}
