#include "property_forces.h"

#include "course/testing/expect.h"
#include "course/testing/random.h"
#include "engine/forces/property.h"
#include "grader/testing/ladders.h"
#include "grader/testing/motion.h"
#include "grader/testing/of_use.h"
#include "grader/testing/plain_numbers.h"
#include "harness/function_system.h"
#include "harness/march.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <limits>

using muelle::FunctionSystem;
using muelle::In;
using muelle::Mat3;
using muelle::Out;
using muelle::Random;
using muelle::testRandom;
using muelle::threeDigits;
using muelle::Trajectory;
using muelle::grader::exactLengthLadder;
using muelle::grader::lengthLadder;
using muelle::grader::someTurn;
using muelle::grader::stiffnessLadder;
using muelle::grader::tidy;

namespace {

constexpr double smallest = 1e-100;  // [m], of the contract
constexpr int most = 40;             // nodes, of the contract

/// A tolerance for values: sums of 40 numbers in any order, some 100 roundings of 1.1e-16, are 1e-14 of the numbers
/// involved; the best central difference is off by 4e-11, single precision by 6e-8.
double inRounding(double scale) { return 1e-13 * scale; }

/// A tolerance for laws, which are about structure and not about digits: a derivative by differences, or single
/// precision, breaks none of them. It loses the criterion of its values.
double inStructure(double scale) { return 1e-6 * scale; }

Eigen::Index place(int node) { return 3 * static_cast<Eigen::Index>(node); }

VecX stacked(const std::vector<Vec3>& nodes) {
  VecX x(place(static_cast<int>(nodes.size())));
  for (std::size_t i = 0; i < nodes.size(); ++i) x.segment<3>(place(static_cast<int>(i))) = nodes[i];
  return x;
}

VecX numbers(const std::vector<double>& list) {
  return Eigen::Map<const VecX>(list.data(), static_cast<Eigen::Index>(list.size()));
}

/// The block of a node; not a number where an answer is too short for it.
Vec3 nodeOf(const VecX& stack, int node) {
  if (stack.size() < place(node) + 3) return Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
  return stack.segment<3>(place(node));
}

/// Nodes somewhere, and what they are led to.
struct Case {
  VecX x;
  VecX m;
  double h0, R0, k;

  int count() const { return static_cast<int>(m.size()); }
  double farthest() const { return x.cwiseAbs().maxCoeff(); }
  double heightScale() const { return farthest() + std::abs(h0); }
  double radius() const { return oracle::spread(x, m); }
  /// What the spread may be off by, over the rounding of 1: far from the origin differences lose digits, by 1.1e-16 of
  /// the coordinates each.
  double spreadScale() const { return radius() + 0.03 * farthest(); }
  /// The same for the gradient, whose entries are 1 at most.
  double gradientScale() const { return 1 + 0.1 * farthest() / radius(); }
};

/// No two within a twentieth of each other, none whole.
VecX someMasses(Random& random, int count) {
  VecX m(count);
  for (int i = 0; i < count; ++i) m[i] = threeDigits(3.1 + 0.57 * ((11 * i) % count) + random.number(0.0, 0.5));
  return m;
}

/// Nodes above and below the ground, about a point that is not the origin; no two are near each other where there are
/// few. \param turn which side of the target they are on: in turn above and below, too wide and too narrow
Case anyCase(Random& random, int count, int turn) {
  Case c;
  const Vec3 middle = random.vector3(0.6) + Vec3(0.8, -0.9, 0.7);
  std::vector<Vec3> nodes;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * M_PI * i / count + random.number(0.0, 0.6);
    const Vec3 outwards(1.7 * std::cos(angle), 1.4 * std::sin(angle), i % 2 == 0 ? -1.9 : 1.3);
    nodes.push_back(tidy(Vec3(middle + outwards + random.vector3(0.3))));
  }
  c.x = stacked(nodes);
  c.m = someMasses(random, count);
  const double away = random.number(0.2, 1.7);
  c.h0 = threeDigits(oracle::meanHeight(c.x) + (turn % 2 == 0 ? away : -away));
  const double ratio = random.number(1.2, 2.5);
  c.R0 = threeDigits((turn / 2) % 2 == 0 ? c.radius() * ratio : c.radius() / ratio);
  c.k = threeDigits(random.positive(20.0, 150.0));
  return c;
}

