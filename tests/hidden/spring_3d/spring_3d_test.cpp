#include "spring_3d.h"

#include "course/testing/expect.h"
#include "course/testing/random.h"
#include "grader/testing/ladders.h"
#include "grader/testing/of_use.h"
#include "grader/testing/plain_numbers.h"
#include "harness/function_system.h"
#include "harness/march.h"
#include "harness/symplectic_euler.h"

#include <fmt/format.h>
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
using muelle::VecX;
using muelle::grader::someTurn;

constexpr int caseCount = 12;

/// For what is about structure, not digits: single precision, 1e-7 of the numbers a force is made of, and difference
/// quotients do not break it.
constexpr double ofStructure = 1e-6;

/// Of three digits, as all numbers that a student may have to type.
double number(Random& random, double low, double high) { return muelle::threeDigits(random.number(low, high)); }
double positive(Random& random, double low, double high) { return muelle::threeDigits(random.positive(low, high)); }
Vec3 rounded(const Vec3& v) {
  return v.unaryExpr([](double each) { return muelle::threeDigits(each); });
}
Vec3 vector3(Random& random, double scale) { return rounded(random.vector3(scale)); }

/// A spring between a and b.
struct SpringCase {
  Vec3 xa, xb;
  double k, L0;
  /// Of the numbers that the force is made of [N]. Not of the positions: their difference is exact to round-off.
  double scale() const { return k * ((xa - xb).norm() + L0); }
};

/// Its length differs from L0 by 10 to 60 %, so that no mistake hides in a small number.
/// \param i the cases come in turn, stretched and compressed, so that every test sees both
SpringCase randomSpring(Random& random, int i) {
  SpringCase spring;
  spring.k = positive(random, 5.0, 500.0);
  spring.L0 = number(random, 0.4, 1.6);
  const double change = random.number(0.1, 0.6);
  const double L = spring.L0 * (i % 2 == 0 ? 1 + change : 1 - change);
  spring.xb = vector3(random, 2.0);
  spring.xa = rounded(spring.xb + L * random.direction());
  return spring;
}

/// The ends of the contract's ranges and their corners; the last lie far from the origin, and on one axis.
std::vector<SpringCase> corners() {
  const Vec3 a(0.37, -0.81, 0.56), b(-0.43, 0.62, 1.34);
  const Vec3 far(1000, -1000, 1000), there(731.4, -418.3, 893.7), beside(731.41, -418.29, 893.72);
  return {
      {a, b, 1e-3, 0},
      {b, a, 1e-3, 1000},
      {a, b, 1e9, 0},
      {b, a, 1e9, 1000},
      {a, b, 1e9, 0.66},
      {b, a, 1e-3, 3.1},
      {a, b, 73, 1000},
      {b, a, 0.037, 0},
      {far, -far, 1e9, 0},
      {far, -far, 310, 1000},
      {-far, far, 7.3, 0.4},
      {there, beside, 41, 0},
      {beside, there, 41, 0.78},
      {Vec3(0.41, 0, 0), Vec3(0, 0, 0), 41, 0.78},
      {Vec3(0, 0, 0), Vec3(0, 0.93, 0), 41, 0.78},
      {Vec3(0.2, 0.3, -0.61), Vec3(0.2, 0.3, 0.29), 41, 0},
  };
}

void expectMagnitude(const SpringCase& s) {
  EXPECT_NUMBER_NEAR(submission::springForceMagnitude(s.xa, s.xb, s.k, s.L0),
                     oracle::springForceMagnitude(s.xa, s.xb, s.k, s.L0), roundOff(s.scale()));
}

void expectDirection(const Vec3& xa, const Vec3& xb) {
  EXPECT_VECTOR_NEAR(submission::springDirection(xa, xb), oracle::springDirection(xa, xb), roundOff(1.0));
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
    for (const Attachment& spring : springs) sum += spring.k * ((x - spring.x).norm() + spring.L0) / m;
    return sum;
  }
};

