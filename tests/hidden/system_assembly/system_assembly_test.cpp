#include "system_assembly.h"

#include "course/testing/expect.h"
#include "course/testing/random.h"
#include "course/testing/test_function.h"
#include "engine/model/model_system.h"
#include "grader/testing/ladders.h"
#include "grader/testing/of_use.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>

using muelle::MatX;
using muelle::Random;
using muelle::TestFunction;
using muelle::testRandom;
using muelle::grader::stiffnessLadder;

namespace {

using AskedEnergy = TestFunction<double(const Vec3&, const Vec3&, double, double)>;
using AskedGradient = TestFunction<Vec6(const Vec3&, const Vec3&, double, double)>;
using Springs = std::vector<Spring>;
using Counts = std::vector<std::pair<int, int>>;  ///< of nodes and springs

/// A tolerance for values: 600 terms added in any order are off by 600 roundings of 1.1e-16 at most, 7e-14 of the sum
/// of their sizes; single precision is off by 6e-8.
double inRounding(double scale) { return 1e-13 * scale; }

/// A tolerance for laws, which are about structure and not about digits: single precision breaks none of them.
double inStructure(double scale) { return 1e-5 * scale; }

// --- what one spring does -------------------------------------------------------------------------------------------

Vec6 stacked(const Vec3& a, const Vec3& b) {
  Vec6 both;
  both << a, b;
  return both;
}

/// A spring's energy and its gradient, as a test hands them out: each test has its own, which count for it alone.
struct Law {
  AskedEnergy energy;
  AskedGradient gradient;
};

/// Nobody's springs: with the nodes exchanged, or k and L0, they are others, and the halves are not opposite.
Law lopsided() {
  return {{"[](const Vec3& xa, const Vec3& xb, double k, double L0) { return 0.5 * k * (xa - xb).squaredNorm() + "
           "L0 * xa.dot(Vec3(3, 2, 4)); }",
           [](const Vec3& xa, const Vec3& xb, double k, double L0) {
             return 0.5 * k * (xa - xb).squaredNorm() + L0 * xa.dot(Vec3(3, 2, 4));
           }},
          {"[](const Vec3& xa, const Vec3& xb, double k, double L0) { Vec6 g; g << k * (xa - xb) + L0 * Vec3(3, 2, 4), "
           "k * (xb - xa); return g; }",
           [](const Vec3& xa, const Vec3& xb, double k, double L0) {
             return stacked(k * (xa - xb) + L0 * Vec3(3, 2, 4), k * (xb - xa));
           }}};
}

/// k (L^2 - L0^2)^2 / 8, whose halves are opposite.
Law opposite() {
  return {{"[](const Vec3& xa, const Vec3& xb, double k, double L0) { return k / 8 * "
           "std::pow((xa - xb).squaredNorm() - L0 * L0, 2); }",
           [](const Vec3& xa, const Vec3& xb, double k, double L0) {
             return k / 8 * std::pow((xa - xb).squaredNorm() - L0 * L0, 2);
           }},
          {"[](const Vec3& xa, const Vec3& xb, double k, double L0) { Vec6 g; g << xa - xb, xb - xa; "
           "return Vec6(k / 2 * ((xa - xb).squaredNorm() - L0 * L0) * g); }",
           [](const Vec3& xa, const Vec3& xb, double k, double L0) {
             return Vec6(k / 2 * ((xa - xb).squaredNorm() - L0 * L0) * stacked(xa - xb, xb - xa));
           }}};
}

/// The lecture's springs, which the reference simulator knows, too.
Law hookes() {
  return {{"[](const Vec3& xa, const Vec3& xb, double k, double L0) { return 0.5 * k * "
           "std::pow((xa - xb).norm() - L0, 2); }",
           [](const Vec3& xa, const Vec3& xb, double k, double L0) {
             return 0.5 * k * std::pow((xa - xb).norm() - L0, 2);
           }},
          {"[](const Vec3& xa, const Vec3& xb, double k, double L0) { Vec6 g; g << xa - xb, xb - xa; "
           "return Vec6(k * (1 - L0 / (xa - xb).norm()) * g); }",
           [](const Vec3& xa, const Vec3& xb, double k, double L0) {
             return Vec6(k * (1 - L0 / (xa - xb).norm()) * stacked(xa - xb, xb - xa));
           }}};
}

// --- systems --------------------------------------------------------------------------------------------------------

struct System {
  VecX x, m, F;
  Springs springs;