/// Of two nodes first: what goes wrong can be checked on paper.
std::vector<Case> someCases(Random& random) {
  std::vector<Case> cases;
  for (const int count : {2, 2, 3, 3, 4, 5, 9}) cases.push_back(anyCase(random, count, static_cast<int>(cases.size())));
  return cases;
}

Case movedBy(Case c, const Vec3& way) {
  for (int i = 0; i < c.count(); ++i) c.x.segment<3>(place(i)) = tidy(Vec3(nodeOf(c.x, i) + way));
  return c;
}

/// Hundreds of metres from the origin.
Case farCase(Random& random, int count) { return movedBy(anyCase(random, count, count), Vec3(731.4, -612.9, 548.3)); }

Case sized(Case c, double size) {
  for (double& coordinate : c.x) coordinate = threeDigits(size * coordinate);
  return c;
}

/// Every stiffness with every target, the ends of the contract among them, small classes and large ones.
std::vector<Case> casesOfTheWholeRange() {
  std::vector<Case> cases;
  const VecX x = stacked({Vec3(-0.41, 0.23, 0.17), Vec3(0.37, 1, -0.29), Vec3(0.13, -0.43, 0.83)});
  struct Targets {
    double h0, R0;
  };
  for (const double k : stiffnessLadder) {
    for (const Targets& to : {Targets{-1000, 0}, Targets{0, 0.043}, Targets{0.037, 1.7}, Targets{1000, 1000}}) {
      for (const double size : {0.1, 7.0, 1000.0}) {
        cases.push_back(sized({x, numbers({2.3, 0.71, 1.4}), to.h0, to.R0, k}, size));
      }
    }
  }
  for (const VecX& m : {numbers({1e-6, 1.7e-6, 1.3e-6}), numbers({1e6, 0.7e6, 0.3e6}), numbers({1e-6, 0.37, 1e6})}) {
    cases.push_back({x, m, 0.71, 0.53, 83.0});
  }
  return cases;
}

/// From one node to the most.
std::vector<Case> casesOfEveryCount(Random& random, int fewest) {
  std::vector<Case> cases;
  for (const int count : {1, 2, 7, 17, most}) {
    if (count >= fewest) cases.push_back(anyCase(random, count, static_cast<int>(cases.size())));
  }
  return cases;
}

/// Mean heights that are 2^-n m above or below the target, exactly; at the target itself first.
std::vector<Case> nearlyAtTheHeight() {
  std::vector<Case> cases;
  const VecX x = stacked({Vec3(0.3, -0.7, 1.25), Vec3(-1.1, 0.4, 2.75)});
  cases.push_back({x, numbers({1.3, 2.1}), 2.0, 1.0, 57.0});
  for (const double away : exactLengthLadder()) {
    if (away < 1e-12) break;
    cases.push_back({x, numbers({1.3, 2.1}), 2.0 + away, 1.0, 57.0});
    cases.push_back({x, numbers({1.3, 2.1}), 2.0 - away, 1.0, 57.0});
  }
  return cases;
}

/// A spread of 2 m, to the last bit, that is 2^-n m off the target; at the target itself first.
std::vector<Case> nearlyAtTheSpread() {
  std::vector<Case> cases;
  const VecX x = stacked({Vec3(0, -4, 0), Vec3(0, 1, 0)});
  cases.push_back({x, numbers({1, 4}), 2.0, 2.0, 57.0});
  for (const double away : exactLengthLadder()) {
    if (away < 1e-12) break;
    cases.push_back({x, numbers({1, 4}), 2.0, 2.0 + away, 57.0});
    cases.push_back({x, numbers({1, 4}), 2.0, 2.0 - away, 57.0});
  }
  return cases;
}

double ownHeightEnergy(const Case& c) { return submission::meanHeightEnergy(c.x, c.h0, c.k); }
VecX ownHeightForce(const Case& c) { return submission::meanHeightForce(c.x, c.h0, c.k); }
double ownSpreadEnergy(const Case& c) { return submission::spreadEnergy(c.x, c.m, c.R0, c.k); }
VecX ownSpreadForce(const Case& c) { return submission::spreadForce(c.x, c.m, c.R0, c.k); }

