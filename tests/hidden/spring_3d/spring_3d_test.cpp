#include "spring_3d.h"

#include "course/testing/expect.h"
#include "course/testing/random.h"
#include "harness/function_system.h"
#include "harness/march.h"
#include "harness/symplectic_euler.h"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

namespace {

using muelle::FunctionSystem;
using muelle::In;
using muelle::Mat3;
using muelle::node3;
using muelle::Out;
using muelle::Random;
using muelle::roundOff;
using muelle::Trajectory;

constexpr int caseCount = 12;

/// A spring whose length differs from L0 by 10 to 60 %, so that no mistake hides in a small number.
struct SpringCase {
  Vec3 xa, xb;
  double k, L0;
  /// Of the numbers that the force is made of [N].
  double scale() const { return k * (xa.norm() + xb.norm() + L0); }
};

/// \param i the cases come in turn, stretched and compressed, so that every test sees both
SpringCase randomSpring(Random& random, int i) {
  SpringCase spring;
  spring.k = random.positive(5.0, 500.0);
  spring.L0 = random.number(0.4, 1.6);
  const double change = random.number(0.1, 0.6);
  const double L = spring.L0 * (i % 2 == 0 ? 1 + change : 1 - change);
  spring.xb = random.vector3(2.0);
  spring.xa = spring.xb + L * random.direction();
  return spring;
}

void expectMagnitude(const SpringCase& s) {
  EXPECT_NUMBER_NEAR(submission::springForceMagnitude(s.xa, s.xb, s.k, s.L0),
                     oracle::springForceMagnitude(s.xa, s.xb, s.k, s.L0), roundOff(s.scale()));
}

void expectDirection(const SpringCase& s) {
  EXPECT_VECTOR_NEAR(submission::springDirection(s.xa, s.xb), oracle::springDirection(s.xa, s.xb), roundOff(1.0));
}

void expectForce(const SpringCase& s) {
  EXPECT_VECTOR_NEAR(submission::springForce(s.xa, s.xb, s.k, s.L0), oracle::springForce(s.xa, s.xb, s.k, s.L0),
                     roundOff(s.scale()));
}

struct NodeCase {
  Vec3 x;
  double m;
  std::vector<Attachment> springs;
  double g;
  /// Of the numbers that the acceleration is made of [m/s^2].
  double scale() const {
    double sum = g;
    for (const Attachment& spring : springs) sum += spring.k * (x.norm() + spring.x.norm() + spring.L0) / m;
    return sum;
  }
};

NodeCase randomNode(Random& random, int springCount) {
  NodeCase node;
  node.x = random.vector3(1.0);
  node.m = random.positive(0.2, 5.0);
  node.g = random.number(1.0, 20.0);
  for (int i = 0; i < springCount; ++i) {
    const SpringCase spring = randomSpring(random, i);
    node.springs.push_back({node.x + (spring.xb - spring.xa), spring.k, spring.L0});
  }
  return node;
}

void expectAcceleration(const NodeCase& c) {
  EXPECT_VECTOR_NEAR(submission::nodeAcceleration(c.x, c.m, c.springs, c.g),
                     oracle::nodeAcceleration(c.x, c.m, c.springs, c.g), roundOff(c.scale()));
}

}  // namespace

// ------------------------------------------------------------------------------------------- magnitude and direction

TEST(Magnitude, IsMinusStiffnessTimesDeformation) {
  MUELLE_PROPERTY("the magnitude is -k (L - L0): negative when stretched, positive when compressed");
  Random random = muelle::testRandom();
  for (int i = 0; i < caseCount; ++i) expectMagnitude(randomSpring(random, i));
}

TEST(Magnitude, IsZeroAtTheRestLength) {
  MUELLE_PROPERTY("at L = L0 the magnitude is 0, and every further 1 cm of stretch takes k times 1 cm away");
  const double k = 80.0, L0 = 0.7;
  for (int cm = 0; cm <= 5; ++cm) {
    const double L = L0 + 0.01 * cm;
    const Vec3 xb(0.1, -0.2, 0.3), along(2.0 / 3, -1.0 / 3, 2.0 / 3);
    EXPECT_NUMBER_NEAR(submission::springForceMagnitude(xb + L * along, xb, k, L0), -k * 0.01 * cm, roundOff(k));
  }
}