  Vec3 node(int i) const { return x.segment<3>(3 * i); }
  std::string name() const {
    return fmt::format("{} node{} and {} spring{}", m.size(), m.size() == 1 ? "" : "s", springs.size(),
                       springs.size() == 1 ? "" : "s");
  }
};

/// The sum of the sizes of what the springs say, which rounding is a part of.
double energySizes(const System& system, const SpringEnergy& energy) {
  double sum = 0;
  for (const Spring& s : system.springs) sum += std::abs(energy(system.node(s.a), system.node(s.b), s.k, s.L0));
  return sum;
}
double gradientSizes(const System& system, const SpringGradient& gradient) {
  double sum = 0;
  for (const Spring& s : system.springs) {
    sum += gradient(system.node(s.a), system.node(s.b), s.k, s.L0).cwiseAbs().maxCoeff();
  }
  return sum;
}

VecX someNumbers(Random& random, Eigen::Index count, double low, double high) {
  VecX numbers(count);
  for (double& number : numbers) number = random.rounded(low, high);
  return numbers;
}

VecX eitherSign(Random& random, VecX numbers) {
  for (double& number : numbers) number *= random.integer(0, 1) == 0 ? 1 : -1;
  return numbers;
}

Spring someSpring(Random& random, int nodes) {
  const int a = random.integer(0, nodes - 1);
  return {a, (a + random.integer(1, nodes - 1)) % nodes, random.rounded(11, 97), random.rounded(0.31, 1.43)};
}

System someSystem(Random& random, int nodes, int springs) {
  System system;
  system.x = eitherSign(random, someNumbers(random, 3 * nodes, 0.13, 1.9));
  system.m = someNumbers(random, nodes, 0.31, 2.9);
  system.F = eitherSign(random, someNumbers(random, 3 * nodes, 110, 970));
  for (int i = 0; i < springs; ++i) system.springs.push_back(someSpring(random, nodes));
  return system;
}

/// From two nodes and a spring to many; more springs than pairs of nodes; nodes without springs; no springs.
std::vector<System> someSystems() {
  Random random = testRandom();
  std::vector<System> systems;
  for (const auto& [nodes, springs] : Counts{{2, 1}, {3, 2}, {3, 3}, {4, 6}, {2, 3}, {5, 4}, {9, 3}, {7, 16}}) {
    systems.push_back(someSystem(random, nodes, springs));
  }
  return systems;
}

/// One node, which has nobody to be joined with.
System alone(Random& random) {
  System system;
  system.x = someNumbers(random, 3, 0.13, 1.9);
  system.m = someNumbers(random, 1, 0.31, 2.9);
  system.F = someNumbers(random, 3, 110, 970);
  return system;
}

/// Springs of micrometres that store next to nothing: their energy is as exact as any other.
System tiny(Random& random) {
  System system = someSystem(random, 4, 5);
  for (double& number : system.x) number = muelle::threeDigits(1e-7 * number);
  for (Spring& s : system.springs) s.k = 1e-3, s.L0 = 0;
  return system;
}

/// What the contract allows, to the ends.
std::vector<System> systemsOfTheWholeRange() {
  Random random = testRandom();
  std::vector<System> systems = {alone(random), someSystem(random, 3, 0)};
  for (int i = 0; i < 3; ++i) systems.push_back(tiny(random));
  for (const double k : stiffnessLadder) {
    for (const double L0 : {0.0, 0.83, 1000.0}) {
      System system = someSystem(random, 3, 4);
      for (Spring& s : system.springs) s.k = k, s.L0 = L0;
      systems.push_back(system);
    }
  }
  for (const double m : {1e-6, 37e3, 1e6}) {
    systems.push_back(someSystem(random, 3, 3));
    systems.back().m.setConstant(m);
  }
  systems.push_back(someSystem(random, 200, 600));
  return systems;
}

}  // namespace

// --- MassMatrix -----------------------------------------------------------------------------------------------------