void expectHeight(const Case& c) {
  EXPECT_NUMBER_NEAR(submission::meanHeight(c.x), oracle::meanHeight(c.x), inRounding(c.farthest()));
}
void expectHeightEnergy(const Case& c) {
  EXPECT_NUMBER_NEAR(submission::meanHeightEnergy(c.x, c.h0, c.k), oracle::meanHeightEnergy(c.x, c.h0, c.k),
                     inRounding(c.k * c.heightScale() * c.heightScale()));
}
void expectHeightForce(const Case& c) {
  EXPECT_VECTOR_NEAR(submission::meanHeightForce(c.x, c.h0, c.k), oracle::meanHeightForce(c.x, c.h0, c.k),
                     inRounding(c.k * c.heightScale()));
}
void expectSpread(const Case& c) {
  EXPECT_NUMBER_NEAR(submission::spread(c.x, c.m), oracle::spread(c.x, c.m), inRounding(c.spreadScale()));
}
void expectGradient(const Case& c) {
  EXPECT_VECTOR_NEAR(submission::spreadGradient(c.x, c.m), oracle::spreadGradient(c.x, c.m),
                     inRounding(c.gradientScale()));
}
void expectSpreadEnergy(const Case& c) {
  EXPECT_NUMBER_NEAR(submission::spreadEnergy(c.x, c.m, c.R0, c.k), oracle::spreadEnergy(c.x, c.m, c.R0, c.k),
                     inRounding(c.k * (c.radius() + c.R0) * (c.spreadScale() + c.R0)));
}
void expectSpreadForce(const Case& c) {
  EXPECT_VECTOR_NEAR(submission::spreadForce(c.x, c.m, c.R0, c.k), oracle::spreadForce(c.x, c.m, c.R0, c.k),
                     inRounding(c.k * (c.spreadScale() + c.R0) * c.gradientScale()));
}

}  // namespace

// --- MeanHeight -----------------------------------------------------------------------------------------------------

TEST(MeanHeight, IsTheSumOfTheHeightsOverTheirNumber) {
  MUELLE_PROPERTY("the mean height is the sum of the heights over the number of nodes, wherever these are");
  Random random = testRandom();
  for (const Case& c : someCases(random)) expectHeight(c);
  for (const Case& c : casesOfEveryCount(random, 1)) expectHeight(c);
  for (const int count : {2, 5}) expectHeight(farCase(random, count));
  for (const Case& c : casesOfTheWholeRange()) expectHeight(c);
}

namespace {

/// The property of the reference simulator, on the heights of so many nodes.
muelle::engine::Property heightOfTheEngine(int count, double k, double h0) {
  std::vector<muelle::engine::Property::Entry> entries;
  for (int i = 0; i < count; ++i) entries.push_back({3 * i + 2, 3 * i + 2, 1.0 / count});
  return {entries, k, h0, 0};
}

}  // namespace

TEST(MeanHeight, IsWhatTheReferenceSimulatorHolds) {
  MUELLE_PROPERTY("the mean height is the one that a force of the property leads to its target");
  Random random = testRandom();
  for (const int count : {2, 3, 6}) {
    const Case c = anyCase(random, count, count);
    const muelle::engine::Configuration at{.x = c.x.data()};
    VecX pull = VecX::Zero(c.x.size());
    heightOfTheEngine(count, 1.0, 0.0).addForce(at, pull.data());
    EXPECT_NUMBER_NEAR(submission::meanHeight(c.x), -pull.sum(), inRounding(c.farthest()));
    // What is expected elsewhere is what the simulator says.
    VecX force = VecX::Zero(c.x.size());
    const muelle::engine::Property property = heightOfTheEngine(count, c.k, c.h0);
    property.addForce(at, force.data());
    ASSERT_LE((force - oracle::meanHeightForce(c.x, c.h0, c.k)).norm(), inRounding(c.k * c.heightScale()));
    ASSERT_LE(std::abs(property.energy(at) - oracle::meanHeightEnergy(c.x, c.h0, c.k)),
              inRounding(c.k * c.heightScale() * c.heightScale()));
  }
}

// --- MeanHeightEnergy -----------------------------------------------------------------------------------------------

TEST(MeanHeightEnergy, GrowsWithTheSquareOfTheDistance) {
  MUELLE_PROPERTY("the energy is half of k times the square of what the mean height is above or below its target");
  Random random = testRandom();
  for (const Case& c : someCases(random)) expectHeightEnergy(c);
  for (const Case& c : casesOfEveryCount(random, 1)) expectHeightEnergy(c);
}

