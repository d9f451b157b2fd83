#include "nodes_and_springs.h"

#include "course/testing/expect.h"
#include "course/testing/random.h"
#include "engine/model/model_system.h"
#include "grader/testing/ladders.h"
#include "grader/testing/of_use.h"
#include "grader/testing/plain_numbers.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>

using muelle::Mat3;
using muelle::Random;
using muelle::testRandom;
using muelle::threeDigits;
using muelle::VecX;
using muelle::grader::countLadder;
using muelle::grader::someTurn;
using muelle::grader::stiffnessLadder;
using muelle::grader::tidy;

// Laws are kept by the history of calls until the program ends: what they need they own.

namespace {

using Nodes = std::vector<NodeData>;
using Springs = std::vector<SpringData>;
using Results = std::vector<Result>;

/// A tolerance for values: forty forces in any order of the sum are off by 40 roundings of 1.1e-16 at most, 5e-15 of
/// the numbers involved; single precision is off by 6e-8.
double inRounding(double scale) { return 1e-13 * scale; }

/// A tolerance for laws, which are about structure and not about digits.
double inStructure(double scale) { return 1e-6 * scale; }

std::size_t place(int i) { return static_cast<std::size_t>(i); }

/// A spring of the lecture.
Vec3 hookesForce(const Vec3& xa, const Vec3& xb, double stiffness, double length) {
  const double L = (xa - xb).stableNorm();
  return L > 0 ? Vec3(-stiffness * (L - length) * ((xa - xb) / L)) : Vec3(Vec3::Zero());
}
const ForceLaw hooke = hookesForce;

/// No spring of anybody's: it pulls along another line, too. A program that asks the law does not see the difference.
const ForceLaw strange = [](const Vec3& xa, const Vec3& xb, double stiffness, double length) -> Vec3 {
  const Vec3 r = xa - xb;
  return stiffness * Vec3(r[1] - 0.3 * r[0], length * r[2], -0.7 * r[0]);
};

/// A law that counts how often it is asked, by the stiffness of the spring.
/// Springs are known by their stiffness, the larger of both numbers also where these are passed in the wrong order.
struct CountedLaw {
  std::shared_ptr<std::map<double, int>> asked = std::make_shared<std::map<double, int>>();

  ForceLaw law() const {
    return [asked = asked](const Vec3& xa, const Vec3& xb, double stiffness, double length) {
      ++(*asked)[std::max(stiffness, length)];
      return hookesForce(xa, xb, stiffness, length);
    };
  }
  int questions() const {
    int sum = 0;
    for (const auto& [stiffness, times] : *asked) sum += times;
    return sum;
  }
};

/// Nodes and springs as numbers.
struct Net {
  Nodes nodes;
  Springs springs;

