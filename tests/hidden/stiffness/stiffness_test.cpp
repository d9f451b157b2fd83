#include "stiffness.h"

#include "course/testing/expect.h"
#include "course/testing/random.h"
#include "engine/integrators/catalogue.h"
#include "engine/model/model_system.h"
#include "engine/solve/dense.h"
#include "grader/testing/ladders.h"
#include "grader/testing/of_use.h"
#include "grader/testing/plain_numbers.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <limits>

using muelle::MatX;
using muelle::Random;
using muelle::testRandom;
using muelle::threeDigits;
using muelle::grader::countLadder;
using muelle::grader::exactLengthLadder;
using muelle::grader::lengthLadder;
using muelle::grader::stiffnessLadder;
using muelle::grader::tidy;

namespace {

using Springs = std::vector<Spring>;

constexpr double shortest = 1e-100;     // [m], of the contract
constexpr double longestRest = 1000.0;  // [m], of the contract

/// A tolerance for values: some 60 roundings of 1.1e-16 in any order of the sums, with lengths by any formula, are
/// 7e-15 of the numbers involved; the best central difference is off by 4e-11, single precision by 6e-8.
double inRounding(double scale) { return 1e-13 * scale; }

/// A tolerance for laws, which are about structure and not about digits: a derivative by differences, or single
/// precision, breaks none of them. It loses the criterion of its values.
double inStructure(double scale) { return 1e-5 * scale; }

double sizeOf(const VecX& numbers) { return numbers.size() == 0 ? 0.0 : numbers.cwiseAbs().maxCoeff(); }

// --- one spring -----------------------------------------------------------------------------------------------------

struct One {
  Vec3 xa, xb;
  double k, L0;

  double length() const { return (xa - xb).stableNorm(); }
  Vec3 direction() const { return (xa - xb) / length(); }
  /// A unit vector at right angles to the spring.
  Vec3 across() const { return direction().unitOrthogonal(); }
  /// What its stiffness across is along: 1 at L0 = 0, 0 at rest, negative when compressed.
  double tension() const { return 1 - L0 / length(); }
  double scale() const { return k * (1 + L0 / length()); }
  Mat6 own() const { return submission::springHessian(xa, xb, k, L0); }
  Mat3 ownBlock() const { return own().topLeftCorner<3, 3>(); }
};

/// Stretched and compressed in turn, by a seventh at least, in no plane of the axes.
One anySpring(Random& random, int turn) {
  for (;;) {
    One s{tidy(Vec3(random.vector3(1.0) + Vec3(0.7, -0.9, 1.1))),
          tidy(Vec3(random.vector3(1.0) + Vec3(0.3, -0.2, 0.6))), threeDigits(random.positive(20.0, 150.0)), 0};
    const Vec3 r = s.xa - s.xb;
    if (s.length() < 0.4 || r.cwiseAbs().minCoeff() < 0.1) continue;
    s.L0 = tidy(s.length() * (turn % 2 == 0 ? random.number(0.3, 0.85) : random.number(1.15, 1.9)));
    return s;
  }
}

std::vector<One> someSprings(Random& random) {
  std::vector<One> springs;
  for (int turn = 0; turn < 8; ++turn) springs.push_back(anySpring(random, turn));
  for (int turn = 0; turn < 2; ++turn) {  // far from the origin
    One s = anySpring(random, turn);
    s.xa = tidy(Vec3(s.xa + Vec3(731.4, -612.9, 548.3)));
    s.xb = tidy(Vec3(s.xb + Vec3(731.4, -612.9, 548.3)));
    springs.push_back(s);
  }
  return springs;
}

/// Along each axis, in either order.
std::vector<One> alignedSprings() {
  std::vector<One> springs;
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3 a(0.3, -0.7, 0.4), b = a + 1.25 * Vec3::Unit(axis);
    springs.push_back({a, b, 37, 0.83});
    springs.push_back({b, a, 37, 1.71});
  }
  return springs;
}

/// Every stiffness with every rest length, the ends of the contract among them, short springs and long ones.
std::vector<One> springsOfTheWholeRange() {
  std::vector<One> springs;
  for (const double k : stiffnessLadder) {
    for (const double L0 : {0.0, 0.043, 1.7, longestRest}) {
      for (const double size : {0.13, 7.0, 900.0}) {
        springs.push_back({size * Vec3(-0.41, 0.23, 0.17), size * Vec3(0.37, 1, -0.29), k, L0});
      }
    }
  }
  return springs;
}

void expectHessian(const One& s) {
  EXPECT_MATRIX_NEAR(submission::springHessian(s.xa, s.xb, s.k, s.L0), oracle::springHessian(s.xa, s.xb, s.k, s.L0),
                     inRounding(s.scale()));
}

/// \param d a displacement of both nodes (a, b) [m]
double energyOf(const One& s, const Eigen::Matrix<double, 6, 1>& d) {
  const double stretch = (s.xa + d.head<3>() - s.xb - d.tail<3>()).norm() - s.L0;
  return 0.5 * s.k * stretch * stretch;
}

// --- nets -----------------------------------------------------------------------------------------------------------

/// Nodes and what joins them.
struct Net {
  VecX x;
  Springs springs;

  int nodes() const { return static_cast<int>(x.size() / 3); }
  Vec3 node(int i) const { return x.segment<3>(3 * i); }
  double length(const Spring& s) const { return (node(s.a) - node(s.b)).stableNorm(); }
  /// The sums of the sizes of all forces and Hessians [N] and [N/m].
  double forceScale() const {
    double sum = 0;
    for (const Spring& s : springs) sum += s.k * (length(s) + s.L0);
    return sum;
  }
  double stiffnessScale() const {
    double sum = 0;
    for (const Spring& s : springs) sum += s.k * (1 + (length(s) > 0 ? s.L0 / length(s) : 0));
    return sum;
  }
};