TEST(MeanHeightEnergy, HoldsForEveryStiffnessAndTarget) {
  MUELLE_PROPERTY("the energy is right for any k and any target, 0 and below too, and is 0 at the target");
  for (const Case& c : nearlyAtTheHeight()) expectHeightEnergy(c);
  for (const Case& c : casesOfTheWholeRange()) expectHeightEnergy(c);
}

// --- MeanHeightForce ------------------------------------------------------------------------------------------------

TEST(MeanHeightForce, IsMinusTheGradient) {
  MUELLE_PROPERTY("each node feels the same vertical force, -k (mean height - h0) times its share 1/n of the mean");
  Random random = testRandom();
  for (const Case& c : someCases(random)) expectHeightForce(c);
  for (const Case& c : casesOfEveryCount(random, 1)) expectHeightForce(c);
}

TEST(MeanHeightForce, HoldsForEveryStiffnessAndTarget) {
  MUELLE_PROPERTY("the force is right for any k and any target, 0 and below too, and is 0 at the target alone");
  for (const Case& c : nearlyAtTheHeight()) expectHeightForce(c);
  for (const Case& c : casesOfTheWholeRange()) expectHeightForce(c);
}

// --- Spread ---------------------------------------------------------------------------------------------------------

TEST(Spread, IsTheRootOfTheMeanSquareDistance) {
  MUELLE_PROPERTY("the spread is the root of sum m |x - c|^2 over the total mass, with c the centre of mass");
  Random random = testRandom();
  for (const Case& c : someCases(random)) expectSpread(c);
  for (const Case& c : casesOfEveryCount(random, 2)) expectSpread(c);
  for (const int count : {2, 3, 4, 5}) expectSpread(farCase(random, count));
}

TEST(Spread, HoldsForEveryMassAndSize) {
  MUELLE_PROPERTY("the spread is right for the lightest and the heaviest nodes, small classes and large ones");
  for (const Case& c : casesOfTheWholeRange()) expectSpread(c);
}

// --- SpreadGradient -------------------------------------------------------------------------------------------------

TEST(SpreadGradient, SaysHowTheSpreadGrows) {
  MUELLE_PROPERTY("each component is what the spread grows by when that component of x does: m (x - c) / (M R) a node");
  Random random = testRandom();
  for (const Case& c : someCases(random)) expectGradient(c);
  for (const Case& c : casesOfEveryCount(random, 2)) expectGradient(c);
  for (const int count : {2, 4}) expectGradient(farCase(random, count));
}

TEST(SpreadGradient, HoldsForEveryMassAndSize) {
  MUELLE_PROPERTY("the gradient is right for the lightest and the heaviest nodes, small classes and large ones");
  for (const Case& c : casesOfTheWholeRange()) expectGradient(c);
}

// --- SpreadEnergy ---------------------------------------------------------------------------------------------------

TEST(SpreadEnergy, GrowsWithTheSquareOfTheDistance) {
  MUELLE_PROPERTY("the energy is half of k times the square of what the spread is above or below its target");
  Random random = testRandom();
  for (const Case& c : someCases(random)) expectSpreadEnergy(c);
  for (const Case& c : casesOfEveryCount(random, 2)) expectSpreadEnergy(c);
}

TEST(SpreadEnergy, HoldsForEveryStiffnessAndTarget) {
  MUELLE_PROPERTY("the energy is right for any k, any masses and any target, 0 too, and is 0 at the target");
  for (const Case& c : nearlyAtTheSpread()) expectSpreadEnergy(c);
  for (const Case& c : casesOfTheWholeRange()) expectSpreadEnergy(c);
}

// --- SpreadForce ----------------------------------------------------------------------------------------------------

TEST(SpreadForce, IsMinusTheGradient) {
  MUELLE_PROPERTY(
      "the force is -k (spread - R0) times the gradient of the spread: inwards when the spread is too large");
  Random random = testRandom();
  for (const Case& c : someCases(random)) expectSpreadForce(c);
  for (const Case& c : casesOfEveryCount(random, 2)) expectSpreadForce(c);
}

TEST(SpreadForce, HoldsForEveryStiffnessAndTarget) {
  MUELLE_PROPERTY("the force is right for any k, any masses and any target, 0 too, and is 0 at the target alone");
  for (const Case& c : nearlyAtTheSpread()) expectSpreadForce(c);
  for (const Case& c : casesOfTheWholeRange()) expectSpreadForce(c);
}