  /// The largest force there may be, times the number of springs.
  double scale() const {
    double largest = 0;
    for (const SpringData& s : springs) {
      const double L = (nodes[place(s.a)].x - nodes[place(s.b)].x).stableNorm();
      largest = std::max(largest, s.stiffness * (L + s.length) * (1 + L));
    }
    return largest * static_cast<double>(springs.size());
  }
  double accelerationScale() const {
    double lightest = 1e6;
    for (const NodeData& node : nodes) lightest = std::min(lightest, node.mass);
    return scale() / lightest;
  }
};

Nodes someNodes(Random& random, int count) {
  Nodes nodes;
  for (int i = 0; i < count; ++i) {
    nodes.push_back({threeDigits(random.positive(0.31, 4.7)), threeDigits(random.vector3(1.0))});
  }
  return nodes;
}

/// Springs between any two nodes, either of which may be the first; two may have the same.
Springs someSprings(Random& random, int count, int nodes) {
  Springs springs;
  for (int i = 0; i < count; ++i) {
    const int a = random.integer(0, nodes - 1), b = (a + random.integer(1, nodes - 1)) % nodes;
    // No two stiffnesses are the same: it is what a spring is known by.
    springs.push_back({a, b, tidy(17.3 + 3.7 * i + random.number(0, 1.7)), random.rounded(0.3, 1.9)});
  }
  return springs;
}

/// Nodes 0 to count - 1 have springs, and one or two more have none.
Net someNet(Random& random, int springs) {
  const int nodes = 3 + springs / 3;
  return {someNodes(random, nodes + random.integer(1, 2)), someSprings(random, springs, nodes)};
}

VecX forcesOf(const Results& results) {
  VecX all(3 * static_cast<Eigen::Index>(results.size()));
  Eigen::Index at = 0;
  for (const Result& result : results) {
    all.segment<3>(at) = result.F;
    at += 3;
  }
  return all;
}

using Program = std::function<Results(const Net& net, const ForceLaw& law)>;

Results submittedGather(const Net& net, const ForceLaw& law) { return submission::gather(net.nodes, net.springs, law); }
Results submittedScatter(const Net& net, const ForceLaw& law) {
  return submission::scatter(net.nodes, net.springs, law);
}
Results rightGather(const Net& net, const ForceLaw& law) { return oracle::gather(net.nodes, net.springs, law); }
Results rightScatter(const Net& net, const ForceLaw& law) { return oracle::scatter(net.nodes, net.springs, law); }

/// "node 2 of 5 with 7 springs": the first node that is off is enough.
/// \param part  the size of the forces, in parts of Hooke's
void expectNet(const Net& net, const Results& got, const Results& expected, double part = 1.0) {
  {
    MUELLE_LABEL("nodes that come back");
    ASSERT_NUMBER_NEAR(static_cast<double>(got.size()), static_cast<double>(expected.size()), 0);
  }
  for (std::size_t i = 0; i < got.size(); ++i) {
    const std::string where = fmt::format("node {} of {} with {} springs", i, got.size(), net.springs.size());
    {
      MUELLE_LABEL("F of " + where, "N");
      ASSERT_VECTOR_NEAR(got[i].F, expected[i].F, inRounding(part * net.scale()));
    }
    MUELLE_LABEL("a of " + where, "m/s^2");
    ASSERT_VECTOR_NEAR(got[i].a, expected[i].a, inRounding(part * net.accelerationScale()));
  }
}

void expectProgram(const Program& own, const Program& right) {
  Random random = testRandom();
  for (const int count : {1, 2, 3, 5, 8, 13}) {
    const Net net = someNet(random, count);
    expectNet(net, own(net, hooke), right(net, hooke));
    expectNet(net, own(net, strange), right(net, strange));
  }
}

/// No node, nodes without springs, one spring, many; and the ends of every range.
void expectEnds(const Program& own, const Program& right) {
  Random random = testRandom();
  expectNet({}, own({}, hooke), right({}, hooke));
  for (const int count : countLadder) {
    const Net net = someNet(random, count);
    expectNet(net, own(net, hooke), right(net, hooke));
  }
  const Net large{someNodes(random, 60), someSprings(random, 200, 60)};
  expectNet(large, own(large, hooke), right(large, hooke));
  for (const double stiffness : stiffnessLadder) {
    for (const double mass : {1e-6, 0.37, 1e6}) {
      for (const double length : {0.0, 1.3, 1000.0}) {
        const Net net{{{mass, Vec3(0.3, -0.7, 0.2)}, {mass, Vec3(-0.4, 0.6, 1.1)}, {mass, Vec3(0.9, 0.1, -0.8)}},
                      {{1, 0, stiffness, length}, {1, 2, stiffness, length}}};
        expectNet(net, own(net, hooke), right(net, hooke));
      }
    }
  }
}

/// Forces of any size: those of a law that is a small part of Hooke's, with the tolerance as small.
void expectSmallForces(const Program& own, const Program& right) {
  Random random = testRandom();
  const Net net = someNet(random, 5);
  for (const double part : {1e-6, 1.2e-11, 8e-12, 6e-12, 1e-30}) {
    const ForceLaw law = [part](const Vec3& xa, const Vec3& xb, double stiffness, double length) -> Vec3 {
      return part * hookesForce(xa, xb, stiffness, length);
    };
    const Results expected = right(net, law);
    // Where getForce or calcForce adds something of its own, that is what is mistaken.
    if (forcesOf(expected).cwiseAbs().maxCoeff() > part * net.scale()) return;
    expectNet(net, own(net, law), expected, part);
  }
}

}  // namespace

// --- one spring -----------------------------------------------------------------------------------------------------

namespace {

struct SpringCase {
  Vec3 xa, xb;
  double stiffness, length;