/// Nodes in general position, no two nearer than 0.3 m.
VecX someNodes(Random& random, int count) {
  const double size = count < 8 ? 1.2 : 2.7;
  VecX x(3 * count);
  for (int i = 0; i < count;) {
    const Vec3 here = tidy(Vec3(random.vector3(size) + Vec3(0.4, -0.7, 0.3)));
    bool isApart = true;
    for (int j = 0; j < i; ++j) isApart = isApart && (here - x.segment<3>(3 * j)).norm() > 0.3;
    if (isApart) x.segment<3>(3 * i++) = here;
  }
  return x;
}

enum class Strain { Both, Stretched };

/// Springs between any two of so many nodes, either of which may be the first; two may join the same. Stretched and
/// compressed in turn.
Springs springsBetween(Random& random, const VecX& x, int nodes, int count, Strain strain) {
  Springs springs;
  for (int i = 0; i < count; ++i) {
    const int a = random.integer(0, nodes - 1), b = (a + random.integer(1, nodes - 1)) % nodes;
    const double L = (x.segment<3>(3 * a) - x.segment<3>(3 * b)).norm();
    const bool isLonger = i % 2 == 0 || strain == Strain::Stretched;
    springs.push_back({a, b, threeDigits(random.positive(20.0, 150.0)),
                       threeDigits(L * (isLonger ? random.number(0.4, 0.85) : random.number(1.15, 1.6)))});
  }
  return springs;
}

/// Its last node has no spring.
Net someNet(Random& random, int springs, Strain strain = Strain::Both) {
  const int joined = 2 + springs / 2;
  const VecX x = someNodes(random, std::min(joined, 9) + 1);
  return {x, springsBetween(random, x, std::min(joined, 9), springs, strain)};
}

std::vector<Net> someNets(Random& random) {
  std::vector<Net> nets;
  for (const int springs : {1, 1, 2, 3, 5, 7}) nets.push_back(someNet(random, springs));
  return nets;
}

/// No node but one, none to forty springs, thirty nodes, the ends of the stiffnesses and rest lengths, and springs that
/// join the same nodes.
std::vector<Net> netsOfTheWholeRange(Random& random) {
  std::vector<Net> nets = {{Vec3(0.3, -0.7, 0.2), {}}};
  for (const int count : countLadder) nets.push_back(someNet(random, count));
  Net large{someNodes(random, 30), {}};
  large.springs = springsBetween(random, large.x, 30, 40, Strain::Both);
  nets.push_back(large);
  VecX x(9);
  x << 0.3, -0.7, 0.2, -0.4, 0.6, 1.1, 0.9, 0.1, -0.8;
  for (const double k : stiffnessLadder) {
    for (const double L0 : {0.0, 1.3, longestRest}) nets.push_back({x, {{1, 0, k, L0}, {1, 2, k, L0}}});
  }
  nets.push_back({x, {{0, 2, 31, 0.4}, {0, 2, 73, 2.9}, {2, 0, 47, 1.1}}});
  return nets;
}

void expectForce(const Net& net) {
  EXPECT_VECTOR_NEAR(submission::elasticForce(net.x, net.springs), oracle::elasticForce(net.x, net.springs),
                     inRounding(net.forceScale()));
}

void expectAssembled(const Net& net) {
  const MatX expected = oracle::assembleHessian(net.x, net.springs);
  MUELLE_LABEL("assembleHessian", "N/m");
  EXPECT_MATRIX_NEAR(MatX(submission::assembleHessian(net.x, net.springs)), expected, inRounding(net.stiffnessScale()));
}

}  // namespace

// --- SpringHessian --------------------------------------------------------------------------------------------------

TEST(SpringHessian, IsTheSecondDerivativeOfTheEnergy) {
  MUELLE_PROPERTY("the matrix has the second derivatives of 1/2 k (L - L0)^2 by the six coordinates of a and b");
  Random random = testRandom();
  for (const One& s : someSprings(random)) expectHessian(s);
  for (const One& s : alignedSprings()) expectHessian(s);
}

TEST(SpringHessian, HoldsForEveryStiffnessAndLength) {
  MUELLE_PROPERTY("the Hessian is right for any stiffness, any rest length, 0 too, and any length of the spring");
  for (const One& s : springsOfTheWholeRange()) expectHessian(s);
}

TEST(SpringHessian, BendsTheEnergy) {
  MUELLE_PROPERTY("d . K d is how the energy bends along d: (E(x + d) - 2 E(x) + E(x - d)) for a small d");
  Random random = testRandom();
  for (int turn = 0; turn < 4; ++turn) {
    const One s = anySpring(random, turn);
    Eigen::Matrix<double, 6, 1> d;
    d << tidy(random.vector3(1.0)), tidy(random.vector3(1.0));
    const double step = 1e-3;
    // What is left of the fourth derivative is 1e-6 times k over a length of 0.4 m or more, squared; roundings of the
    // energies are 1e-16 / 1e-6.
    const double bend =
        (energyOf(s, step * d) - 2 * energyOf(s, {Eigen::Matrix<double, 6, 1>::Zero()}) + energyOf(s, -step * d)) /
        (step * step);
    MUELLE_LABEL("d . K d with your K, against the second difference of the energy", "N m");
    EXPECT_NUMBER_NEAR(d.dot(s.own() * d), bend, 2e-4 * s.scale() * d.squaredNorm());
  }
}

// --- GeometricPart --------------------------------------------------------------------------------------------------