TEST(Direction, PointsFromBToA) {
  MUELLE_PROPERTY("the direction is (xa - xb) / L");
  Random random = muelle::testRandom();
  for (int i = 0; i < caseCount; ++i) expectDirection(randomSpring(random, i));
}

TEST(Direction, HasLengthOneHoweverLongTheSpring) {
  MUELLE_PROPERTY("stretching a spring does not change its direction, which keeps the length 1");
  Random random = muelle::testRandom();
  const Vec3 along = random.direction(), xb = random.vector3(1.0);
  for (const double L : {0.25, 0.5, 2.0, 4.0, 50.0}) {
    EXPECT_VECTOR_NEAR(submission::springDirection(xb + L * along, xb), along, roundOff(1.0));
  }
}

// -------------------------------------------------------------------------------------------------------------- force

TEST(HookeForce, FollowsHookesLaw) {
  MUELLE_PROPERTY("the force on a is -k (L - L0) (xa - xb) / L");
  Random random = muelle::testRandom();
  for (int i = 0; i < caseCount; ++i) expectForce(randomSpring(random, i));
}

TEST(HookeForce, VanishesAtTheRestLength) {
  MUELLE_PROPERTY("at L = L0 the force is 0; twice the deformation gives twice the force");
  Random random = muelle::testRandom();
  for (int i = 0; i < 4; ++i) {
    const Vec3 along = random.direction(), xb = random.vector3(1.0);
    const double k = random.positive(5.0, 500.0), L0 = random.number(0.4, 1.6);
    for (const double stretch : {-0.2, -0.1, 0.0, 0.1, 0.2}) {
      EXPECT_VECTOR_NEAR(submission::springForce(xb + (L0 + stretch) * along, xb, k, L0), -k * stretch * along,
                         roundOff(k * 4));
    }
  }
}

TEST(ThirdLaw, ExchangingTheNodesTurnsTheForceRound) {
  MUELLE_PROPERTY("the force on b, springForce(xb, xa, k, L0), is the opposite of the force on a");
  Random random = muelle::testRandom();
  for (int i = 0; i < caseCount; ++i) {
    const SpringCase s = randomSpring(random, i);
    const Vec3 onA = submission::springForce(s.xa, s.xb, s.k, s.L0);
    EXPECT_VECTOR_NEAR(submission::springForce(s.xb, s.xa, s.k, s.L0), -onA, roundOff(s.scale()));
    expectForce(s);
  }
}

TEST(ThirdLaw, MomentaAreConserved) {
  MUELLE_PROPERTY("two free nodes on a spring keep their linear and angular momentum");
  const double ma = 1.0, mb = 3.0, k = 40.0, L0 = 1.0;
  const auto fly = [&](auto&& force) {
    const FunctionSystem system({ma, ma, ma, mb, mb, mb}, [&](double, In x, In, Out f) {
      node3(f, 0) = force(node3(x, 0), node3(x, 1), k, L0);
      node3(f, 1) = force(node3(x, 1), node3(x, 0), k, L0);
    });
    muelle::MarchOptions options;
    options.h = 5e-3;
    options.duration = 1.0;
    options.outputEvery = 10;
    return muelle::march(system, {0.0, {1.2, 0, 0.3, 0, 0, 0}, {0.2, 1.5, 0, 0, -0.5, 0.4}, {}}, options);
  };
  const auto linear = [&](const Trajectory& run, std::size_t i) -> Vec3 {
    return ma * node3(In(run.v[i]), 0) + mb * node3(In(run.v[i]), 1);
  };
  const auto angular = [&](const Trajectory& run, std::size_t i) -> Vec3 {
    return ma * node3(In(run.x[i]), 0).cross(node3(In(run.v[i]), 0)) +
           mb * node3(In(run.x[i]), 1).cross(node3(In(run.v[i]), 1));
  };
  const Trajectory run = fly(submission::springForce);
  const Trajectory reference = fly(oracle::springForce);
  ASSERT_EQ(run.t.size(), reference.t.size()) << "the simulation stopped early: " << run.stop.message;
  for (std::size_t i = 0; i < run.t.size(); ++i) {
    // A step adds h (Fa + Fb) to the linear and h (xa - xb) x Fa to the angular momentum (x1 = x0 + h v1 adds nothing):
    // both are 0 but for rounding when the forces are opposite and central.
    EXPECT_VECTOR_NEAR(linear(run, i), linear(reference, 0), roundOff(10.0));
    EXPECT_VECTOR_NEAR(angular(run, i), angular(reference, 0), roundOff(10.0));
    EXPECT_VECTOR_NEAR(node3(In(run.x[i]), 0), node3(In(reference.x[i]), 0), 1e-7);  // see ElasticPendulum
  }
}