  double scale() const { return stiffness * ((xa - xb).stableNorm() + length) * (1 + (xa - xb).stableNorm()); }
};

std::vector<SpringCase> someSpringCases() {
  Random random = testRandom();
  std::vector<SpringCase> cases;
  for (int i = 0; i < 6; ++i) {
    cases.push_back({threeDigits(random.vector3(1.0)), threeDigits(random.vector3(1.0)),
                     threeDigits(random.positive(3.0, 300.0)), random.rounded(0.3, 1.9)});
  }
  for (const double stiffness : stiffnessLadder) {
    for (const double length : {0.0, 0.83, 1000.0}) {
      cases.push_back({Vec3(0.3, -0.7, 0.2), Vec3(-0.4, 0.6, 1.1), stiffness, length});
    }
  }
  return cases;
}

void expectGetForce(const SpringCase& s, int end, const ForceLaw& law) {
  EXPECT_VECTOR_NEAR(submission::getForce(s.xa, s.xb, s.stiffness, s.length, end, law),
                     oracle::getForce(s.xa, s.xb, s.stiffness, s.length, end, law), inRounding(s.scale()));
}

}  // namespace

TEST(GetForce, IsTheForceOnTheNodeThatAsks) {
  MUELLE_PROPERTY("getForce gives na what the law says, and nb the opposite");
  for (const SpringCase& s : someSpringCases()) {
    for (const int end : {0, 1}) expectGetForce(s, end, hooke);
  }
}

TEST(GetForce, AsksTheLaw) {
  MUELLE_PROPERTY("getForce asks the law of the spring, whatever this is, with na's place first");
  for (const SpringCase& s : someSpringCases()) {
    for (const int end : {0, 1}) expectGetForce(s, end, strange);
  }
}

TEST(GetForce, AlsoWhereTheNodesMeet) {
  MUELLE_PROPERTY("which end asks is told by the node itself, not by its place: two nodes may be at the same one");
  MUELLE_EXPECT_ANSWERS(getForce);
  const ForceLaw pushing = [](const Vec3&, const Vec3&, double stiffness, double) -> Vec3 {
    return Vec3(0, 0, stiffness);
  };
  // This law does not know one end from the other: what is asked is the sign that getForce gives to each.
  const auto own = [&](const Vec3& xa, const Vec3& xb, double stiffness, int end) {
    return submission::getForce(xa, xb, stiffness, 0.4, end, pushing);
  };
  for (const double stiffness : {7.3, 61.0, 1.9}) {
    const Vec3 place = Vec3(0.3, -0.7, 0.2) * stiffness, beside = place + Vec3(1.1, 0.4, -0.6);
    for (const int end : {0, 1}) {
      MUELLE_LABEL(fmt::format("force on {} where both nodes are at one place, against yours where they are apart",
                               end == 0 ? "na" : "nb"),
                   "N");
      EXPECT_VECTOR_NEAR(own(place, place, stiffness, end), own(place, beside, stiffness, end), inStructure(stiffness));
    }
  }
}

TEST(CalcForce, LeavesTheForceOnNa) {
  MUELLE_PROPERTY("after calcForce, F is the force on na, whatever it was before");
  for (const SpringCase& s : someSpringCases()) {
    for (const ForceLaw& law : {hooke, strange}) {
      EXPECT_VECTOR_NEAR(submission::calcForce(s.xa, s.xb, s.stiffness, s.length, law),
                         oracle::calcForce(s.xa, s.xb, s.stiffness, s.length, law), inRounding(s.scale()));
    }
  }
}

TEST(CalcAcceleration, IsForceByMass) {
  MUELLE_PROPERTY("after calcAcceleration, a is F / mass, whatever it was before");
  Random random = testRandom();
  for (const double mass : {1e-6, 0.034, threeDigits(random.positive(1.1, 9.0)), 73.0, 1e6}) {
    for (const double size : {0.3, 70.0}) {
      const Vec3 F = threeDigits(random.vector3(size));
      EXPECT_VECTOR_NEAR(submission::calcAcceleration(mass, F), oracle::calcAcceleration(mass, F),
                         inRounding(size / mass));
    }
  }
}

// --- the two programs -----------------------------------------------------------------------------------------------