NodeCase randomNode(Random& random, int springCount) {
  NodeCase node;
  node.x = vector3(random, 1.0);
  node.m = positive(random, 0.2, 5.0);
  node.g = number(random, 3.0, 20.0);
  for (int i = 0; i < springCount; ++i) {
    const SpringCase spring = randomSpring(random, i);
    node.springs.push_back({rounded(node.x + (spring.xb - spring.xa)), spring.k, spring.L0});
  }
  return node;
}

/// The ends of the contract's ranges and their corners: light and heavy, soft and hard, and a node at the height 0.
std::vector<NodeCase> nodeCorners() {
  const Vec3 a(0.37, -0.81, 0.56), b(-0.43, 0.62, 1.34), c(0.29, 0.47, -0.38), far(1000, -1000, 1000);
  return {
      {a, 1e-6, {{b, 1e-3, 0}, {c, 1e-3, 1000}}, 1000},
      {a, 1e6, {{c, 1e9, 0}, {b, 1e9, 1000}}, 0},
      {a, 1e-6, {{b, 37, 0.31}, {c, 410, 1.13}}, 8.37},
      {a, 1e6, {{c, 2.9e5, 0.31}, {b, 1e9, 1.13}}, 8.37},
      {far, 3.7e-4, {{-far, 7.3, 0}, {a, 0.037, 1000}, {c, 61, 0.7}}, 0},
      {b, 430, {{a, 1e-3, 0.83}, {c, 1e9, 0}, {far, 310, 2.9}}, 5.3},
      {Vec3(0.31, -0.23, 0), 0.43, {{b, 41, 0.77}, {c, 67, 0}}, 5.3},
      {Vec3(0, 0, 0), 0.43, {{b, 41, 0.77}}, 5.3},
      {c, 1e-6, {}, 1000},
      {far, 1e6, {}, 0},
  };
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
  const Vec3 xb(0.11, -0.23, 0.34);
  for (int cm = 0; cm <= 5; ++cm) {
    const double third = muelle::threeDigits(0.24 + 0.01 * cm);
    expectMagnitude({xb + third * Vec3(2, -1, 2), xb, 83.0, 0.72});
  }
}

TEST(Magnitude, HoldsForEverySpring) {
  MUELLE_PROPERTY("soft, hard, long springs and those of rest length 0 follow the same formula");
  for (const SpringCase& corner : corners()) expectMagnitude(corner);
}

TEST(Direction, PointsFromBToA) {
  MUELLE_PROPERTY("the direction is (xa - xb) / L");
  Random random = muelle::testRandom();
  for (int i = 0; i < caseCount; ++i) {
    const SpringCase s = randomSpring(random, i);
    expectDirection(s.xa, s.xb);
  }
}

TEST(Direction, HasLengthOneHoweverLongTheSpring) {
  MUELLE_PROPERTY("stretching a spring does not change its direction, which keeps the length 1");
  Random random = muelle::testRandom();
  const Vec3 along = vector3(random, 1.0), xb = vector3(random, 1.0);
  for (const double times : {0.23, 0.71, 1.9, 4.3, 51.0}) expectDirection(rounded(xb + times * along), xb);
}

TEST(Direction, HoldsForEverySpring) {
  MUELLE_PROPERTY("springs along an axis, far away or 2 km long have a direction of length 1");
  for (const SpringCase& corner : corners()) expectDirection(corner.xa, corner.xb);
}

// -------------------------------------------------------------------------------------------------------------- force
// Compared with the oracle everywhere, which may be given the student's own magnitude and direction.

TEST(HookeForce, FollowsHookesLaw) {
  MUELLE_PROPERTY("the force on a is -k (L - L0) (xa - xb) / L");
  Random random = muelle::testRandom();
  for (int i = 0; i < caseCount; ++i) expectForce(randomSpring(random, i));
}