// --- MinusTheGradient: the student's own energies and forces
// ----------------------------------------------------------

namespace {

/// Central differences of an energy in all components.
template <class Energy>
VecX slopes(const Case& c, const Energy& energy, double h) {
  VecX slope(c.x.size());
  for (Eigen::Index i = 0; i < slope.size(); ++i) {
    Case forward = c, backward = c;
    forward.x[i] += h;
    backward.x[i] -= h;
    slope[i] = (energy(forward) - energy(backward)) / (forward.x[i] - backward.x[i]);
  }
  return slope;
}

constexpr double step = 1e-4;  // [m], of the differences

}  // namespace

TEST(MinusTheGradient, OfTheEnergyOfTheMeanHeight) {
  MUELLE_PROPERTY(
      "each component of meanHeightForce is minus the slope of meanHeightEnergy when that component of x moves");
  MUELLE_EXPECT_ANSWERS(meanHeightEnergy);
  MUELLE_EXPECT_ANSWERS(meanHeightForce);
  Random random = testRandom();
  for (int turn = 0; turn < 4; ++turn) {
    const Case c = anyCase(random, 2 + turn, turn);
    // The energy is a square: central differences have no error but rounding, 1e-15 of the energy over the step.
    MUELLE_LABEL("minus the slope of your meanHeightEnergy, where your meanHeightForce is expected", "N");
    EXPECT_VECTOR_NEAR(VecX(-slopes(c, ownHeightEnergy, step)), ownHeightForce(c), inStructure(c.k * c.heightScale()));
  }
}

TEST(MinusTheGradient, OfTheEnergyOfTheSpread) {
  MUELLE_PROPERTY("each component of spreadForce is minus the slope of spreadEnergy when that component of x moves");
  MUELLE_EXPECT_ANSWERS(spreadEnergy);
  MUELLE_EXPECT_ANSWERS(spreadForce);
  Random random = testRandom();
  for (int turn = 0; turn < 4; ++turn) {
    const Case c = anyCase(random, 2 + turn, turn);
    // R''' is 3 / R^2 at most, and R above 1 m: the error is h^2 / 6 k (R + R0) 3 / R^2, 5e-9 of the scale.
    MUELLE_LABEL("minus the slope of your spreadEnergy, where your spreadForce is expected", "N");
    EXPECT_VECTOR_NEAR(VecX(-slopes(c, ownSpreadEnergy, step)), ownSpreadForce(c),
                       inStructure(c.k * (c.radius() + c.R0)));
  }
}

// --- NoNetForce -----------------------------------------------------------------------------------------------------

namespace {

Vec3 sumOf(const VecX& F, int count) {
  Vec3 sum = Vec3::Zero();
  for (int i = 0; i < count; ++i) sum += nodeOf(F, i);
  return sum;
}

}  // namespace

TEST(NoNetForce, OfTheSpread) {
  MUELLE_PROPERTY("moving everybody by the same way changes no spread: its forces add up to zero");
  MUELLE_EXPECT_ANSWERS(spreadForce);
  Random random = testRandom();
  for (const int count : {2, 3, 4, 7}) {
    const Case c = anyCase(random, count, count);
    const VecX F = ownSpreadForce(c);
    MUELLE_LABEL("sum of the forces of the spread on all nodes", "N");
    EXPECT_VECTOR_NEAR(sumOf(F, count), Vec3(Vec3::Zero()), inStructure(F.norm()));
  }
}

TEST(NoNetForce, NorTorqueOfTheSpread) {
  MUELLE_PROPERTY("turning everybody about a point changes no spread: the torques of its forces add up to zero");
  MUELLE_EXPECT_ANSWERS(spreadForce);
  Random random = testRandom();
  for (const int count : {2, 3, 4, 7}) {
    const Case c = anyCase(random, count, count);
    const VecX F = ownSpreadForce(c);
    Vec3 torque = Vec3::Zero();
    for (int i = 0; i < count; ++i) torque += nodeOf(c.x, i).cross(nodeOf(F, i));
    MUELLE_LABEL("sum of the torques of the forces of the spread about the origin", "N m");
    EXPECT_VECTOR_NEAR(torque, Vec3(Vec3::Zero()), inStructure(F.norm() * c.x.norm()));
  }
}

