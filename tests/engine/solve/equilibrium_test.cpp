#include "engine/statics/equilibrium.h"
#include "expect_balanced.h"
#include "support/spring_network.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <Eigen/Core>
#include <stdexcept>
#include <utility>

namespace muelle::engine {
namespace {

using testing::SpringNetwork;
using Vector = Eigen::VectorXd;
using Spring = SpringNetwork::Spring;

State at(std::vector<double> x) {
  State state;
  state.x = std::move(x);
  return state;
}

/// Reference case H09, vertical: z_i = -(i L0 + (m g / k) (i N - i (i - 1) / 2)).
TEST(Equilibrium, OfAHangingChainIsTheClosedForm) {
  std::vector<Spring> springs;
  std::vector<double> x;
  for (int i = 0; i < 100; ++i) {
    springs.push_back({.a = i, .b = i - 1, .k = 1000.0, .L0 = 0.01});
    x.push_back(-0.01 * (i + 1));
  }
  const SpringNetwork chain(1, std::vector<double>(100, 0.01), springs, Vector::Constant(1, -9.81));
  const StaticResult result = equilibrium(chain, at(x));
  expectBalanced(result);
  EXPECT_NEAR(result.state.x[99], -1.495405, 1e-12);
  EXPECT_NEAR(result.state.x[49], -0.8703275, 1e-12);
}

std::vector<Spring> between(int free, double k, double L0, double length) {
  std::vector<Spring> springs;
  for (int i = 0; i < free; ++i) springs.push_back({.a = i, .b = i - 1, .k = k, .L0 = L0});
  springs.push_back({.a = free - 1, .b = -1, .k = k, .L0 = L0, .anchor = {length, 0.0, 0.0}});
  return springs;
}

/// Reference case H09, catenary: from a straight horizontal start, compressed, where the transverse stiffness is
/// negative.
TEST(Equilibrium, OfAChainBetweenTwoPointsIsTheElasticCatenary) {
  const SpringNetwork chain(2, std::vector<double>(19, 0.1), between(19, 1000.0, 0.06, 1.0), Vector{{0.0, -9.81}});
  std::vector<double> x;
  for (int i = 1; i < 20; ++i) x.insert(x.end(), {0.05 * i, 0.0});
  const StaticResult result = equilibrium(chain, at(x));
  expectBalanced(result);
  EXPECT_NEAR(result.state.x[2 * 9 + 1], -0.406299740372720283241, 1e-12);
  EXPECT_NEAR(result.state.x[2 * 4], 0.204606327381418809929, 1e-12);
  EXPECT_NEAR(result.state.x[2 * 4 + 1], -0.276731170280953059509, 1e-12);
  EXPECT_NEAR(result.energy, -4.34879480268490529091, 1e-12);
  EXPECT_GT(result.smallestEigenvalue, 0.0);
  RecordProperty("iterations", result.iterations);
}

/// Reference case H10, spacing = L0: no transverse stiffness at all. Weightless it is a flat minimum where it stands;
/// with weight it sags, however small the weight.
TEST(Equilibrium, HoldsWhereTheTransverseStiffnessIsZero) {
  std::vector<double> x;
  for (int i = 1; i < 5; ++i) x.insert(x.end(), {0.2 * i, 0.0});
  const SpringNetwork weightless(2, std::vector<double>(4, 1.0), between(4, 100.0, 0.2, 1.0), Vector::Zero(2));
  const StaticResult flat = equilibrium(weightless, at(x));
  expectBalanced(flat);
  EXPECT_NEAR(flat.smallestEigenvalue, 0.0, 1e-6);
  EXPECT_NE(flat.message.find("flat"), std::string::npos) << flat.message;
  for (std::size_t i = 0; i < x.size(); ++i) EXPECT_NEAR(flat.state.x[i], x[i], 1e-12);

  for (const double g : {9.81, 1e-3, 1e-6}) {
    const SpringNetwork heavy(2, std::vector<double>(4, 1.0), between(4, 100.0, 0.2, 1.0), Vector{{0.0, -g}});
    const StaticResult sagging = equilibrium(heavy, at(x));
    expectBalanced(sagging);
    EXPECT_LT(sagging.state.x[3], -1e-4) << "g = " << g;
    EXPECT_GT(sagging.smallestEigenvalue, 0.0) << "g = " << g;
  }
}

/// Reference case H14: from near the saddle, and from on it, to the ring of radius 0.6 where both springs rest.
TEST(Equilibrium, LeavesTheSaddleForTheRing) {
  const SpringNetwork buckled(
      3, {1.0},
      {{.k = 100.0, .L0 = 1.0, .anchor = {-0.8, 0.0, 0.0}}, {.k = 100.0, .L0 = 1.0, .anchor = {0.8, 0.0, 0.0}}},
      Vector::Zero(3));
  for (const double y : {1e-3, 1e-6, 1e-12, 0.0}) {
    const StaticResult result = equilibrium(buckled, at({0.0, y, 0.0}));
    expectBalanced(result);
    EXPECT_NEAR(std::hypot(result.state.x[1], result.state.x[2]), 0.6, 1e-12) << "from y = " << y;
    EXPECT_LE(result.energy, 1e-20) << "from y = " << y;
    EXPECT_GE(result.saddlesLeft, y == 0.0 ? 1 : 0);
  }
  StaticOptions stay;
  stay.leaveSaddles = false;
  const StaticResult saddle = equilibrium(buckled, at({0.0, 0.0, 0.0}), stay);
  EXPECT_FALSE(saddle.converged);
  EXPECT_NEAR(saddle.smallestEigenvalue, -50.0, 1e-9);
  EXPECT_NE(saddle.message.find("saddle"), std::string::npos) << saddle.message;
}

/// Reference case H12: 1 kg above 1e6 kg on springs of 1e8 N/m; each carries what hangs below it.
TEST(Equilibrium, HoldsForAMassRatioOfAMillion) {
  const SpringNetwork system(1, {1.0, 1e6}, {{.a = 0, .b = -1, .k = 1e8}, {.a = 1, .b = 0, .k = 1e8}},
                             Vector::Constant(1, -9.81));
  const StaticResult result = equilibrium(system, at({-1.0, -2.0}));
  expectBalanced(result);
  const double first = -1.0 - 1000001.0 * 9.81 / 1e8;
  EXPECT_NEAR(result.state.x[0], first, 1e-12);
  EXPECT_NEAR(result.state.x[1], first - 1.0 - 1e6 * 9.81 / 1e8, 2e-12);
}

TEST(Equilibrium, SaysWhenThereIsNone) {
  // A free node falls for ever.
  const SpringNetwork falling(1, {1.0, 1.0}, {{.a = 0, .b = -1}}, Vector::Constant(1, -9.81));
  const StaticResult result = equilibrium(falling, at({-1.0, 0.0}));
  EXPECT_FALSE(result.converged);
  EXPECT_FALSE(result.message.empty());
  EXPECT_THROW(equilibrium(falling, at({0.0})), std::invalid_argument);
  EXPECT_THROW(equilibrium(falling, at({0.0, std::nan("")})), std::invalid_argument);
}

}  // namespace
}  // namespace muelle::engine