namespace {

/// What the spring answers to a move of a across it, against what is left of its own stiffness along it.
void expectAcross(const One& s, const std::string& what) {
  const Mat3 A = s.ownBlock();
  const double along = s.direction().dot(A * s.direction());
  MUELLE_LABEL(fmt::format("stiffness across {}, given your stiffness along it of {:.6g} N/m", what, along), "N/m");
  EXPECT_NUMBER_NEAR(s.across().dot(A * s.across()), s.tension() * along, inStructure(s.scale()));
}

}  // namespace

TEST(GeometricPart, OfAStretchedSpringHoldsItStraight) {
  MUELLE_PROPERTY("across a stretched spring its tension makes a stiffness: k (1 - L0 / L), where it has k along it");
  MUELLE_EXPECT_ANSWERS(springHessian);
  Random random = testRandom();
  for (int i = 0; i < 4; ++i) expectAcross(anySpring(random, 0), "a stretched spring");
}

TEST(GeometricPart, OfACompressedSpringIsNegative) {
  MUELLE_PROPERTY("across a compressed spring the stiffness is negative: k (1 - L0 / L), where it has k along it");
  MUELLE_EXPECT_ANSWERS(springHessian);
  Random random = testRandom();
  for (int i = 0; i < 4; ++i) expectAcross(anySpring(random, 1), "a compressed spring");
}

TEST(GeometricPart, VanishesAtRest) {
  MUELLE_PROPERTY("a spring at rest does not resist when it is turned: across it there is no stiffness");
  MUELLE_EXPECT_ANSWERS(springHessian);
  Random random = testRandom();
  for (int i = 0; i < 4; ++i) {
    const Vec3 xb = tidy(Vec3(random.vector3(1.0) + Vec3(0.3, -0.2, 0.6)));
    const Vec3 n = random.roundedDirection();
    const One s{xb + 1.7 * n, xb, threeDigits(random.positive(20.0, 150.0)), 1.7};
    const Mat6 K = s.own();
    const Vec3 turn = tidy(random.vector3(1.0));
    Eigen::Matrix<double, 6, 1> turned;
    turned << turn.cross(s.xa), turn.cross(s.xb);
    {
      MUELLE_LABEL("stiffness across a spring at rest", "N/m");
      EXPECT_NUMBER_NEAR(s.across().dot(K.topLeftCorner<3, 3>() * s.across()), 0.0, inStructure(s.scale()));
    }
    // Of the turn itself: a matrix whose blocks do not fit resists it, too, and is judged elsewhere.
    const Vec3 apart = turned.head<3>() - turned.tail<3>();
    MUELLE_LABEL("what block A of a spring at rest answers to a turn", "N");
    EXPECT_VECTOR_NEAR(Vec3(K.topLeftCorner<3, 3>() * apart), Vec3(0, 0, 0), inStructure(4 * s.scale()));
  }
}

// --- Blocks ---------------------------------------------------------------------------------------------------------

TEST(Blocks, AreAAndMinusA) {
  MUELLE_PROPERTY("the four blocks are A, -A, -A, A: only xa - xb counts");
  MUELLE_EXPECT_ANSWERS(springHessian);
  Random random = testRandom();
  for (int turn = 0; turn < 4; ++turn) {
    const One s = anySpring(random, turn);
    const Mat6 K = s.own();
    const Mat3 A = K.topLeftCorner<3, 3>(), minusA = -A;
    {
      MUELLE_LABEL("block (a, b), against minus your block (a, a)", "N/m");
      EXPECT_MATRIX_NEAR(Mat3(K.topRightCorner<3, 3>()), minusA, inStructure(s.scale()));
    }
    {
      MUELLE_LABEL("block (b, a), against minus your block (a, a)", "N/m");
      EXPECT_MATRIX_NEAR(Mat3(K.bottomLeftCorner<3, 3>()), minusA, inStructure(s.scale()));
    }
    MUELLE_LABEL("block (b, b), against your block (a, a)", "N/m");
    EXPECT_MATRIX_NEAR(Mat3(K.bottomRightCorner<3, 3>()), A, inStructure(s.scale()));
  }
}

TEST(Blocks, MakeASymmetricMatrix) {
  MUELLE_PROPERTY("a Hessian is symmetric: the order of two derivatives does not matter");
  MUELLE_EXPECT_ANSWERS(springHessian);
  Random random = testRandom();
  for (int turn = 0; turn < 4; ++turn) {
    const One s = anySpring(random, turn);
    const Mat6 K = s.own();
    MUELLE_LABEL("Hessian of a spring, against your own with rows and columns exchanged", "N/m");
    EXPECT_MATRIX_NEAR(K, Mat6(K.transpose()), inStructure(s.scale()));
  }
}

TEST(Blocks, DoNotResistATranslation) {
  MUELLE_PROPERTY("moving both nodes by the same vector changes no force");
  MUELLE_EXPECT_ANSWERS(springHessian);
  Random random = testRandom();
  for (int turn = 0; turn < 4; ++turn) {
    const One s = anySpring(random, turn);
    const Vec3 d = tidy(random.vector3(1.0));
    Eigen::Matrix<double, 6, 1> both;
    both << d, d;
    MUELLE_LABEL("K d with your K, for the same move of both nodes", "N");
    EXPECT_VECTOR_NEAR(VecX(s.own() * both), VecX(VecX::Zero(6)), inStructure(4 * s.scale()));
  }
}

// --- ElasticForce ---------------------------------------------------------------------------------------------------

TEST(ElasticForce, SumsTheForcesOfTheSprings) {
  MUELLE_PROPERTY("each spring pulls or pushes its two nodes, with opposite forces, and each node adds up its own");
  Random random = testRandom();
  for (const Net& net : someNets(random)) expectForce(net);
}