TEST(Gather, SumsTheForcesOfTheSpringsOfEachNode) {
  MUELLE_PROPERTY("after gather, F of each node is the sum over its springs, and a is F / mass");
  expectProgram(submittedGather, rightGather);
}

TEST(Gather, HoldsForEveryBody) {
  MUELLE_PROPERTY("gather holds without nodes or springs and with many, for light and heavy nodes and any spring");
  expectEnds(submittedGather, rightGather);
}

TEST(Gather, CountsSmallForces) {
  MUELLE_PROPERTY("however small the forces of a law are, gather adds them up");
  expectSmallForces(submittedGather, rightGather);
}

TEST(Scatter, CountsSmallForces) {
  MUELLE_PROPERTY("however small the forces of a law are, scatter adds them up");
  expectSmallForces(submittedScatter, rightScatter);
}

TEST(Scatter, GivesEachForceToItsTwoNodes) {
  MUELLE_PROPERTY("after scatter, F of each node is the sum over its springs, and a is F / mass");
  expectProgram(submittedScatter, rightScatter);
}

TEST(Scatter, HoldsForEveryBody) {
  MUELLE_PROPERTY("scatter holds without nodes or springs and with many, for light and heavy nodes and any spring");
  expectEnds(submittedScatter, rightScatter);
}

namespace {

/// The simulator wants one spring between two nodes.
void takeOutParallels(Springs& springs) {
  std::map<std::pair<int, int>, int> seen;
  std::erase_if(springs, [&seen](const SpringData& s) { return seen[std::minmax({s.a, s.b})]++ > 0; });
}

/// The forces that the reference simulator finds in the net.
VecX engineForces(const Net& net) {
  muelle::engine::Model model;
  for (const NodeData& node : net.nodes) {
    model.nodes.emplace_back();
    model.nodes.back().x = node.x;
    model.nodes.back().m = node.mass;
  }
  for (const SpringData& s : net.springs) {
    model.springs.emplace_back();
    model.springs.back().a = s.a;
    model.springs.back().b = s.b;
    model.springs.back().k = s.stiffness;
    model.springs.back().L0 = s.length;
  }
  const auto system = muelle::engine::build(model);
  const muelle::State state = system->initialState();
  std::vector<double> f(state.x.size());
  system->force(0, state.x, state.v, state.z, f);
  VecX forces(3 * static_cast<Eigen::Index>(net.nodes.size()));
  for (Eigen::Index i = 0; i < forces.size(); ++i) {
    forces[i] = f[place(system->lane(static_cast<int>(i / 3), static_cast<int>(i % 3)))];
  }
  return forces;
}

}  // namespace

TEST(Scatter, GivesTheForcesOfTheSimulator) {
  MUELLE_PROPERTY("with Hooke's law, scatter gives the forces of the reference simulator");
  Random random = testRandom();
  for (const int count : {3, 7, 12}) {
    Net net = someNet(random, count);
    net.nodes.resize(place(3 + count / 3));
    takeOutParallels(net.springs);
    // Given a student's own calcForce, the oracle's forces are not the simulator's, and so need not be the student's.
    const VecX given = forcesOf(rightScatter(net, hooke)), simulated = engineForces(net);
    const bool isGiven = (given - simulated).norm() > inStructure(net.scale());
    MUELLE_LABEL(fmt::format("F of {} nodes, one after the other", net.nodes.size()), "N");
    EXPECT_VECTOR_NEAR(forcesOf(submittedScatter(net, hooke)), isGiven ? given : simulated, inRounding(net.scale()));
  }
}

TEST(BothAlike, GiveTheSameForces) {
  MUELLE_PROPERTY("gather and scatter give each node the same force");
  MUELLE_EXPECT_OF_USE(gather);
  MUELLE_EXPECT_OF_USE(scatter);
  Random random = testRandom();
  for (const int count : {1, 2, 4, 7, 12}) {
    const Net net = someNet(random, count);
    // The oracle's difference is zero, but where the one is judged by a getForce that the other does not use.
    const VecX expected = forcesOf(rightGather(net, hooke)) - forcesOf(rightScatter(net, hooke));
    const VecX gathered = forcesOf(submittedGather(net, hooke)), scattered = forcesOf(submittedScatter(net, hooke));
    {
      MUELLE_LABEL("components of F in your gather, against your scatter");
      ASSERT_NUMBER_NEAR(static_cast<double>(gathered.size()), static_cast<double>(scattered.size()), 0);
    }
    MUELLE_LABEL(fmt::format("F of {} nodes, one after the other: your gather minus your scatter", net.nodes.size()),
                 "N");
    EXPECT_VECTOR_NEAR(VecX(gathered - scattered), expected, inStructure(net.scale()));
  }
}