namespace {

std::vector<VecX> someMasses() {
  Random random = testRandom();
  std::vector<VecX> all = {VecX{{1.7}}, VecX{{1e-6, 2.3e-6}}, VecX{{1e6, 0.37e6, 0.4e6}}};
  for (const Eigen::Index n : {2, 3, 5, 30}) all.push_back(someNumbers(random, n, 0.31, 2.9));
  return all;
}

}  // namespace

TEST(MassMatrix, HasTheMassesOnItsDiagonal) {
  MUELLE_PROPERTY("the mass of a node stands on the diagonal once for each of its components, and all else is zero");
  for (const VecX& m : someMasses()) {
    EXPECT_MATRIX_NEAR(submission::systemMassMatrix(m), MatX(oracle::systemMassMatrix(m)), inRounding(m.maxCoeff()));
  }
}

// --- TotalEnergy ----------------------------------------------------------------------------------------------------

namespace {

void expectEnergy(const System& system, const Law& law) {
  EXPECT_NUMBER_NEAR(submission::systemEnergy(system.x, system.springs, law.energy),
                     oracle::systemEnergy(system.x, system.springs, law.energy),
                     inRounding(energySizes(system, law.energy)));
}

/// Nodes that hang together by one spring between neighbours, and some more: the simulator wants one spring between two
/// nodes.
System someMesh(Random& random, int nodes) {
  System system = someSystem(random, nodes, 0);
  std::set<std::pair<int, int>> joined;
  const auto join = [&](Spring s, int a, int b) {
    s.a = a;
    s.b = b;
    if (joined.insert(std::minmax(a, b)).second) system.springs.push_back(s);
  };
  for (int i = 0; i < nodes; ++i) join(someSpring(random, nodes), i, (i + 1) % nodes);
  for (int i = 0; i < nodes; ++i) {
    const Spring s = someSpring(random, nodes);
    join(s, s.a, s.b);
  }
  return system;
}

/// The same in the reference simulator.
std::unique_ptr<muelle::engine::ModelSystem> simulated(const System& system) {
  muelle::engine::Model model;
  for (int i = 0; i < system.m.size(); ++i) {
    model.nodes.emplace_back();
    model.nodes.back().x = system.node(i);
    model.nodes.back().m = system.m[i];
  }
  for (const Spring& s : system.springs) {
    model.springs.emplace_back();
    model.springs.back().a = s.a;
    model.springs.back().b = s.b;
    model.springs.back().k = s.k;
    model.springs.back().L0 = s.L0;
  }
  return muelle::engine::build(model);
}

VecX simulatedForces(const System& system) {
  const auto simulator = simulated(system);
  const muelle::State state = simulator->initialState();
  std::vector<double> f(state.x.size());
  simulator->force(0, state.x, state.v, state.z, f);
  VecX forces(system.x.size());
  for (int i = 0; i < forces.size(); ++i) forces[i] = f[static_cast<std::size_t>(simulator->lane(i / 3, i % 3))];
  return forces;
}

}  // namespace

TEST(TotalEnergy, IsTheSumOverTheSprings) {
  MUELLE_PROPERTY("the energy is the sum of the energies of all springs, each with its own nodes, k and L0");
  for (const System& system : someSystems()) expectEnergy(system, lopsided());
}

TEST(TotalEnergy, HoldsForEverySystem) {
  MUELLE_PROPERTY("the energy is right for any stiffness, rest length and size, for one node and for two hundred");
  for (const System& system : systemsOfTheWholeRange()) expectEnergy(system, lopsided());
}

TEST(TotalEnergy, IsThatOfTheSimulator) {
  MUELLE_PROPERTY("with Hooke's springs the energy is that of the reference simulator");
  Random random = testRandom();
  for (const int nodes : {3, 6, 11}) {
    const System system = someMesh(random, nodes);
    const auto simulator = simulated(system);
    const Law law = hookes();
    EXPECT_NUMBER_NEAR(submission::systemEnergy(system.x, system.springs, law.energy),
                       simulator->elasticEnergy(simulator->initialState()),
                       10 * inRounding(energySizes(system, law.energy)));  // the simulator takes lengths in its own way
  }
}