TEST(ElasticForce, HoldsForEveryNet) {
  MUELLE_PROPERTY("the force holds without springs and with forty, for any stiffness and any rest length");
  Random random = testRandom();
  for (const Net& net : netsOfTheWholeRange(random)) expectForce(net);
}

// --- AssembleHessian ------------------------------------------------------------------------------------------------

TEST(AssembleHessian, AddsUpTheBlocks) {
  MUELLE_PROPERTY("the four blocks of each spring are added where its nodes have their rows and columns");
  Random random = testRandom();
  for (const Net& net : someNets(random)) expectAssembled(net);
}

TEST(AssembleHessian, HoldsForEveryNet) {
  MUELLE_PROPERTY("the matrix is 3n x 3n and right without springs, with forty, and where two springs join two nodes");
  Random random = testRandom();
  for (const Net& net : netsOfTheWholeRange(random)) expectAssembled(net);
}

TEST(AssembleHessian, StoresNothingWhereNoSpringIs) {
  MUELLE_PROPERTY("a block is stored for a node with springs and for two nodes that a spring joins, and for no others");
  Random random = testRandom();
  Net chain{someNodes(random, 13), {}};
  for (int i = 0; i + 1 < 12; ++i) chain.springs.push_back({i, i + 1, 37.0 + 3 * i, 0.73});
  const SparseMatrix K = submission::assembleHessian(chain.x, chain.springs);
  {
    MUELLE_LABEL("assembleHessian of a chain of 12 nodes", "N/m");
    EXPECT_MATRIX_NEAR(MatX(K), MatX(oracle::assembleHessian(chain.x, chain.springs)),
                       inRounding(chain.stiffnessScale()));
  }
  // 12 nodes with springs, and 11 springs with two blocks each beside them.
  const auto stored = static_cast<double>(K.nonZeros());
  MUELLE_LABEL("stored numbers of a chain of 12 nodes and a node without spring, of which 9 (12 + 2 * 11) may be");
  EXPECT_NUMBER_NEAR(std::max(stored, 9.0 * 34), 9.0 * 34, 0);
}

// --- DerivativeOfForce ----------------------------------------------------------------------------------------------

namespace {

/// How the force on both nodes of a spring changes with a small move d [m] of both, by central differences.
VecX changeOfForce(const One& s, const VecX& d) {
  const auto forceAt = [&](double step) {
    VecX x(6);
    x << s.xa, s.xb;
    return submission::elasticForce(x + step * d, {{0, 1, s.k, s.L0}});
  };
  const double step = 1e-4;
  const VecX ahead = forceAt(step), behind = forceAt(-step);
  constexpr double noNumber = std::numeric_limits<double>::quiet_NaN();
  if (ahead.size() != 6 || behind.size() != 6) return VecX::Constant(6, noNumber);
  return (ahead - behind) / (2 * step);
}

}  // namespace

TEST(DerivativeOfForce, IsMinusTheHessian) {
  MUELLE_PROPERTY(
      "when the nodes move by a small d, your elasticForce changes by -K d with the K of your springHessian");
  MUELLE_EXPECT_ANSWERS(springHessian);
  MUELLE_EXPECT_ANSWERS(elasticForce);
  Random random = testRandom();
  for (int turn = 0; turn < 5; ++turn) {
    const One s = anySpring(random, turn);
    VecX d(6);
    d << tidy(random.vector3(1.0)), tidy(random.vector3(1.0));
    // The third derivative leaves 1e-8 k (d / L)^2, roundings 1e-16 / 1e-4.
    MUELLE_LABEL("how your force changes with a small move, against -K d with your K", "N");
    EXPECT_VECTOR_NEAR(changeOfForce(s, d), VecX(-s.own() * d), inStructure(4 * s.scale()));
  }
}

// --- ZeroLength -----------------------------------------------------------------------------------------------------