TEST(HookeForce, VanishesAtTheRestLength) {
  MUELLE_PROPERTY("at L = L0 the force is 0; twice the deformation gives twice the force");
  const Vec3 xb(0.11, -0.23, 0.34);
  for (const double third : {0.17, 0.21, 0.25, 0.29, 0.33}) {
    expectForce({xb + third * Vec3(-1, 2, 2), xb, 83.0, 0.75});
  }
}

TEST(HookeForce, HoldsForEverySpring) {
  MUELLE_PROPERTY("soft, hard, long springs and those of rest length 0 follow the same law");
  for (const SpringCase& corner : corners()) expectForce(corner);
}

TEST(ThirdLaw, ExchangingTheNodesTurnsTheForceRound) {
  MUELLE_PROPERTY("the force on b, springForce(xb, xa, k, L0), is the opposite of the force on a");
  MUELLE_EXPECT_OF_USE(springForce);
  Random random = muelle::testRandom();
  std::vector<SpringCase> cases = corners();
  for (int i = 0; i < caseCount; ++i) cases.push_back(randomSpring(random, i));
  for (const SpringCase& s : cases) {
    const Vec3 onA = submission::springForce(s.xa, s.xb, s.k, s.L0);
    EXPECT_VECTOR_NEAR(submission::springForce(s.xb, s.xa, s.k, s.L0), -onA, ofStructure * s.scale());
  }
}

TEST(ThirdLaw, MomentaAreConserved) {
  MUELLE_PROPERTY("two free nodes on a spring keep their linear and angular momentum");
  const double ma = 1.3, mb = 2.9, k = 43.0, L0 = 0.9;
  const FunctionSystem system({ma, ma, ma, mb, mb, mb}, [&](double, In x, In, Out f) {
    node3(f, 0) = submission::springForce(node3(x, 0), node3(x, 1), k, L0);
    node3(f, 1) = submission::springForce(node3(x, 1), node3(x, 0), k, L0);
  });
  muelle::MarchOptions options;
  options.h = 5e-3;
  options.duration = 1.0;
  options.outputEvery = 10;
  const Trajectory run = muelle::march(
      system, {0.0, {1.17, 0.08, 0.31, -0.06, 0.13, 0.09}, {0.21, 1.47, -0.12, 0.17, -0.53, 0.41}, {}}, options);
  const auto linear = [&](std::size_t i, int node) -> Vec3 {
    return (node == 0 ? ma : mb) * node3(In(run.v[i]), node);
  };
  const auto angular = [&](std::size_t i, int node) -> Vec3 {
    return node3(In(run.x[i]), node).cross(linear(i, node));
  };
  double mostLinear = 0, mostAngular = 0;  // a wrong force may drive the nodes apart: rounding is that of all before
  for (std::size_t i = 0; i < run.t.size(); ++i) {
    // A step adds h (Fa + Fb) to the linear and h (xa - xb) x Fa to the angular momentum (x1 = x0 + h v1 adds nothing):
    // both are 0 but for rounding when the forces are opposite and central. Single precision loses 1e-7 of the force a
    // step; a force that is not central changes the angular momentum by a tenth.
    mostLinear = std::max(mostLinear, linear(i, 0).norm() + linear(i, 1).norm());
    mostAngular = std::max(mostAngular, angular(i, 0).norm() + angular(i, 1).norm());
    {
      MUELLE_LABEL(fmt::format("linear momentum of both nodes at t = {:.2f} s", run.t[i]), "kg m/s");
      EXPECT_VECTOR_NEAR(Vec3(linear(i, 0) + linear(i, 1)), Vec3(linear(0, 0) + linear(0, 1)),
                         10 * ofStructure * mostLinear);
    }
    MUELLE_LABEL(fmt::format("angular momentum of both nodes at t = {:.2f} s", run.t[i]), "kg m^2/s");
    EXPECT_VECTOR_NEAR(Vec3(angular(i, 0) + angular(i, 1)), Vec3(angular(0, 0) + angular(0, 1)),
                       10 * ofStructure * mostAngular);
  }
}