// --- Equivariance ---------------------------------------------------------------------------------------------------

namespace {

/// The blocks of all nodes turned; those of forces to the last digit, places to few.
VecX turned(const VecX& stack, const Mat3& rotation, int count) {
  VecX there(place(count));
  for (int i = 0; i < count; ++i) there.segment<3>(place(i)) = rotation * nodeOf(stack, i);
  return there;
}

/// The last node comes first.
VecX renumbered(const VecX& stack, int count) {
  VecX there(place(count));
  for (int i = 0; i < count; ++i) there.segment<3>(place(i)) = nodeOf(stack, (i + count - 1) % count);
  return there;
}

Case renumbered(const Case& c) {
  Case there = c;
  there.x = renumbered(c.x, c.count());
  for (int i = 0; i < c.count(); ++i) there.m[i] = c.m[(i + c.count() - 1) % c.count()];
  return there;
}

}  // namespace

TEST(Equivariance, OfTheMeanHeight) {
  MUELLE_PROPERTY("moving the class sideways changes no force of the mean height; other numbers of the nodes neither");
  MUELLE_EXPECT_ANSWERS(meanHeightForce);
  Random random = testRandom();
  for (const int count : {2, 3, 5}) {
    const Case c = anyCase(random, count, count);
    const VecX F = ownHeightForce(c);
    const Case beside = movedBy(c, Vec3(random.rounded(3, 8), random.rounded(-8, -3), 0));
    {
      MUELLE_LABEL("forces of the mean height after the class has moved sideways", "N");
      EXPECT_VECTOR_NEAR(ownHeightForce(beside), F, inStructure(F.norm()));
    }
    MUELLE_LABEL("forces of the mean height with the last node numbered first", "N");
    EXPECT_VECTOR_NEAR(ownHeightForce(renumbered(c)), renumbered(F, count), inStructure(F.norm()));
  }
}

TEST(Equivariance, OfTheSpread) {
  MUELLE_PROPERTY("the forces of the spread stay when the class moves, turn when it turns, and keep to their nodes");
  MUELLE_EXPECT_ANSWERS(spreadForce);
  Random random = testRandom();
  for (int i = 0; i < 4; ++i) {
    const Case c = anyCase(random, 2 + i, i);
    const VecX F = ownSpreadForce(c);
    const Case there = movedBy(c, Vec3(random.rounded(3, 8), random.rounded(-8, -3), random.rounded(3, 8)));
    Case about = c;
    about.x = turned(c.x, someTurn(i), c.count());
    for (double& coordinate : about.x) coordinate = tidy(coordinate, 1e5);
    {
      MUELLE_LABEL("forces of the spread after the class has moved", "N");
      EXPECT_VECTOR_NEAR(ownSpreadForce(there), F, inStructure(F.norm()));
    }
    {
      MUELLE_LABEL("forces of the spread after the class is turned", "N");
      EXPECT_VECTOR_NEAR(ownSpreadForce(about), turned(F, someTurn(i), c.count()), inStructure(F.norm()));
    }
    MUELLE_LABEL("forces of the spread with the last node numbered first", "N");
    EXPECT_VECTOR_NEAR(ownSpreadForce(renumbered(c)), renumbered(F, c.count()), inStructure(F.norm()));
  }
}

// --- edges: partial, one test a function
// ------------------------------------------------------------------------------