namespace {

/// The force on node a of one spring; not finite where it is no force on two nodes.
Vec3 ownForceOnA(const One& s) {
  VecX x(6);
  x << s.xa, s.xb;
  const VecX F = submission::elasticForce(x, {{0, 1, s.k, s.L0}});
  return F.size() == 6 ? Vec3(F.head<3>()) : Vec3(Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
}

const Vec3 line(2.0 / 7, -3.0 / 7, 6.0 / 7);  // of length 1, and no component is zero

}  // namespace

TEST(ZeroLength, HasTheHessianOfNoRestLength) {
  MUELLE_PROPERTY("where the nodes coincide, block A is k times the identity: as stiff each way as along the spring");
  MUELLE_EXPECT_ANSWERS(springHessian);
  const Vec3 at(0.3, -0.7, 0.2);
  for (const double k : {1e-3, 37.0, 1e9}) {
    for (const double L0 : {0.0, 0.73, longestRest}) {
      const Mat3 A = One{at, at, k, L0}.ownBlock();
      // What the student's own springs have where nothing is special, along them or, without rest length, across.
      const One usual{Vec3(at + 1.3 * line), at, k, 0.7}, loose{usual.xa, usual.xb, k, 0};
      const double along = usual.direction().dot(usual.ownBlock() * usual.direction());
      const double across = loose.across().dot(loose.ownBlock() * loose.across());
      const bool isAlong = !(std::abs(A(0, 0) - across) < std::abs(A(0, 0) - along));
      MUELLE_LABEL(fmt::format("block A of coincident nodes, against your stiffness {}",
                               isAlong ? "along a spring of 1.3 m" : "across one of 1.3 m without rest length"),
                   "N/m");
      EXPECT_MATRIX_NEAR(A, Mat3((isAlong ? along : across) * Mat3::Identity()), inStructure(k));
    }
  }
}

TEST(ZeroLength, HasNoForce) {
  MUELLE_PROPERTY("a spring whose nodes coincide has no force, never NaN, and the other springs act as usual");
  MUELLE_EXPECT_ANSWERS(elasticForce);
  VecX x(9);
  x << 0.3, -0.7, 0.2, 0.3, -0.7, 0.2, 0.9, 0.1, -0.8;
  const Springs others = {{1, 2, 73, 0.4}, {2, 0, 47, 1.9}};
  const VecX without = submission::elasticForce(x, others);
  ASSERT_EQ(without.size(), 9);
  for (const double L0 : {0.0, 0.73}) {
    for (const int a : {0, 1}) {
      const Springs all = {{1, 2, 73, 0.4}, {a, 1 - a, 31, L0}, {2, 0, 47, 1.9}};
      MUELLE_LABEL("force with a spring between coincident nodes, against yours without that spring", "N");
      EXPECT_VECTOR_NEAR(submission::elasticForce(x, all), without, inStructure(100));
    }
  }
}

TEST(ZeroLength, IsNoneHoweverShort) {
  MUELLE_PROPERTY("a spring of any length above 0 has a direction: its stiffness across it is k (1 - L0 / L)");
  MUELLE_EXPECT_ANSWERS(springHessian);
  const double L0 = 0.83;
  const auto atLength = [&](double length) {
    const One s{length * line, Vec3(0, 0, 0), 37, L0};
    return s.across().dot(s.ownBlock() * s.across());
  };
  // The student's own law, by two lengths at which nothing is special: T over a power of L, or the same at any length.
  const double usual = atLength(0.3);
  const double power = std::log(atLength(0.2) / (0.2 - L0) * (0.3 - L0) / usual) / std::log(0.3 / 0.2);
  const double whole = std::isfinite(power) ? std::round(power) : 0;
  const auto expectUsual = [&](double length, const Vec3& xa, const Vec3& xb) {
    const One s{xa, xb, 37, L0};
    const Mat3 A = s.ownBlock();
    const double got = s.across().dot(A * s.across());
    const double byPower = usual * (length - L0) / (0.3 - L0) * std::pow(0.3 / length, whole);
    const double expected = std::abs(got - byPower) < std::abs(got - usual) || got != got ? byPower : usual;
    MUELLE_LABEL(fmt::format("stiffness across a spring of {:.3g} m, by yours across springs of 0.3 and 0.2 m", length),
                 "N/m");
    // What a block has along the spring leaves its roundings across it.
    const double rounding = A.allFinite() ? inRounding(A.cwiseAbs().maxCoeff()) : 0;
    EXPECT_NUMBER_NEAR(got, expected, inStructure(37 + std::abs(expected)) + rounding);
  };
  for (const double length : lengthLadder(shortest)) expectUsual(length, length * line, Vec3(0, 0, 0));
  for (const double unit : exactLengthLadder()) {  // away from the origin
    if (7 * unit > L0) continue;                   // what is special in a stretched spring is judged elsewhere
    expectUsual(7 * unit, Vec3(1.25, -1.75, 1.5) + unit * Vec3(2, -3, 6), Vec3(1.25, -1.75, 1.5));
  }
}

TEST(ZeroLength, HasAForceHoweverShort) {
  MUELLE_PROPERTY("a spring of any length above 0 has a direction: its force grows by its own law, k (L - L0)");
  MUELLE_EXPECT_ANSWERS(elasticForce);
  const double L0 = 0.83;
  const auto atLength = [&](double length) { return ownForceOnA({length * line, Vec3(0, 0, 0), 37, L0}); };
  // The student's own law, by two lengths at which nothing is special: a straight line.
  const Vec3 first = atLength(0.3), slope = (first - atLength(0.2)) / (0.3 - 0.2);
  const auto expectUsual = [&](double length, const Vec3& xa, const Vec3& xb) {
    MUELLE_LABEL(fmt::format("force on a at a length of {:.3g} m, by yours at 0.3 and 0.2 m", length), "N");
    EXPECT_VECTOR_NEAR(ownForceOnA({xa, xb, 37, L0}), Vec3(first + (length - 0.3) * slope), inStructure(37));
  };
  for (const double length : lengthLadder(shortest)) expectUsual(length, length * line, Vec3(0, 0, 0));
  for (const double unit : exactLengthLadder()) {
    if (7 * unit > L0) continue;  // what is special in a stretched spring is judged elsewhere
    expectUsual(7 * unit, Vec3(1.25, -1.75, 1.5) + unit * Vec3(2, -3, 6), Vec3(1.25, -1.75, 1.5));
  }
}

// --- BackwardEuler --------------------------------------------------------------------------------------------------

namespace {

bool isOfSize(const State& state, Eigen::Index n) { return state.x.size() == n && state.v.size() == n; }

/// A step to be made.
struct Case {
  Net net;
  VecX m, v, F;
  double h;

  State now() const { return {net.x, v}; }
  State own() const { return submission::backwardEulerStep(now(), m, net.springs, F, h); }
  State right() const { return oracle::backwardEulerStep(now(), m, net.springs, F, h); }