TEST(Equivariance, MovingBothNodesChangesNothing) {
  MUELLE_PROPERTY("the same translation of both nodes leaves the force as it is");
  MUELLE_EXPECT_OF_USE(springForce);
  Random random = muelle::testRandom();
  for (int i = 0; i < caseCount; ++i) {
    const SpringCase s = randomSpring(random, i);
    const Vec3 force = submission::springForce(s.xa, s.xb, s.k, s.L0);
    const Vec3 shift = vector3(random, i % 3 == 0 ? 900.0 : 5.0);
    EXPECT_VECTOR_NEAR(submission::springForce(s.xa + shift, s.xb + shift, s.k, s.L0), force, ofStructure * s.scale());
  }
}

TEST(Equivariance, TurningBothNodesTurnsTheForce) {
  MUELLE_PROPERTY("the same rotation of both nodes rotates the force with them");
  MUELLE_EXPECT_OF_USE(springForce);
  Random random = muelle::testRandom();
  for (int i = 0; i < caseCount; ++i) {
    const SpringCase s = randomSpring(random, i);
    const Vec3 force = submission::springForce(s.xa, s.xb, s.k, s.L0);
    // About no axis: exchanged axes and signs would let a sum of sizes pass for a length.
    const Mat3 rotation = someTurn(i);
    EXPECT_VECTOR_NEAR(submission::springForce(rotation * s.xa, rotation * s.xb, s.k, s.L0), Vec3(rotation * force),
                       ofStructure * s.scale());
  }
}

// --------------------------------------------------------------------------------------------------------------- edges
// An edge is lost by what is wrong there, not by what is wrong everywhere: a function that is right in general
// position must be right on the edge too; of another one the edge asks only what its own answers elsewhere imply.

namespace {

bool areNear(const VecX& a, const VecX& b, double tolerance) { return ((a - b).array().abs() <= tolerance).all(); }

bool magnitudeIsRight(Random random) {
  for (int i = 0; i < 4; ++i) {
    const SpringCase s = randomSpring(random, i);
    const double own = submission::springForceMagnitude(s.xa, s.xb, s.k, s.L0);
    if (!(std::abs(own - oracle::springForceMagnitude(s.xa, s.xb, s.k, s.L0)) <= roundOff(s.scale()))) return false;
  }
  return true;
}

bool accelerationIsRight(Random random) {
  for (int i = 0; i < 4; ++i) {
    const NodeCase c = randomNode(random, 1 + i);
    const Vec3 own = submission::nodeAcceleration(c.x, c.m, c.springs, c.g);
    if (!areNear(own, oracle::nodeAcceleration(c.x, c.m, c.springs, c.g), roundOff(c.scale()))) return false;
  }
  return true;
}

/// Without gravity: the acceleration is the same whatever the stiffness of the spring whose end is at the node, or the
/// same as with that spring at its rest length.
void expectOwnOnAnchor(NodeCase c, std::size_t coincident) {
  const auto own = [&] { return submission::nodeAcceleration(c.x, c.m, c.springs, 0.0); };
  Attachment& spring = c.springs[coincident];
  spring.x = c.x;
  const Vec3 answer = own();
  const double stiffness = std::exchange(spring.k, 1e-3);
  if (areNear(answer, own(), roundOff(c.scale()))) return;
  spring.k = stiffness;
  spring.x = c.x - spring.L0 * Vec3(0.36, -0.48, 0.8);
  MUELLE_LABEL("acceleration on an anchor, without gravity, against yours with that spring at its rest length",
               "m/s^2");
  EXPECT_VECTOR_NEAR(answer, own(), roundOff(c.scale()));
}

}  // namespace