// --- Questions: how often the law is asked --------------------------------------------------------------------------

namespace {

void expectQuestions(const std::string& name, const Program& own, int perSpring) {
  Random random = testRandom();
  for (const int count : {1, 3, 9, 40}) {
    const Net net = someNet(random, count);
    const CountedLaw counted;
    (void)own(net, counted.law());
    {
      MUELLE_LABEL(fmt::format("questions to the law in {} with {} springs", name, count));
      ASSERT_NUMBER_NEAR(counted.questions(), perSpring * count, 0);
    }
    for (const SpringData& s : net.springs) {
      MUELLE_LABEL(fmt::format("questions in {} to the spring of {} N/m", name, s.stiffness));
      ASSERT_NUMBER_NEAR((*counted.asked)[s.stiffness], perSpring, 0);
    }
  }
}

}  // namespace

TEST(Questions, GatherAsksEachSpringTwice) {
  MUELLE_PROPERTY("in gather the law of each spring is asked twice, once for either end");
  MUELLE_EXPECT_ANSWERS(gather);
  expectQuestions("gather", submittedGather, 2);
}

TEST(Questions, ScatterAsksEachSpringOnce) {
  MUELLE_PROPERTY("in scatter the law of each spring is asked once, for both ends");
  MUELLE_EXPECT_ANSWERS(scatter);
  expectQuestions("scatter", submittedScatter, 1);
}

// --- AtRest ---------------------------------------------------------------------------------------------------------

namespace {

/// A frame of 0.3 x 0.4 m: its sides pull, its diagonals push, and at each corner the forces add up to zero. Each side
/// pulls with 10 N a metre of its length, each diagonal pushes with as much: (40, 0.225), (25, 0.24), (20, 0.75).
Net frameAtRest(const Mat3& turn, const Vec3& shift) {
  Net net;
  for (const Vec3& corner : {Vec3(0, 0, 0), Vec3(0.3, 0, 0), Vec3(0.3, 0.4, 0), Vec3(0, 0.4, 0)}) {
    net.nodes.push_back({0.37 + 0.11 * static_cast<double>(net.nodes.size()), tidy(Vec3(turn * corner + shift), 1e6)});
  }
  net.springs = {{0, 1, 40, 0.225}, {2, 1, 25, 0.24}, {2, 3, 40, 0.225},
                 {3, 0, 25, 0.24},  {0, 2, 20, 0.75}, {3, 1, 20, 0.75}};
  return net;
}

void expectAtRest(const std::string& name, const Program& own, const Program& right) {
  for (int i = 0; i < 3; ++i) {
    const Net net = frameAtRest(someTurn(i), Vec3(0.3, -0.2, 0.7) * i);
    const Results got = own(net, hooke), expected = right(net, hooke);
    {
      MUELLE_LABEL("nodes that come back");
      ASSERT_NUMBER_NEAR(static_cast<double>(got.size()), 4, 0);
    }
    for (std::size_t node = 0; node < got.size(); ++node) {
      MUELLE_LABEL(fmt::format("F of node {} of a body at rest in {}", node, name), "N");
      // The places of the corners are rounded to 1e-6 m: 1e-6 m times 40 N/m, twice.
      EXPECT_VECTOR_NEAR(got[node].F, expected[node].F, 1e-4);
    }
  }
}

}  // namespace

TEST(AtRest, NoForceIsLeftAfterGather) {
  MUELLE_PROPERTY("in a body that is strained and does not move, the forces of gather add up to zero at each node");
  MUELLE_EXPECT_OF_USE(gather);
  expectAtRest("gather", submittedGather, rightGather);
}

TEST(AtRest, NoForceIsLeftAfterScatter) {
  MUELLE_PROPERTY("in a body that is strained and does not move, the forces of scatter add up to zero at each node");
  MUELLE_EXPECT_OF_USE(scatter);
  expectAtRest("scatter", submittedScatter, rightScatter);
}