namespace {

constexpr double largestTarget = 1000.0;  // [m], of the contract

/// All nodes at one point, with masses whose sum is a power of two.
std::vector<Case> classesAtOnePoint() {
  std::vector<Case> cases;
  const auto add = [&](const std::vector<double>& m, const Vec3& point) {
    cases.push_back({stacked(std::vector<Vec3>(m.size(), point)), numbers(m), 2.0, largestTarget, 57.0});
  };
  add({1, 1}, Vec3(0, 0, 0));
  add({1, 1}, Vec3(0.5, -1.25, 2));
  add({2, 4, 2}, Vec3(-1.5, 0.75, 0.25));
  add({0.25}, Vec3(0.5, -1.25, 2));
  add({4}, Vec3(-96, 64.5, -32));
  add(std::vector<double>(32, 0.25), Vec3(1.5, -0.5, 0.75));
  return cases;
}

/// The nodes moved a little, to either side by turns.
Case nearby(Case c, double way) {
  for (int i = 0; i < c.count(); ++i) c.x.segment<3>(place(i)) += (i % 2 == 0 ? way : -way) * Vec3(0.2, -0.3, 0.6);
  return c;
}

std::string pointOf(const Case& c) {
  const Vec3 at = nodeOf(c.x, 0);
  return fmt::format("{} node{} at ({:g}, {:g}, {:g})", c.count(), c.count() > 1 ? "s" : "", at[0], at[1], at[2]);
}

/// Three nodes about the origin, along no axis; the spread is 1 m times the size, about.
Case aboutTheOrigin(double size) {
  return {size * stacked({Vec3(0.7, -0.4, 0.9), Vec3(-0.8, 0.3, -0.5), Vec3(0.2, 0.6, -0.7)}), numbers({1.3, 2.1, 0.9}),
          2.0, largestTarget, 57.0};
}

/// Two nodes away from the origin, exactly (2, -3, 6) 2^-n m to either side of a point.
Case aboutAPoint(double unit) {
  const Vec3 point(1.25, -1.75, 1.5);
  return {stacked({Vec3(point + unit * Vec3(2, -3, 6)), Vec3(point - unit * Vec3(2, -3, 6))}), numbers({2, 2}), 2.0,
          largestTarget, 57.0};
}

/// Whether answers for a class and a smaller one are the same, but for a hundredth; else they are wrong at any size.
bool isSteady(const VecX& at, const VecX& below) {
  return at.size() == below.size() && at.norm() > 0 && (at - below).norm() < 0.01 * at.norm();
}

/// What `steady` gives for small classes is expected to be what it gives for large ones.
template <class Steady>
void expectSteady(const std::string& what, const std::string& unit, const Steady& steady) {
  // With R0 = 1000 m a spread of 0.1 m, or twice that for a mistaken one, is less than a thousandth.
  const double tolerance = 3e-3;
  const auto beside = [&](double size) { return steady(aboutTheOrigin(size), size); };
  const VecX large = beside(0.1);
  if (isSteady(large, beside(0.01))) {
    for (const double size : lengthLadder(smallest)) {
      if (size > 0.1) continue;
      MUELLE_LABEL(fmt::format("{}, of a class of {:.2g} m, expected about as with 0.1 m", what, size), unit);
      EXPECT_VECTOR_NEAR(beside(size), large, tolerance * large.norm());
    }
  }
  const auto away = [&](double size) { return steady(aboutAPoint(size), 7 * size); };
  std::vector<double> units = exactLengthLadder();
  units.erase(units.begin());
  const VecX first = away(units[0]);
  if (!isSteady(first, away(units[1]))) return;
  for (const double size : units) {
    MUELLE_LABEL(
        fmt::format("{}, of a class of {:.2g} m away from the origin, expected about as with 0.2 m", what, 7 * size),
        unit);
    EXPECT_VECTOR_NEAR(away(size), first, tolerance * first.norm());
  }
}

VecX one(double number) { return VecX::Constant(1, number); }

}  // namespace

TEST(OnePoint, HasNoSpread) {
  MUELLE_PROPERTY("the spread does not jump where all nodes come together, and a single node has one, too: zero");
  MUELLE_EXPECT_ANSWERS(spread);
  for (const Case& c : classesAtOnePoint()) {
    const Case near = nearby(c, 1e-6);
    MUELLE_LABEL("spread of " + pointOf(c) + ", expected about as with nodes a micrometre apart", "m");
    EXPECT_NUMBER_NEAR(submission::spread(c.x, c.m), submission::spread(near.x, near.m), 1e-4);
  }
}

TEST(OnePoint, HasNoGradient) {
  MUELLE_PROPERTY("where all nodes are at one point the gradient of the spread is zero, not NaN");
  MUELLE_EXPECT_ANSWERS(spreadGradient);
  for (const Case& c : classesAtOnePoint()) {
    EXPECT_VECTOR_NEAR(submission::spreadGradient(c.x, c.m), VecX(VecX::Zero(c.x.size())), inRounding(1));
  }
}

TEST(OnePoint, KeepsTheEnergyOfFullCompression) {
  MUELLE_PROPERTY("nodes at one point have the energy of a class squeezed to nothing, not none");
  MUELLE_EXPECT_ANSWERS(spreadEnergy);
  for (const Case& c : classesAtOnePoint()) {
    // A micrometre in 1000 m is a thousandth of a millionth.
    MUELLE_LABEL("energy of the spread of " + pointOf(c) + ", expected about as with nodes a micrometre apart", "J");
    EXPECT_NUMBER_NEAR(ownSpreadEnergy(c), ownSpreadEnergy(nearby(c, 1e-6)), 1e-4 * c.k * c.R0 * c.R0 / 2);
  }
}