TEST(ZeroLength, CoincidentNodesHaveNoDirection) {
  MUELLE_PROPERTY("when the nodes coincide, the direction is a zero vector");
  MUELLE_EXPECT_ANSWERS(springDirection);
  Random random = muelle::testRandom();
  for (const Vec3& x : {vector3(random, 2.0), vector3(random, 2.0), Vec3(0, 0, 0), Vec3(1000, -1000, 1000)}) {
    EXPECT_VECTOR_NEAR(submission::springDirection(x, x), Vec3::Zero(), roundOff(1.0));
  }
}

TEST(ZeroLength, CoincidentNodesFeelNoForce) {
  MUELLE_PROPERTY("when the nodes coincide, the force is a zero vector, whatever the rest length");
  MUELLE_EXPECT_ANSWERS(springForce);
  Random random = muelle::testRandom();
  for (const Vec3& x : {vector3(random, 2.0), vector3(random, 2.0), Vec3(0, 0, 0), Vec3(1000, -1000, 1000)}) {
    for (const double k : {1e-3, positive(random, 5.0, 500.0), 1e9}) {
      for (const double L0 : {0.0, number(random, 0.4, 1.6), 1000.0}) {
        EXPECT_VECTOR_NEAR(submission::springForce(x, x, k, L0), Vec3::Zero(), ofStructure * k * (1 + L0));
      }
    }
  }
}

TEST(ZeroLength, TheMagnitudeIsTheFormulaAsItIs) {
  MUELLE_PROPERTY("at L = 0 the magnitude is k L0, as the formula says");
  MUELLE_EXPECT_ANSWERS(springForceMagnitude);
  Random random = muelle::testRandom();
  const bool isRight = magnitudeIsRight(random);
  for (int i = 0; i < 6; ++i) {
    SpringCase s = randomSpring(random, i);
    s.xa = s.xb;
    if (isRight) {
      if (i >= 4) s.L0 = i == 4 ? 0.0 : 1000.0;
      expectMagnitude(s);
      continue;
    }
    // Wrong everywhere: at L = 0 still what it tends to, if it tends to something.
    const auto own = [&](double sixth) {
      return submission::springForceMagnitude(s.xb + sixth * Vec3(4, -2, 4), s.xb, s.k, s.L0);
    };
    const double near = own(1e-5), nearer = own(1e-6);
    if (!(std::abs(near - nearer) <= 0.01 * std::abs(near))) continue;
    MUELLE_LABEL("magnitude at L = 0, which follows from yours at L = 6e-6 m", "N");
    EXPECT_NUMBER_NEAR(own(0.0), nearer, 0.01 * std::abs(nearer));
  }
}

TEST(ZeroLength, ANodeOnAnAnchorFeelsTheOtherSpringsOnly) {
  MUELLE_PROPERTY("a node on the end of one spring is accelerated by the other springs and gravity alone");
  MUELLE_EXPECT_ANSWERS(nodeAcceleration);
  Random random = muelle::testRandom();
  const bool isRight = accelerationIsRight(random);
  for (std::size_t i = 0; i < 6; ++i) {
    NodeCase c = randomNode(random, 3);
    const std::size_t coincident = i % 3;
    if (!isRight) {
      expectOwnOnAnchor(c, coincident);
      continue;
    }
    c.springs[coincident].x = c.x;
    if (i >= 3) c.springs[coincident].L0 = 0.0;
    expectAcceleration(c);
  }
}

TEST(ZeroLength, ANodeOnTheEndsOfAllItsSpringsFallsFreely) {
  MUELLE_PROPERTY("a node on the end of its only spring, or of all its springs, falls freely");
  MUELLE_EXPECT_ANSWERS(nodeAcceleration);
  Random random = muelle::testRandom();
  if (!accelerationIsRight(random)) return;  // the expectations above are for those
  for (const int count : {1, 2, 40}) {
    NodeCase c = randomNode(random, count);
    for (Attachment& spring : c.springs) spring.x = c.x;
    expectAcceleration(c);
  }
}