// --- TotalGradient --------------------------------------------------------------------------------------------------

namespace {

void expectGradient(const System& system, const Law& law) {
  EXPECT_VECTOR_NEAR(submission::systemGradient(system.x, system.springs, law.gradient),
                     oracle::systemGradient(system.x, system.springs, law.gradient),
                     inRounding(gradientSizes(system, law.gradient)));
}

}  // namespace

TEST(TotalGradient, AddsTheGradientsOfTheSprings) {
  MUELLE_PROPERTY("each spring adds the two halves of its gradient to the blocks of its two nodes");
  for (const System& system : someSystems()) expectGradient(system, lopsided());
}

TEST(TotalGradient, HoldsForEverySystem) {
  MUELLE_PROPERTY("the gradient is right for any stiffness, rest length and size, for one node and for two hundred");
  for (const System& system : systemsOfTheWholeRange()) expectGradient(system, lopsided());
}

TEST(TotalGradient, IsThatOfTheSimulator) {
  MUELLE_PROPERTY("with Hooke's springs minus the gradient is the force of the reference simulator");
  Random random = testRandom();
  for (const int nodes : {3, 6, 11}) {
    const System system = someMesh(random, nodes);
    const Law law = hookes();
    EXPECT_VECTOR_NEAR(submission::systemGradient(system.x, system.springs, law.gradient),
                       VecX(-simulatedForces(system)), 10 * inRounding(gradientSizes(system, law.gradient)));
  }
}

// --- Accelerations --------------------------------------------------------------------------------------------------

namespace {

void expectAccelerations(const System& system, const Law& law) {
  const double force = gradientSizes(system, law.gradient) + system.F.cwiseAbs().maxCoeff();
  EXPECT_VECTOR_NEAR(submission::systemAccelerations(system.x, system.m, system.springs, law.gradient, system.F),
                     oracle::systemAccelerations(system.x, system.m, system.springs, law.gradient, system.F),
                     inRounding(force / system.m.minCoeff()));
}

}  // namespace

TEST(Accelerations, SolveNewtonsLaw) {
  MUELLE_PROPERTY(
      "the mass of each node times its acceleration is minus its part of the gradient plus the other force");
  for (const System& system : someSystems()) expectAccelerations(system, lopsided());
}

TEST(Accelerations, HoldForEverySystem) {
  MUELLE_PROPERTY("the accelerations are right for any mass and spring, for one node and for two hundred");
  for (const System& system : systemsOfTheWholeRange()) expectAccelerations(system, lopsided());
}

// --- GradientOfTheEnergy --------------------------------------------------------------------------------------------

namespace {

/// The slope of the student's energy in each component, by four points: exact for an energy of degree four, whatever h
/// is, so that h may be large and round-off small.
VecX slopes(const System& system, const SpringEnergy& energy) {
  constexpr double h = 0.5;
  VecX all(system.x.size());
  for (Eigen::Index i = 0; i < system.x.size(); ++i) {
    const auto at = [&](double shift) {
      VecX moved = system.x;
      moved[i] += shift;
      return submission::systemEnergy(moved, system.springs, energy);
    };
    all[i] = (at(-2 * h) - 8 * at(-h) + 8 * at(h) - at(2 * h)) / (12 * h);
  }
  return all;
}

void expectSlopes(const System& system, const Law& law) {
  const VecX gradient = submission::systemGradient(system.x, system.springs, law.gradient);
  MUELLE_LABEL("your systemGradient, where the slope of your systemEnergy is expected", "N");
  EXPECT_VECTOR_NEAR(gradient, slopes(system, law.energy), inStructure(gradientSizes(system, law.gradient)));
}

}  // namespace

TEST(GradientOfTheEnergy, IsTheSlopeInEachComponent) {
  MUELLE_PROPERTY("each component of systemGradient is the slope of systemEnergy when that component of x moves");
  MUELLE_EXPECT_ANSWERS(systemEnergy);
  MUELLE_EXPECT_ANSWERS(systemGradient);
  Random random = testRandom();
  expectSlopes(someSystem(random, 3, 3), opposite());
  expectSlopes(someSystem(random, 4, 7), opposite());
  expectSlopes(someSystem(random, 3, 4), lopsided());
}