TEST(OnePoint, HasNoForce) {
  MUELLE_PROPERTY("where all nodes are at one point the spread has no force, not NaN");
  MUELLE_EXPECT_ANSWERS(spreadForce);
  for (const Case& c : classesAtOnePoint()) {
    EXPECT_VECTOR_NEAR(submission::spreadForce(c.x, c.m, c.R0, c.k), VecX(VecX::Zero(c.x.size())),
                       inRounding(c.k * c.R0));
  }
}

TEST(TinySpread, IsInProportionToTheClass) {
  MUELLE_PROPERTY("a class that is smaller by any factor has a spread that is smaller by that factor");
  MUELLE_EXPECT_ANSWERS(spread);
  expectSteady("spread over size", "",
               [](const Case& c, double size) { return one(submission::spread(c.x, c.m) / size); });
}

TEST(TinySpread, HasAGradient) {
  MUELLE_PROPERTY("a spread above zero, 1e-9 m or 1e-100 m, has a gradient, as long as that of a large class");
  MUELLE_EXPECT_ANSWERS(spreadGradient);
  expectSteady("gradient of the spread", "",
               [](const Case& c, double) { return submission::spreadGradient(c.x, c.m); });
}

TEST(TinySpread, HasAnEnergy) {
  MUELLE_PROPERTY("the energy does not jump when a class gets smaller and smaller, down to 1e-100 m");
  MUELLE_EXPECT_ANSWERS(spreadEnergy);
  expectSteady("energy of the spread", "J", [](const Case& c, double) { return one(ownSpreadEnergy(c)); });
}

TEST(TinySpread, HasAForce) {
  MUELLE_PROPERTY("a spread above zero, 1e-9 m or 1e-100 m, has a force, as large as that of a large class");
  MUELLE_EXPECT_ANSWERS(spreadForce);
  expectSteady("force of the spread", "N", [](const Case& c, double) { return ownSpreadForce(c); });
}

// --- SwingingClass --------------------------------------------------------------------------------------------------

namespace {

/// Pupils who jump and fall; only their mean height is held. All that happens is a sum of forces, so it is followed to
/// the last digits: the tolerance allows what single precision leaves.
struct Pupils {
  VecX m;
  VecX x;
  std::vector<double> velocity;
  double h0, k;

  template <class Force>
  Trajectory jump(const Force& force) const {
    std::vector<double> mass;
    for (Eigen::Index c = 0; c < x.size(); ++c) mass.push_back(m[c / 3]);
    const FunctionSystem system(mass, [&](double, In at, In, Out f) {
      const VecX F = force(VecX(Eigen::Map<const VecX>(at.data(), x.size())), h0, k);
      const int count = static_cast<int>(m.size());
      for (int i = 0; i < count; ++i) muelle::node3(f, i) = nodeOf(F, i) + m[i] * Vec3(0, 0, -8.37);
    });
    muelle::MarchOptions options;
    options.h = 5e-3;
    options.duration = 2.0;  // [s], some one and a half swings
    options.outputEvery = 10;
    return muelle::march(system, {0.0, std::vector<double>(x.begin(), x.end()), velocity, {}}, options);
  }
};

}  // namespace

TEST(SwingingClass, SwingsAboutItsTarget) {
  MUELLE_PROPERTY("pupils of different masses jump and fall, and their mean height swings about its target");
  Random random = testRandom();
  Pupils pupils{numbers({31.3, 67.2, 43.7}),
                stacked({Vec3(0.3, 0.7, 1.43), Vec3(-0.6, 1.1, 2.17), Vec3(1.3, -0.4, 1.09)}),
                {0.3, -0.1, 3.9, -0.2, 0.1, 0.7, 0.1, 0.2, 2.6},
                2.13,
                random.rounded(4100, 4900)};
  const Trajectory run = pupils.jump(submission::meanHeightForce);
  const Trajectory reference = pupils.jump(oracle::meanHeightForce);
  muelle::grader::expectSameMotion(run, reference, 1e-4);
}