  /// The mass of each coordinate.
  VecX masses() const {
    VecX each(net.x.size());
    for (Eigen::Index i = 0; i < each.size(); ++i) each[i] = m[i / 3];
    return each;
  }
  /// By how much the equation, each row over its mass, magnifies roundings.
  double condition() const {
    const VecX root = masses().cwiseSqrt().cwiseInverse();
    const MatX K = oracle::assembleHessian(net.x, net.springs);
    const MatX system = MatX::Identity(K.rows(), K.cols()) + h * h * MatX(root.asDiagonal() * K * root.asDiagonal());
    const VecX sizes = muelle::engine::symmetricEigenvalues(system).cwiseAbs();
    return std::max(1.0, sizes.maxCoeff()) * std::max(1.0, 1 / sizes.minCoeff());
  }
};

VecX someNumbers(Random& random, Eigen::Index count, double low, double high) {
  VecX numbers(count);
  for (double& number : numbers) number = (random.integer(0, 1) == 0 ? 1 : -1) * random.rounded(low, high);
  return numbers;
}

/// No two alike.
VecX someMasses(Random& random, int nodes) {
  VecX m(nodes);
  for (int i = 0; i < nodes; ++i) m[i] = threeDigits(random.number(0.31, 0.43) * (1 + 0.7 * i));
  return m;
}

Case someCase(Random& random, int springs, Strain strain = Strain::Stretched) {
  const Net net = someNet(random, springs, strain);
  return {net, someMasses(random, net.nodes()), someNumbers(random, net.x.size(), 0.22, 1.47),
          someNumbers(random, net.x.size(), 1.1, 9.7), random.rounded(0.06, 0.31)};
}

void expectStep(const State& got, const State& expected, const Case& c) {
  const double speed = sizeOf(c.v) + sizeOf(expected.v) + c.h * (c.net.forceScale() + sizeOf(c.F)) / c.m.minCoeff();
  const double rounding = inRounding(c.condition() * speed);
  {
    MUELLE_LABEL("velocities at the end of the step", "m/s");
    EXPECT_VECTOR_NEAR(got.v, expected.v, rounding);
  }
  MUELLE_LABEL("positions at the end of the step", "m");
  EXPECT_VECTOR_NEAR(got.x, expected.x, c.h * rounding + inRounding(sizeOf(c.net.x)));
}

/// The ends of what the contract allows, such that everything stays in bounds.
std::vector<Case> casesOfTheWholeRange(Random& random) {
  std::vector<Case> cases;
  Case still = someCase(random, 2);
  still.h = 0;
  cases.push_back(still);
  Case long_ = someCase(random, 2);
  long_.h = 10;
  cases.push_back(long_);
  Case stiff = someCase(random, 3);
  for (Spring& s : stiff.net.springs) s.k = 1e9;
  stiff.h = 3e-5;
  cases.push_back(stiff);
  Case soft = someCase(random, 2);
  for (Spring& s : soft.net.springs) s.k = 1e-3;
  cases.push_back(soft);
  Case light = someCase(random, 2);
  light.m.setConstant(1e-6);
  light.m[1] = 3.7e-6;
  light.h = 1e-3;
  cases.push_back(light);
  Case heavy = someCase(random, 2);
  heavy.m[0] = 1e6;
  cases.push_back(heavy);
  Case loose = someCase(random, 2);
  for (Spring& s : loose.net.springs) s.L0 = 0;
  cases.push_back(loose);
  Case thrust = someCase(random, 2);
  for (Spring& s : thrust.net.springs) s.L0 = longestRest;
  thrust.h = 1e-4;
  cases.push_back(thrust);
  cases.push_back(someCase(random, 0));
  cases.push_back(someCase(random, 40));
  return cases;
}

}  // namespace

TEST(BackwardEuler, SolvesTheEquation) {
  MUELLE_PROPERTY("(M + h^2 K) dv = h (F_total - h K v), with the K of the beginning; then x goes on with the new v");
  Random random = testRandom();
  for (const int springs : {1, 1, 1, 2, 2, 3, 5}) {
    const Case c = someCase(random, springs);
    expectStep(c.own(), c.right(), c);
  }
}

TEST(BackwardEuler, HoldsForEveryStepAndMass) {
  MUELLE_PROPERTY(
      "the step is right for h = 0 and for 10 s, for light and heavy nodes, without springs and with forty");
  Random random = testRandom();
  for (const Case& c : casesOfTheWholeRange(random)) expectStep(c.own(), c.right(), c);
}

TEST(BackwardEuler, TakesCompressedSpringsAsTheyAre) {
  MUELLE_PROPERTY("compressed springs have their negative stiffness across in the matrix, too");
  Random random = testRandom();
  for (const int springs : {1, 2, 4}) {
    Case c = someCase(random, springs, Strain::Both);
    for (Spring& s : c.net.springs) s.L0 = threeDigits(c.net.length(s) * random.number(1.2, 1.9));
    // Short enough that the matrix stays positive definite: h^2 K is at most a quarter of M.
    c.h = threeDigits(0.5 * std::sqrt(c.m.minCoeff() / (2 * c.net.stiffnessScale())));
    expectStep(c.own(), c.right(), c);
  }
}

TEST(BackwardEuler, AgreesWithTheSimulator) {
  MUELLE_PROPERTY("the step is that of the linearised backward Euler of the reference simulator");
  Random random = testRandom();
  for (int i = 0; i < 3; ++i) {
    Case c = someCase(random, 1);  // the simulator wants one spring between two nodes
    c.net = {someNodes(random, 3), {}};
    for (int a = 0; a < 3; ++a) {
      const double L = (c.net.node(a) - c.net.node((a + 1) % 3)).norm();
      c.net.springs.push_back({a, (a + 1) % 3, threeDigits(random.positive(20.0, 150.0)), threeDigits(0.7 * L)});
    }
    c.F = VecX::Zero(9);
    muelle::engine::Model model;
    for (int node = 0; node < 3; ++node) {
      model.nodes.emplace_back();
      model.nodes.back().x = c.net.node(node);
      model.nodes.back().v = c.v.segment<3>(3 * node);
      model.nodes.back().m = c.m[node];
    }
    for (const Spring& s : c.net.springs) {
      model.springs.emplace_back();
      model.springs.back().a = s.a;
      model.springs.back().b = s.b;
      model.springs.back().k = s.k;
      model.springs.back().L0 = s.L0;
    }
    const auto system = muelle::engine::build(model);
    const muelle::State from = system->initialState();
    muelle::State to = from;
    const auto method = muelle::engine::makeMethod("linearised_backward_euler");
    method->prepare(*system, {});
    ASSERT_TRUE(method->step(*system, from, c.h, to).done);
    State simulated{VecX(9), VecX(9)};
    for (int j = 0; j < 9; ++j) {
      const auto lane = static_cast<std::size_t>(system->lane(j / 3, j % 3));
      simulated.x[j] = to.x[lane];
      simulated.v[j] = to.v[lane];
    }
    // Given a student's own lower functions the oracle's step is not the simulator's, and so need not be the student's.
    const State given = c.right();
    const bool isGiven = (given.v - simulated.v).norm() > inStructure(1);
    expectStep(c.own(), isGiven ? given : simulated, c);
  }
}

// --- Indefinite -----------------------------------------------------------------------------------------------------

namespace {

/// The matrix that a step has solved with, found by pushing each coordinate: a push F changes dv by A^-1 h F. \return
/// no matrix where a step is no state
MatX matrixOf(const Case& c) {
  const Eigen::Index n = c.net.x.size();
  MatX answers(n, n);
  Case pushed = c;
  pushed.F.setZero();
  const State without = pushed.own();
  if (!isOfSize(without, n)) return MatX();
  for (Eigen::Index i = 0; i < n; ++i) {
    pushed.F = VecX::Unit(n, i);
    const State with = pushed.own();
    if (!isOfSize(with, n)) return MatX();
    answers.col(i) = (with.v - without.v) / c.h;
  }
  return muelle::engine::inverse(answers);
}

}  // namespace

TEST(Indefinite, IsSolvedAsItIs) {
  MUELLE_PROPERTY(
      "a compressed spring may make the matrix indefinite: it is solved as it is, which Cholesky cannot do");
  MUELLE_EXPECT_ANSWERS(backwardEulerStep);
  Random random = testRandom();
  for (int i = 0; i < 2; ++i) {
    Case c = someCase(random, 1);
    c.net = {someNodes(random, 2), {{i, 1 - i, 0, 0}}};
    c.m = someMasses(random, 2);
    c.v = c.F = VecX::Zero(6);
    const double L = (c.net.node(0) - c.net.node(1)).norm();
    c.net.springs[0].L0 = threeDigits(L * random.number(2.4, 3.2));
    const double across = c.net.springs[0].L0 / L - 1;
    const auto withStiffness = [&](double part) {  // of the one at which the matrix becomes singular
      c.net.springs[0].k = threeDigits(part * c.m.minCoeff() / (2 * c.h * c.h * across));
      return matrixOf(c);
    };
    // The matrix is M and something times k: what it is with soft springs says what it is with a stiff one.
    const MatX softest = withStiffness(0.1);
    const double first = c.net.springs[0].k;
    const MatX soft = withStiffness(0.4);
    const double second = c.net.springs[0].k;
    const MatX stiff = withStiffness(4.7);
    const double last = c.net.springs[0].k;
    ASSERT_EQ(std::min({softest.size(), soft.size(), stiff.size()}), 36);
    if (!softest.allFinite() && !soft.allFinite()) continue;  // no F moves it: that is judged elsewhere
    const MatX expected = softest + (last - first) / (second - first) * (soft - softest);
    MUELLE_LABEL(fmt::format("matrix with which your step has solved at k = {:.3g} N/m, against what it has to be by "
                             "your steps at {:.3g} and {:.3g} N/m",
                             last, first, second),
                 "kg");
    EXPECT_MATRIX_NEAR(stiff, expected, inStructure(100 * sizeOf(c.m)));
  }
}

// --- motions --------------------------------------------------------------------------------------------------------

namespace {

/// The states of so many steps without other forces; ends early at one that is no state, or explodes.
std::vector<State> march(const Net& net, const VecX& v, const VecX& m, double h, int steps) {
  std::vector<State> states = {{net.x, v}};
  for (int i = 0; i < steps; ++i) {
    const State& now = states.back();
    if (!isOfSize(now, net.x.size()) || !(sizeOf(now.x) < 1e9 && sizeOf(now.v) < 1e9)) break;
    states.push_back(submission::backwardEulerStep(now, m, net.springs, VecX::Zero(net.x.size()), h));
  }
  return states;
}

/// Two equal nodes on a spring without rest length: what is between them swings as one mass on one spring, exactly.
struct Pair {
  double k = 31.0, mass = 0.37;
  VecX x = (VecX(6) << 0.31, -0.47, 0.23, -0.29, 0.61, 0.83).finished();
  VecX v = (VecX(6) << 0.7, 0.4, -0.9, -0.3, 1.1, 0.6).finished();