// --- Numbering ------------------------------------------------------------------------------------------------------

namespace {

/// Node i becomes node i + 2 of n, in a circle.
int renumbered(int i, Eigen::Index n) { return (i + 2) % static_cast<int>(n); }

/// The same system with other numbers for the nodes, the springs backwards, and of every other spring the ends
/// exchanged.
System renamed(const System& system) {
  System other = system;
  for (int i = 0; i < system.m.size(); ++i) {
    const int to = renumbered(i, system.m.size());
    other.x.segment<3>(3 * to) = system.node(i);
    other.m[to] = system.m[i];
  }
  std::reverse(other.springs.begin(), other.springs.end());
  bool turns = false;
  for (Spring& s : other.springs) {
    s.a = renumbered(s.a, system.m.size());
    s.b = renumbered(s.b, system.m.size());
    if (turns) std::swap(s.a, s.b);
    turns = !turns;
  }
  return other;
}

/// With two springs between the same two nodes.
std::vector<System> systemsToRename() {
  Random random = testRandom();
  std::vector<System> systems;
  for (const auto& [nodes, springs] : Counts{{3, 4}, {6, 10}}) {
    System system = someSystem(random, nodes, springs);
    Spring twin = system.springs[1];
    twin.k = 53;
    system.springs.push_back(twin);
    systems.push_back(system);
  }
  return systems;
}

}  // namespace

TEST(Numbering, LeavesTheEnergy) {
  MUELLE_PROPERTY("with other numbers of the nodes and the springs in another order, systemEnergy gives the same");
  MUELLE_EXPECT_ANSWERS(systemEnergy);
  for (const System& system : systemsToRename()) {
    const System other = renamed(system);
    const Law law = opposite();
    const double before = submission::systemEnergy(system.x, system.springs, law.energy);
    MUELLE_LABEL(fmt::format("your systemEnergy of {}, named otherwise", system.name()), "J");
    EXPECT_NUMBER_NEAR(submission::systemEnergy(other.x, other.springs, law.energy), before,
                       inStructure(energySizes(system, law.energy)));
  }
}

TEST(Numbering, MovesTheBlocksOfTheGradient) {
  MUELLE_PROPERTY(
      "with other numbers of the nodes and the springs in another order, systemGradient has the same blocks");
  MUELLE_EXPECT_ANSWERS(systemGradient);
  for (const System& system : systemsToRename()) {
    const System other = renamed(system);
    const Law law = opposite();
    const VecX before = submission::systemGradient(system.x, system.springs, law.gradient);
    const VecX after = submission::systemGradient(other.x, other.springs, law.gradient);
    VecX back = after;
    for (int i = 0; i < system.m.size() && after.size() == system.x.size(); ++i) {
      back.segment<3>(3 * i) = after.segment<3>(3 * renumbered(i, system.m.size()));
    }
    MUELLE_LABEL(fmt::format("your systemGradient of {}, named otherwise, in the old order", system.name()), "N");
    EXPECT_VECTOR_NEAR(back, before, inStructure(gradientSizes(system, law.gradient)));
  }
}

// --- Momentum -------------------------------------------------------------------------------------------------------

namespace {

Vec3 sumOfBlocks(const VecX& stackedVectors) {
  Vec3 sum = Vec3::Zero();
  for (Eigen::Index i = 0; i < stackedVectors.size(); ++i) sum[i % 3] += stackedVectors[i];
  return sum;
}

}  // namespace

TEST(Momentum, ChangesByTheOtherForcesAlone) {
  MUELLE_PROPERTY(
      "the masses times the accelerations add up to the sum of the other forces: opposite halves of springs cancel");
  MUELLE_EXPECT_ANSWERS(systemGradient);
  MUELLE_EXPECT_ANSWERS(systemAccelerations);
  Random random = testRandom();
  for (const auto& [nodes, springs] : Counts{{2, 1}, {3, 3}, {8, 20}}) {
    const System system = someSystem(random, nodes, springs);
    const Law law = opposite();
    VecX a = submission::systemAccelerations(system.x, system.m, system.springs, law.gradient, system.F);
    {
      MUELLE_LABEL("components of your accelerations");
      ASSERT_NUMBER_NEAR(static_cast<double>(a.size()), static_cast<double>(system.x.size()), 0);
    }
    for (Eigen::Index i = 0; i < a.size(); ++i) a[i] *= system.m[i / 3];
    MUELLE_LABEL(fmt::format("sum of the masses times your accelerations, with {}", system.name()), "N");
    EXPECT_VECTOR_NEAR(sumOfBlocks(a), sumOfBlocks(system.F),
                       inStructure(gradientSizes(system, law.gradient) + system.F.cwiseAbs().sum()));
  }
}