namespace {

using OfOffset = std::function<VecX(const Vec3& r)>;

/// Where the other end of a short spring stands, and how long a third of it is there [m].
struct Place {
  Vec3 end;
  std::vector<double> thirds;
};

/// Along (1, -2, 2) or (-2, 1, 2), of length 3. Beside the origin positions as near as 1e-100 m are different points;
/// beside (1, 1, 1) those that differ by 2^-k are.
const Vec3 along[] = {{1, -2, 2}, {-1, 2, -2}, {-2, 1, 2}};
const Place places[] = {{Vec3(0, 0, 0), muelle::grader::lengthLadder(1e-100 / 3)},
                        {Vec3(1, 1, 1), muelle::grader::exactLengthLadder()}};

/// A function of a short spring, the student's and the right one, by the vector from the spring's other end.
struct ShortSpringCase {
  std::string what, unit;  ///< "force on a", "N"
  OfOffset own, right;
  std::function<double(double L)> scale;  ///< of the numbers that the answer is made of

  bool isRightElsewhere() const {
    for (const double third : {0.077, 0.103, 0.643}) {
      for (const Vec3& line : along) {
        if (!areNear(own(third * line), right(third * line), roundOff(scale(3 * third)))) return false;
      }
    }
    return true;
  }

  /// Relative to the numbers the answer is made of, however small they are.
  void expectRight(double third, const Vec3& line) const {
    MUELLE_LABEL(fmt::format("{} of a spring of {:.3g} m", what, 3 * third), unit);
    EXPECT_VECTOR_NEAR(own(third * line), right(third * line), roundOff(scale(3 * third)));
  }

  /// Short springs are alike: what is wrong in all of them is, like the right force, a power of their length, constant
  /// for most mistakes. Each answer follows from the one before to 20 %: from 3 mm on, 1 - L / L0 changes by 1 % at
  /// most, and a length that is softened or taken for 0 changes it by more than half from one rung to the next.
  void expectOwnLaw(const std::vector<double>& thirds, const Vec3& line) const {
    double before = 0.001;
    VecX answer = own(before * line);
    const double slope = std::round(std::log10(own(10 * before * line).norm() / answer.norm()));
    const double power = std::isfinite(slope) ? slope : 0.0;
    for (const double third : thirds) {
      if (third >= before) continue;
      const VecX expected = answer * std::pow(third / before, power);
      answer = own(third * line);
      MUELLE_LABEL(
          fmt::format("{} of a spring of {:.3g} m, which follows from yours of {:.3g} m", what, 3 * third, 3 * before),
          unit);
      EXPECT_VECTOR_NEAR(answer, expected, 0.2 * expected.cwiseAbs().maxCoeff());
      before = third;
    }
  }