TEST(Equivariance, MovingBothNodesChangesNothing) {
  MUELLE_PROPERTY("the same translation of both nodes leaves the force as it is");
  Random random = muelle::testRandom();
  for (int i = 0; i < caseCount; ++i) {
    SpringCase s = randomSpring(random, i);
    const Vec3 force = submission::springForce(s.xa, s.xb, s.k, s.L0);
    const Vec3 shift = random.vector3(5.0);
    s.xa += shift;
    s.xb += shift;
    EXPECT_VECTOR_NEAR(submission::springForce(s.xa, s.xb, s.k, s.L0), force, roundOff(s.scale()));
    expectForce(s);
  }
}

TEST(Equivariance, TurningBothNodesTurnsTheForce) {
  MUELLE_PROPERTY("the same rotation of both nodes rotates the force with them");
  Random random = muelle::testRandom();
  for (int i = 0; i < caseCount; ++i) {
    SpringCase s = randomSpring(random, i);
    const Vec3 force = submission::springForce(s.xa, s.xb, s.k, s.L0);
    const Mat3 rotation = random.rotation();
    s.xa = rotation * s.xa;
    s.xb = rotation * s.xb;
    EXPECT_VECTOR_NEAR(submission::springForce(s.xa, s.xb, s.k, s.L0), rotation * force, roundOff(s.scale()));
    expectForce(s);
  }
}

// --------------------------------------------------------------------------------------------------------------- edges

TEST(ZeroLength, CoincidentNodesHaveNoDirectionAndNoForce) {
  MUELLE_PROPERTY("when the nodes coincide, direction and force are zero vectors, whatever the rest length");
  Random random = muelle::testRandom();
  for (int i = 0; i < 4; ++i) {
    SpringCase s = randomSpring(random, i);
    expectDirection(s);  // beside it there is a direction and a force
    expectForce(s);
    s.xa = s.xb;
    for (const double L0 : {s.L0, 0.0}) {
      EXPECT_VECTOR_NEAR(submission::springDirection(s.xa, s.xb), Vec3::Zero(), roundOff(1.0));
      EXPECT_VECTOR_NEAR(submission::springForce(s.xa, s.xb, s.k, L0), Vec3::Zero(), roundOff(s.k));
    }
  }
}

TEST(ZeroLength, TheMagnitudeIsTheFormulaAsItIs) {
  MUELLE_PROPERTY("at L = 0 the magnitude is k L0");
  Random random = muelle::testRandom();
  for (int i = 0; i < 4; ++i) {
    SpringCase s = randomSpring(random, i);
    expectMagnitude(s);
    s.xa = s.xb;
    expectMagnitude(s);
  }
}

TEST(ZeroLength, ANodeOnAnAnchorFeelsTheOtherSpringsOnly) {
  MUELLE_PROPERTY("a node on the end of one spring is accelerated by the other springs alone");
  Random random = muelle::testRandom();
  for (int i = 0; i < 6; ++i) {
    NodeCase node = randomNode(random, 3);
    node.g = 0.0;  // leaves the springs alone: gravity has its own criterion
    node.springs[static_cast<std::size_t>(i % 3)].x = node.x;
    expectAcceleration(node);
  }
}