  Net net() const { return {x, {{0, 1, k, 0}}}; }
  VecX m() const { return VecX::Constant(2, mass); }
  double omega() const { return std::sqrt(2 * k / mass); }

  /// Energy of what is between the nodes [J].
  double energy(const State& state) const {
    if (!isOfSize(state, 6)) return std::numeric_limits<double>::quiet_NaN();
    const Vec3 apart = state.x.head<3>() - state.x.tail<3>(), speed = state.v.head<3>() - state.v.tail<3>();
    return 0.5 * k * apart.squaredNorm() + 0.25 * mass * speed.squaredNorm();
  }
};

}  // namespace

// --- Order ----------------------------------------------------------------------------------------------------------

namespace {

/// Distance of the pair from where it truly is after a third of a period, where neither x nor v is at an end.
double errorAfterAThird(int steps) {
  const Pair pair;
  const double angle = 2.1, T = angle / pair.omega();
  const std::vector<State> states = march(pair.net(), pair.v, pair.m(), T / steps, steps);
  if (!isOfSize(states.back(), 6)) return std::numeric_limits<double>::quiet_NaN();
  const Vec3 middle = 0.5 * (pair.x.head<3>() + pair.x.tail<3>()) + T / 2 * (pair.v.head<3>() + pair.v.tail<3>());
  const Vec3 apart = (pair.x.head<3>() - pair.x.tail<3>()) * std::cos(angle) +
                     (pair.v.head<3>() - pair.v.tail<3>()) * std::sin(angle) / pair.omega();
  VecX exact(6);
  exact << middle + 0.5 * apart, middle - 0.5 * apart;
  return (states.back().x - exact).norm();
}

}  // namespace

TEST(Order, IsOne) {
  MUELLE_PROPERTY("with half the step the error is about half as large");
  MUELLE_EXPECT_ANSWERS(backwardEulerStep);
  const double coarse = errorAfterAThird(200), fine = errorAfterAThird(400);
  {
    MUELLE_LABEL("distance from where the nodes truly are, at the end of a third of a swing in 200 steps", "m");
    ASSERT_NUMBER_NEAR(coarse, 0, 1);  // two explosions may have any ratio
  }
  // The next term of the error is a hundredth of the first.
  const double measured = std::log2(coarse / fine);
  MUELLE_LABEL("order, by the errors with 200 and with 400 steps in a third of a swing of two nodes on a spring");
  EXPECT_NUMBER_NEAR(measured, 1, 0.15);
}

// --- NumericalDamping -----------------------------------------------------------------------------------------------

TEST(NumericalDamping, IsThatOfTheFormula) {
  MUELLE_PROPERTY("each step divides the energy of an undamped swing by 1 + (h omega)^2, whatever the step");
  MUELLE_EXPECT_ANSWERS(backwardEulerStep);
  const Pair pair;
  for (const double z : {0.1, 0.7, 3.0, 20.0}) {
    const int steps = z < 1 ? 12 : 3;
    const std::vector<State> states = march(pair.net(), pair.v, pair.m(), z / pair.omega(), steps);
    const double expected = std::pow(1 + z * z, -steps);
    MUELLE_LABEL(fmt::format("energy after {} steps with h omega = {}, over that at the start", steps, z));
    EXPECT_NUMBER_NEAR(pair.energy(states.back()) / pair.energy(states.front()), expected,
                       inStructure(expected) * steps);
  }
}

// --- Stability ------------------------------------------------------------------------------------------------------

namespace {

/// Energy of springs without rest length and of their nodes [J].
double energyOf(const Net& net, const VecX& m, const State& state) {
  if (!isOfSize(state, net.x.size())) return std::numeric_limits<double>::quiet_NaN();
  double E = 0;
  for (const Spring& s : net.springs) {
    E += 0.5 * s.k * (state.x.segment<3>(3 * s.a) - state.x.segment<3>(3 * s.b)).squaredNorm();
  }
  for (int i = 0; i < net.nodes(); ++i) E += 0.5 * m[i] * state.v.segment<3>(3 * i).squaredNorm();
  return E;
}

}  // namespace

TEST(Stability, HasNoLimit) {
  MUELLE_PROPERTY(
      "the energy of springs without rest length grows in no step, however long: explicit methods end at "
      "h omega = 2");
  MUELLE_EXPECT_ANSWERS(backwardEulerStep);
  // A ring of four unequal nodes that flies, turns and widens.
  Net net{VecX(12), {{0, 1, 80, 0}, {2, 1, 73, 0}, {2, 3, 88, 0}, {3, 0, 77, 0}}};
  net.x << 0.61, 0.43, -0.17, -0.47, 0.58, 0.23, -0.53, -0.39, -0.31, 0.38, -0.66, 0.29;
  const VecX m{{0.37, 0.63, 0.89, 1.15}};
  VecX v(12);
  v << 1.37, 0.07, 0.71, 0.23, 0.26, 1.13, 0.11, -0.83, 0.57, 1.12, -1.09, 1.19;
  const double omega = std::sqrt(2 * 88 / m.minCoeff());  // none is faster
  for (const double z : {3.0, 30.0, 200.0}) {
    const std::vector<State> states = march(net, v, m, tidy(z / omega, 1e4), 20);
    double E = energyOf(net, m, states.front());
    const double start = E;
    for (std::size_t i = 1; i < states.size(); ++i) {
      const double next = energyOf(net, m, states[i]);
      MUELLE_LABEL(fmt::format("energy that step {} adds, with h omega = {}", i, z), "J");
      ASSERT_NUMBER_NEAR(std::max(next - E, 0.0) + 0 * next, 0.0, inStructure(start));
      E = next;
    }
  }
}

// --- Momentum -------------------------------------------------------------------------------------------------------

TEST(Momentum, IsChangedByOtherForcesAlone) {
  MUELLE_PROPERTY("springs change no momentum: a step changes the sum of m v by h times the sum of the other forces");
  MUELLE_EXPECT_OF_USE(backwardEulerStep);
  Random random = testRandom();
  for (int i = 0; i < 4; ++i) {
    const Case c = someCase(random, 2 + i);
    const State next = c.own();
    ASSERT_TRUE(isOfSize(next, c.net.x.size()));
    Vec3 change = Vec3::Zero(), push = Vec3::Zero();
    for (int node = 0; node < c.net.nodes(); ++node) {
      change += c.m[node] * (next.v - c.v).segment<3>(3 * node);
      push += c.h * c.F.segment<3>(3 * node);
    }
    MUELLE_LABEL("momentum that your step adds, against h times the sum of F", "kg m/s");
    EXPECT_VECTOR_NEAR(change, push, inStructure(1 + push.norm()));
  }
}