  /// \param hasRestLength without one there is no law of short springs, but the force at every length
  void expectAllLengths(const std::vector<double>& thirds, bool hasRestLength) const {
    const bool isRight = isRightElsewhere();
    for (const Vec3& line : along) {
      if (!isRight && hasRestLength) expectOwnLaw(thirds, line);
      if (!isRight) continue;
      for (const double third : thirds) expectRight(third, line);
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
    makeCase(place.end, general).expectAllLengths(place.thirds, true);
    makeCase(place.end, ShortSprings{1e9, 0, 310, 0}).expectAllLengths(place.thirds, false);
  }
}

VecX oneNumber(double value) { return VecX::Constant(1, value); }

}  // namespace

TEST(ShortSpring, EveryPositiveLengthHasADirection) {
  MUELLE_PROPERTY("a spring of 1e-9 m, or of 1e-100 m, still has a direction of length 1");
  MUELLE_EXPECT_ANSWERS(springDirection);
  for (const Place& place : places) {
    const Vec3 end = place.end;
    const ShortSpringCase direction{
        "direction", "", [=](const Vec3& r) -> VecX { return submission::springDirection(end + r, end); },
        [=](const Vec3& r) -> VecX { return oracle::springDirection(end + r, end); }, [](double) { return 1.0; }};
    direction.expectAllLengths(place.thirds, true);
  }
}

TEST(ShortSpring, HasAMagnitude) {
  MUELLE_PROPERTY("the magnitude of a spring of 1e-9 m, or of 1e-100 m, is k (L0 - L)");
  MUELLE_EXPECT_ANSWERS(springForceMagnitude);
  expectShortSprings([](const Vec3& end, const ShortSprings& s) {
    return ShortSpringCase{
        "magnitude", "N",
        [=](const Vec3& r) { return oneNumber(submission::springForceMagnitude(end + r, end, s.k, s.L0)); },
        [=](const Vec3& r) { return oneNumber(oracle::springForceMagnitude(end + r, end, s.k, s.L0)); },
        [=](double L) { return s.k * (L + s.L0); }};
  });
}

TEST(ShortSpring, PushesItsNodesApart) {
  MUELLE_PROPERTY("a spring of 1e-9 m, or of 1e-100 m, still pushes its nodes apart with k (L0 - L)");
  MUELLE_EXPECT_ANSWERS(springForce);
  expectShortSprings([](const Vec3& end, const ShortSprings& s) {
    return ShortSpringCase{"force on a", "N",
                           [=](const Vec3& r) -> VecX { return submission::springForce(end + r, end, s.k, s.L0); },
                           [=](const Vec3& r) -> VecX { return oracle::springForce(end + r, end, s.k, s.L0); },
                           [=](double L) { return s.k * (L + s.L0); }};
  });
}

TEST(ShortSpring, PushesANode) {
  MUELLE_PROPERTY("a node that is 1e-9 m, or 1e-100 m, from the ends of its springs is still pushed by all of them");
  MUELLE_EXPECT_ANSWERS(nodeAcceleration);
  expectShortSprings([](const Vec3& end, const ShortSprings& s) {
    const double m = 0.43;
    const std::vector<Attachment> springs = {{end, s.k, s.L0}, {end, s.otherK, s.otherL0}};
    return ShortSpringCase{
        "acceleration without gravity", "m/s^2",
        [=](const Vec3& r) -> VecX { return submission::nodeAcceleration(end + r, m, springs, 0.0); },
        [=](const Vec3& r) -> VecX { return oracle::nodeAcceleration(end + r, m, springs, 0.0); },
        [=](double L) { return (s.k * (L + s.L0) + s.otherK * (L + s.otherL0)) / m; }};
  });
}

// ------------------------------------------------------------------------------------------------------- acceleration
// Compared with the oracle everywhere, which may be given the student's own force.

TEST(NodeAcceleration, AddsAllSpringsAndTheWeight) {
  MUELLE_PROPERTY("m a is the weight plus the forces of all springs");
  Random random = muelle::testRandom();
  for (int i = 0; i < caseCount; ++i) expectAcceleration(randomNode(random, 1 + i % 5));
}

TEST(NodeAcceleration, HoldsForAnyNumberOfSprings) {
  MUELLE_PROPERTY("a node may hang from no spring, from one, or from forty");
  Random random = muelle::testRandom();
  for (const int count : muelle::grader::countLadder) expectAcceleration(randomNode(random, count));
}

TEST(NodeAcceleration, HoldsForEverySpringAndMass) {
  MUELLE_PROPERTY("light and heavy nodes, soft and hard springs, no gravity and much follow the same law");
  for (const NodeCase& corner : nodeCorners()) expectAcceleration(corner);
}

TEST(NodeAcceleration, RestsWhereTheSpringsCarryItsWeight) {
  MUELLE_PROPERTY("a node in the middle below two equal springs rests when their vertical pull is its weight");
  const Vec3 x(0.12, -0.31, 0.43);
  for (const double s : {0.31, 0.37, 0.44, 0.53}) {
    // The springs go from x to x + (+-3 s, 0, 4 s) and have the length 5 s: each carries 4/5 of its tension.
    const double L0 = 4.0 * s, k = 62.5, m = 1.6, g = muelle::threeDigits(2 * k * s * 4.0 / 5.0 / m);
    expectAcceleration({x, m, {{x + Vec3(3 * s, 0, 4 * s), k, L0}, {x + Vec3(-3 * s, 0, 4 * s), k, L0}}, g});
  }
}

TEST(NodeAcceleration, AConicalPendulumIsPulledToItsAxis) {
  MUELLE_PROPERTY("a mass that circles below its anchor at 4 rad/s is accelerated towards the axis with 16 r");
  // Radius 0.8175 m, depth 0.613125 m, so L = 1.021875 m; the tension 130 (L - L0) = 21.255 N carries 1.3 kg at 9.81
  // m/s^2 and turns the mass with 17.004 N = m omega^2 r.
  const double m = 1.3, g = 9.81, radius = 0.8175, depth = 0.613125;
  const Vec3 anchor(0.2, -0.3, 0.4);
  for (int i = 0; i < 8; ++i) {
    const double angle = 0.3 + i * M_PI / 4;
    const Vec3 arm(radius * std::cos(angle), radius * std::sin(angle), 0);
    expectAcceleration({anchor + arm - Vec3(0, 0, depth), m, {{anchor, 130.0, 0.858375}}, g});
  }
}

// --------------------------------------------------------------------------------------------------------- simulation

namespace {

/// A pendulum on springs, released at rest, the first of them compressed: the path must stretch and compress it, or a
/// force that always attracts would pass for the right one.
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