TEST(ZeroLength, ASpringWithoutRestLengthPullsAllTheWay) {
  MUELLE_PROPERTY("with L0 = 0 the force is -k (xa - xb): it fades to a zero vector at L = 0");
  Random random = muelle::testRandom();
  const double k = 30.0;
  const Vec3 along = random.direction(), xb = random.vector3(1.0);
  for (const double L : {0.0, 0.25, 0.5, 1.0}) {
    EXPECT_VECTOR_NEAR(submission::springForce(xb + L * along, xb, k, 0.0), -k * L * along, roundOff(k * 3));
  }
}

TEST(ShortSpring, EveryPositiveLengthHasADirection) {
  MUELLE_PROPERTY(
      "a spring of 1e-9 m, or of 1e-100 m, still has a direction and pushes its nodes apart with k (L0 - L)");
  Random random = muelle::testRandom();
  for (const double L : {3e-3,  3e-4,  3e-5,  3e-6,  3e-7,  3e-8,  3e-9,  3e-10, 3e-11, 3e-12, 3e-13, 3e-14,
                         3e-15, 3e-16, 3e-17, 3e-18, 3e-21, 1e-25, 1e-35, 1e-45, 1e-60, 1e-80, 1e-100}) {
    // b stands at 0: beside it, positions so near to each other are different numbers.
    const SpringCase s{L * random.direction(), Vec3::Zero(), random.positive(5.0, 500.0), random.number(0.4, 1.6)};
    expectDirection(s);
    expectForce(s);
  }
  for (int i = 0; i < 8; ++i) {  // longer ones too, so that a mistake that is not about short springs keeps its name
    const SpringCase s = randomSpring(random, i);
    expectDirection(s);
    expectForce(s);
  }
}

// ------------------------------------------------------------------------------------------------------- acceleration

TEST(NodeAcceleration, AddsAllSpringsAndTheWeight) {
  MUELLE_PROPERTY("m a is the weight plus the forces of all springs");
  Random random = muelle::testRandom();
  for (int i = 0; i < caseCount; ++i) expectAcceleration(randomNode(random, 1 + i % 5));
}

TEST(NodeAcceleration, FallsFreelyWithoutSprings) {
  MUELLE_PROPERTY("without springs the acceleration is (0, 0, -g), whatever the mass");
  Random random = muelle::testRandom();
  for (int i = 0; i < 4; ++i) {
    const NodeCase node = randomNode(random, 0);
    EXPECT_VECTOR_NEAR(submission::nodeAcceleration(node.x, node.m, {}, node.g), Vec3(0, 0, -node.g), roundOff(node.g));
  }
}

TEST(NodeAcceleration, RestsWhereTheSpringsCarryItsWeight) {
  MUELLE_PROPERTY("a node in the middle below two equal springs rests when their vertical pull is its weight");
  Random random = muelle::testRandom();
  for (int i = 0; i < 4; ++i) {
    // The springs go from (+-3 s, 0, 4 s) to the origin and have the length 5 s: each carries 4/5 of its tension.
    const double s = random.number(0.3, 0.6), L0 = 4.0 * s, k = random.positive(20.0, 100.0),
                 m = random.number(0.5, 2.0);
    const double g = 2 * k * s * 4.0 / 5.0 / m;
    const std::vector<Attachment> springs = {{Vec3(3 * s, 0, 4 * s), k, L0}, {Vec3(-3 * s, 0, 4 * s), k, L0}};
    EXPECT_VECTOR_NEAR(submission::nodeAcceleration(Vec3::Zero(), m, springs, g), Vec3::Zero(), roundOff(20 * k / m));
  }
}