// --- Cost -----------------------------------------------------------------------------------------------------------

namespace {

/// From a few nodes to many, with about two springs a node.
std::vector<System> growingSystems() {
  Random random = testRandom();
  return {someSystem(random, 3, 2), someSystem(random, 10, 19), someSystem(random, 50, 110)};
}

/// How often `call` asks a function of the test.
template <class Asked, class Call>
double questions(const Asked& asked, const Call& call) {
  asked.forgetCalls();
  call();
  return static_cast<double>(asked.calls());
}

double questionsOfTheGradient(const System& system, const Law& law) {
  return questions(law.gradient, [&] { submission::systemGradient(system.x, system.springs, law.gradient); });
}

void expectQuestions(const char* function, const char* what, const System& system, double asked, double expected) {
  MUELLE_LABEL(fmt::format("how often {} asks for the {} of a spring, with {}", function, what, system.name()));
  EXPECT_NUMBER_NEAR(asked, expected, 0);
}

}  // namespace

TEST(Cost, OfTheMassMatrixIsThreeEntriesANode) {
  MUELLE_PROPERTY("systemMassMatrix stores three entries a node and no zeros beside them");
  MUELLE_EXPECT_ANSWERS(systemMassMatrix);
  Random random = testRandom();
  for (const int n : {1, 4, 40}) {
    const SparseMatrix M = submission::systemMassMatrix(someNumbers(random, n, 0.31, 2.9));
    const auto stored = static_cast<double>(M.nonZeros());
    MUELLE_LABEL(fmt::format("entries that your systemMassMatrix of {} node{} stores", n, n == 1 ? "" : "s"));
    EXPECT_NUMBER_NEAR(stored, std::min(stored, 3.0 * n), 0);  // too few are a wrong matrix, and no cost
  }
}

TEST(Cost, OfTheEnergyIsOneQuestionASpring) {
  MUELLE_PROPERTY("systemEnergy asks for the energy of each spring once");
  MUELLE_EXPECT_ANSWERS(systemEnergy);
  for (const System& system : growingSystems()) {
    const Law law = opposite();
    const double asked = questions(law.energy, [&] { submission::systemEnergy(system.x, system.springs, law.energy); });
    expectQuestions("systemEnergy", "energy", system, asked, static_cast<double>(system.springs.size()));
  }
}

TEST(Cost, OfTheGradientIsOneQuestionASpring) {
  MUELLE_PROPERTY("systemGradient asks for the gradient of each spring once");
  MUELLE_EXPECT_ANSWERS(systemGradient);
  for (const System& system : growingSystems()) {
    const double asked = questionsOfTheGradient(system, opposite());
    expectQuestions("systemGradient", "gradient", system, asked, static_cast<double>(system.springs.size()));
  }
}

TEST(Cost, OfTheAccelerationsIsOneQuestionASpring) {
  MUELLE_PROPERTY("systemAccelerations asks for the gradient of each spring once");
  MUELLE_EXPECT_ANSWERS(systemAccelerations);
  for (const System& system : growingSystems()) {
    const Law law = opposite();
    const double asked = questions(law.gradient, [&] {
      submission::systemAccelerations(system.x, system.m, system.springs, law.gradient, system.F);
    });
    // What systemGradient asks too often it has paid for itself.
    const double inGradient = questionsOfTheGradient(system, law);
    const auto springs = static_cast<double>(system.springs.size());
    const bool isTheGradients = asked == inGradient && inGradient > springs;
    expectQuestions("systemAccelerations", "gradient", system, asked, isTheGradients ? asked : springs);
  }
}