  /// With the oracle's swing, which may be given the student's own force: then it may be thrown out, and stop early.
  void expectSameSwing() const {
    const Trajectory run = swing(submission::nodeAcceleration);
    const Trajectory reference = swing(oracle::nodeAcceleration);
    {
      MUELLE_LABEL("time at which the motion has no numbers any more", "s");
      ASSERT_NUMBER_NEAR(std::min(run.t.back(), reference.t.back()), reference.t.back(), 0.0);
    }
    double largest = 0;
    for (std::size_t i = 0; i < reference.t.size(); ++i) {
      const Vec3 expected = node3(In(reference.x[i]), 0);
      largest = std::max(largest, expected.norm());
      MUELLE_LABEL(fmt::format("position at t = {:.2f} s", run.t[i]), "m");
      // Same method, same steps: 1000 roundings of 1e-16 m, each of which grows at most like exp(omega t), with
      // omega^2 = (sum of k) / m = 44 / s^2: 1e-13 m * exp(13.3) = 6e-8 m. Single precision, which costs other
      // criteria, loses 1e-7 of 30 m/s^2; on these paths that is below 1e-4 m. A wrong term moves the mass by
      // centimetres.
      EXPECT_VECTOR_NEAR(node3(In(run.x[i]), 0), expected, 1e-4 * (1 + largest));
    }
  }
};

}  // namespace

TEST(ElasticPendulum, SwingsAndBouncesOnOneSpring) {
  MUELLE_PROPERTY("a mass on a spring follows the reference path");
  Pendulum{1.43, 8.37, {{Vec3(0.21, -0.13, 0.32), 61.0, 1.03}}, Vec3(0.83, 0.22, -0.17)}.expectSameSwing();
}

TEST(ElasticPendulum, SwingsBetweenTwoSprings) {
  MUELLE_PROPERTY("a mass on two springs follows the reference path");
  Pendulum{1.07,
           8.37,
           {{Vec3(-0.83, 0.07, 0.41), 16.0, 1.63}, {Vec3(0.94, 0.12, 0.53), 27.0, 0.83}},
           Vec3(0.23, 0.42, -0.61)}
      .expectSameSwing();
}