TEST(NodeAcceleration, AConicalPendulumIsPulledToItsAxis) {
  MUELLE_PROPERTY("a mass that circles below its anchor at 4 rad/s is accelerated towards the axis with 16 r");
  // Radius 0.8175 m, depth 0.613125 m, so L = 1.021875 m; the tension 100 (L - L0) = 16.35 N carries 9.81 N and turns
  // the mass with 13.08 N = m omega^2 r.
  const double m = 1.0, g = 9.81, radius = 0.8175, depth = 0.613125, omega = 4.0;
  const std::vector<Attachment> springs = {{Vec3::Zero(), 100.0, 0.858375}};
  for (int i = 0; i < 8; ++i) {
    const double angle = 0.3 + i * M_PI / 4;
    const Vec3 arm(radius * std::cos(angle), radius * std::sin(angle), 0);
    EXPECT_VECTOR_NEAR(submission::nodeAcceleration(arm - Vec3(0, 0, depth), m, springs, g), -omega * omega * arm,
                       roundOff(200.0));
  }
}

// --------------------------------------------------------------------------------------------------------- simulation

namespace {

/// A pendulum on one or two springs, released at rest, the first of them compressed: the path must stretch and
/// compress it, or a force that always attracts would pass for the right one.
struct Pendulum {
  double m, g;
  std::vector<Attachment> springs;
  Vec3 start;

  template <class Acceleration>
  Trajectory swing(const Acceleration& acceleration) const {
    const FunctionSystem system(
        {m, m, m}, [&](double, In x, In, Out f) { node3(f, 0) = m * acceleration(node3(x, 0), m, springs, g); });
    muelle::MarchOptions options;
    options.h = 2e-3;
    options.duration = 2.0;
    options.outputEvery = 5;
    return muelle::march(system, {0.0, {start[0], start[1], start[2]}, {0, 0, 0}, {}}, options);
  }

  double energy(const Trajectory& run, std::size_t i) const {
    const Vec3 x = node3(In(run.x[i]), 0), v = node3(In(run.v[i]), 0);
    double sum = m * v.squaredNorm() / 2 + m * g * x[2];
    for (const Attachment& spring : springs) sum += spring.k * std::pow((x - spring.x).norm() - spring.L0, 2) / 2;
    return sum;
  }

  void expectSameSwing() const {
    const Trajectory run = swing(submission::nodeAcceleration);
    const Trajectory reference = swing(oracle::nodeAcceleration);
    ASSERT_EQ(run.t.size(), reference.t.size()) << "the simulation stopped early: " << run.stop.message;
    double methodError = 0;  // of symplectic Euler: of order h, and the same for everyone
    for (std::size_t i = 0; i < run.t.size(); ++i) {
      methodError = std::max(methodError, std::abs(energy(reference, i) - energy(reference, 0)));
    }
    for (std::size_t i = 0; i < run.t.size(); ++i) {
      // Same method, same steps: 1000 roundings of 1e-16 m, each of which grows at most like exp(omega t), with
      // omega^2 = (sum of k) / m = 40 / s^2: 1e-13 m * exp(12.7) = 3e-8 m. Energies: times the forces, below 100 N.
      EXPECT_VECTOR_NEAR(node3(In(run.x[i]), 0), node3(In(reference.x[i]), 0), 1e-7);
      EXPECT_NUMBER_NEAR(energy(run, i), energy(reference, 0), methodError + 1e-5);
    }
  }
};

}  // namespace

TEST(ElasticPendulum, SwingsAndBouncesOnOneSpring) {
  MUELLE_PROPERTY("a mass on a spring follows the reference path and keeps its energy");
  Pendulum{1.5, 9.81, {{Vec3(0.2, -0.1, 0.3), 60.0, 1.0}}, Vec3(0.8, 0.2, -0.15)}.expectSameSwing();
}

TEST(ElasticPendulum, SwingsBetweenTwoSprings) {
  MUELLE_PROPERTY("a mass on two springs follows the reference path and keeps its energy");
  Pendulum{1.0, 9.81, {{Vec3(-0.8, 0, 0.4), 15.0, 1.6}, {Vec3(0.9, 0.1, 0.5), 25.0, 0.8}}, Vec3(0.2, 0.4, -0.6)}
      .expectSameSwing();
}
