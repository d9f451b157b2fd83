/// \file
/// Forces of springs by the kernels, against sums in long double.

#include "oracle.h"

#include "engine/kernels/grid_search.h"
#include "engine/kernels/grid_springs.h"
#include "engine/kernels/kernel_table.h"
#include "engine/kernels/spring_groups.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace muelle::engine::kernels {
namespace {

void expectWithinRounding(const std::vector<double>& f, const Nodes& nodes, const std::vector<SpringData>& springs) {
  const std::vector<long double> exact = oracleForces(nodes, springs);
  const std::vector<double> bound = roundingBounds(nodes, springs);
  for (std::size_t i = 0; i < f.size(); ++i) {
    EXPECT_LE(std::fabs(static_cast<double>(f[i] - exact[i])), bound[i]) << "number " << i << " is " << f[i];
  }
}

TEST(GeneralSprings, AreExactToRoundingInAnyCountDimensionAndDamping) {
  onEveryInstructionSet([](const std::string& set) {
    for (const int dimension : {1, 2, 3}) {
      for (const Damping damping : everyDamping) {
        for (const int count : {0, 1, 2, 3, 4, 7, 8, 9, 15, 16, 17, 300}) {
          SCOPED_TRACE(set + ", dimension " + std::to_string(dimension) + ", " + std::to_string(count) + " springs");
          Dice dice(static_cast<unsigned>(count + 1));
          const int nodeCount = 2 + count / 2;
          const Nodes nodes = randomNodes(dimension, nodeCount, dice);
          std::vector<SpringData> springs;
          while (static_cast<int>(springs.size()) < count) {
            springs.push_back(springOf(dice.roll(nodeCount), dice.roll(nodeCount), damping, dice));
            if (springs.back().a == springs.back().b) springs.pop_back();
          }
          expectWithinRounding(generalForces(nodes, springs), nodes, springs);
        }
      }
    }
  });
}

TEST(GeneralSprings, OfAStarAllPullAtItsCentre) {
  Dice dice(5);
  const Nodes nodes = randomNodes(3, 600, dice);
  std::vector<SpringData> springs;
  for (int i = 1; i < 600; ++i) springs.push_back(springOf(i % 2 ? 0 : i, i % 2 ? i : 0, Damping::Both, dice));
  onEveryInstructionSet(
      [&](const std::string&) { expectWithinRounding(generalForces(nodes, springs), nodes, springs); });
}

TEST(GeneralSprings, OfMixedDampingsComeInABatchEach) {
  Dice dice(6);
  const Nodes nodes = randomNodes(3, 40, dice);
  std::vector<SpringData> springs;
  for (int i = 0; i < 160; ++i) springs.push_back(springOf(i % 40, (i * 7 + 3) % 40, everyDamping[i % 4], dice));
  expectWithinRounding(generalForces(nodes, springs), nodes, springs);
}

TEST(GeneralSprings, BetweenANodeAndItselfAreLeftOut) {
  Dice dice(7);
  const Nodes nodes = randomNodes(3, 3, dice);
  const std::vector<SpringData> springs = {{1, 1, 10.0, 1.0, 1.0, 1.0}};
  EXPECT_TRUE(SpringGroups(3, 3, springs).order().empty());
}

TEST(GeneralSprings, AreInGroupsOfEightWithoutACommonNode) {
  Dice dice(8);
  const std::vector<SpringData> springs = clothSprings(24, Damping::None, dice);
  const std::vector<int> order = SpringGroups(3, 24 * 24, springs).order();
  ASSERT_EQ(order.size(), springs.size());
  EXPECT_EQ(std::set<int>(order.begin(), order.end()).size(), springs.size());
  int shared = 0;
  for (std::size_t first = 0; first + 8 <= order.size(); first += 8) {
    std::set<int> met;
    for (std::size_t i = first; i < first + 8; ++i) {
      met.insert(springs[static_cast<std::size_t>(order[i])].a);
      met.insert(springs[static_cast<std::size_t>(order[i])].b);
    }
    shared += met.size() < 16 ? 1 : 0;
  }
  // The last nodes have too few springs left between them: a window is 256 springs, 32 groups.
  EXPECT_LE(shared, 32);
}

TEST(GridSprings, AreExactToRoundingOfAChainAClothAndALattice) {
  onEveryInstructionSet([](const std::string& set) {
    for (const Damping damping : everyDamping) {
      SCOPED_TRACE(set + ", damping " + std::to_string(static_cast<int>(damping)));
      for (const int dimension : {1, 2, 3}) {
        Dice dice(11);
        const Nodes chain = randomNodes(dimension, 37, dice);
        std::vector<SpringData> springs;
        for (int i = 0; i + 1 < 37; ++i) springs.push_back(springOf(i, i + 1, damping, dice));
        expectWithinRounding(gridForces(chain, springs), chain, springs);
        const Nodes sheet = randomNodes(dimension, 23 * 23, dice);
        springs = clothSprings(23, damping, dice);
        for (const std::size_t block : {std::size_t{0}, std::size_t{8}, std::size_t{32}, std::size_t{4096}}) {
          expectWithinRounding(gridForces(sheet, springs, block), sheet, springs);
        }
      }
      Dice dice(12);
      const Nodes lattice = randomNodes(3, 6 * 7 * 8, dice);
      std::vector<SpringData> springs;
      for (int i = 0; i < 6 * 7 * 8; ++i) {
        if (i % 6 < 5) springs.push_back(springOf(i, i + 1, damping, dice));
        if (i / 6 % 7 < 6) springs.push_back(springOf(i + 6, i, damping, dice));
        if (i / 42 < 7) springs.push_back(springOf(i, i + 42, damping, dice));
        if (i % 6 < 5 && i / 6 % 7 < 6 && i / 42 < 7) springs.push_back(springOf(i, i + 49, damping, dice));
      }
      expectWithinRounding(gridForces(lattice, springs), lattice, springs);
    }
  });
}

TEST(GridSprings, OfFewNodesHaveNothingBehindTheLast) {
  onEveryInstructionSet([](const std::string& set) {
    for (const int count : {2, 3, 7, 8, 9, 10, 15, 16, 17, 33}) {
      SCOPED_TRACE(set + ", " + std::to_string(count) + " nodes");
      Dice dice(13);
      const Nodes chain = randomNodes(3, count, dice);
      std::vector<SpringData> springs;
      for (int i = 0; i + 1 < count; ++i) springs.push_back(springOf(i, i + 1, Damping::None, dice));
      for (int i = 0; i + 2 < count; ++i) springs.push_back(springOf(i, i + 2, Damping::None, dice));
      expectWithinRounding(gridForces(chain, springs), chain, springs);
      expectWithinRounding(gridForces(chain, springs, 8), chain, springs);
    }
  });
}

TEST(GridSprings, AreTheSameInBlocksOfAnySize) {
  Dice dice(14);
  const Nodes sheet = randomNodes(3, 29 * 29, dice);
  const std::vector<SpringData> springs = clothSprings(29, Damping::Both, dice);
  const std::vector<double> whole = gridForces(sheet, springs, 1024);
  for (const std::size_t block : {8, 16, 24, 48, 64, 200}) {
    EXPECT_TRUE(areSame(whole, gridForces(sheet, springs, block))) << "blocks of " << block;
  }
}

TEST(GridSprings, OfOneMaterialAreThoseOfEqualMaterialsEach) {
  Dice dice(15);
  const Nodes sheet = randomNodes(3, 21 * 21, dice);
  std::vector<SpringData> springs = clothSprings(21, Damping::None, dice);
  for (SpringData& s : springs) {
    s.k = 75.0;
    s.L0 = 0.5;
    s.dProjected = 1.5;
    s.dRelative = 0.75;
  }
  GridSearch found = findRuns(3, 441, springs);
  for (GridRun& run : found.runs) {
    ASSERT_TRUE(run.isConstant);
    run.isConstant = false;
    for (std::vector<double>* values : {&run.k, &run.L0, &run.dRelative, &run.dProjected}) {
      values->assign(run.end - run.begin, values->front());
    }
  }
  onEveryInstructionSet([&](const std::string& set) {
    const std::vector<double> f = gridForces(sheet, springs);
    expectWithinRounding(f, sheet, springs);
    PlanarCase each(sheet);
    GridSprings(3, 441, found.runs).evaluate(each.state(), each.finish());
    for (std::size_t i = 0; i < f.size(); ++i) ASSERT_EQ(each.at(i / 3, i % 3), f[i]) << set << ", number " << i;
  });
}

TEST(GridSprings, WithHolesAndLooseOnesActOnlyWhereTheyAre) {
  Dice dice(16);
  const Nodes sheet = randomNodes(3, 30 * 30, dice);
  std::vector<SpringData> springs = clothSprings(30, Damping::Relative, dice);
  std::erase_if(springs, [&](const SpringData& s) { return s.a % 30 > 10 && s.a % 30 < 15 && s.a > 300 && s.a < 600; });
  for (int i = 0; i < 20; ++i) springs.push_back(springOf(31 * i, 899 - 17 * i, Damping::Projected, dice));
  ASSERT_FALSE(findRuns(3, 900, springs).loose.empty());
  onEveryInstructionSet([&](const std::string&) { expectWithinRounding(gridForces(sheet, springs), sheet, springs); });
}

TEST(GridSprings, ThatAreLooseAccelerateEachEndByItsOwnMass) {
  const Nodes nodes = {3, {0.0, 0.0, 0.0, 3.0, 0.0, 4.0}, std::vector<double>(6, 0.0)};
  const GridSprings grid(3, 2, {}, {{0, 1, 10.0, 2.5, 0.0, 0.0}});
  PlanarCase planar(nodes);
  std::vector<double> inverse(planar.plane);
  inverse[0] = 0.5;
  inverse[1] = 0.25;
  PlanarFinish finish = planar.finish();
  finish.inverseMass = inverse.data();
  grid.evaluate(planar.state(), finish);
  // 25 N along (0.6, 0, 0.8); products of numbers without error but for 0.6 and 0.8: 4 u of 20.
  const double expected[2][3] = {{7.5, 0.0, 10.0}, {-3.75, 0.0, -5.0}};
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(planar.at(i, c), expected[i][c], 4 * 1.2e-16 * 20.0);
  }
}

TEST(GridSprings, MayBeTwoBetweenTheSameNodes) {
  Dice dice(23);
  const Nodes sheet = randomNodes(3, 12 * 12, dice);
  std::vector<SpringData> springs = clothSprings(12, Damping::None, dice);
  const std::vector<SpringData> second = clothSprings(12, Damping::None, dice);
  springs.insert(springs.end(), second.begin(), second.end());
  onEveryInstructionSet([&](const std::string&) { expectWithinRounding(gridForces(sheet, springs), sheet, springs); });
}

TEST(Springs, LeaveTheMomentumAlone) {
  Dice dice(17);
  const Nodes sheet = randomNodes(3, 26 * 26, dice);
  const std::vector<SpringData> springs = clothSprings(26, Damping::Both, dice);
  const std::vector<double> bound = roundingBounds(sheet, springs);
  onEveryInstructionSet([&](const std::string& set) {
    for (const std::vector<double>& f : {generalForces(sheet, springs), gridForces(sheet, springs)}) {
      for (std::size_t c = 0; c < 3; ++c) {
        long double sum = 0.0L;
        double most = 0.0;  // each force on a and that on b cancel exactly; only their sums round
        for (std::size_t i = c; i < f.size(); i += 3) {
          sum += f[i];
          most += bound[i];
        }
        EXPECT_LE(std::fabs(static_cast<double>(sum)), most) << set << ", component " << c;
      }
    }
  });
}

TEST(Springs, OfTwoNodesPullAlikeToTheLastBit) {
  onEveryInstructionSet([](const std::string& set) {
    Dice dice(18);
    for (int i = 0; i < 50; ++i) {
      const Nodes nodes = randomNodes(3, 2, dice);
      const std::vector<double> f = generalForces(nodes, {springOf(0, 1, Damping::Both, dice)});
      for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(f[c], -f[3 + c]) << set;
    }
  });
}

/// Eight alike beside each other, so that whole registers have the case.
void expectOfOneSpring(const Nodes& two, const SpringData& spring, double part) {
  const auto D = static_cast<std::size_t>(two.dimension);
  const std::vector<long double> exact = oracleForces(two, {spring});
  Nodes many;
  many.dimension = two.dimension;
  std::vector<SpringData> pairs, chain;
  for (int i = 0; i < 9; ++i) {
    many.x.insert(many.x.end(), two.x.begin(), two.x.end());
    many.v.insert(many.v.end(), two.v.begin(), two.v.end());
    pairs.push_back(spring);
    pairs.back().a = 2 * i;
    pairs.back().b = 2 * i + 1;
  }
  onEveryInstructionSet([&](const std::string& set) {
    for (const std::vector<double>& f : {generalForces(many, pairs), gridForces(many, pairs)}) {
      for (std::size_t i = 0; i < f.size(); ++i) {
        const auto expected = static_cast<double>(exact[i % (2 * D)]);
        EXPECT_NEAR(f[i], expected, part * std::fabs(expected)) << set << ", number " << i;
      }
    }
  });
}

TEST(Springs, OfZeroLengthHaveRelativeDampingAlone) {
  const Nodes plane = {2, {0.5, -1.0, 0.5, -1.0}, {1.0, 2.0, -1.0, 0.5}};
  expectOfOneSpring(plane, {0, 1, 10.0, 1.0, 0.0, 0.0}, 0.0);
  expectOfOneSpring(plane, {0, 1, 10.0, 1.0, 0.5, 3.0}, 0.0);
  const Nodes space = {3, {0.5, -1.0, 2.0, 0.5, -1.0, 2.0}, {1.0, 2.0, 0.0, -1.0, 0.5, 4.0}};
  expectOfOneSpring(space, {0, 1, 10.0, 0.0, 0.0, 0.0}, 0.0);
  expectOfOneSpring(space, {0, 1, 10.0, 1.0, 0.5, 3.0}, 0.0);
  const Nodes line = {1, {0.5, 0.5}, {1.0, -1.0}};
  expectOfOneSpring(line, {0, 1, 10.0, 1.0, 0.0, 0.0}, 0.0);
  expectOfOneSpring(line, {0, 1, 10.0, 1.0, 0.5, 3.0}, 0.0);
}

TEST(Springs, OfHugeAndTinyNumbersAreRightWhereTheForceIsANumber) {
  // 32 u of forces without cancellation: part = 1e-14.
  for (const double length : {1e-300, 1e-160, 1e-145, 1e-30, 1e30, 1e145, 1e200, 3e300}) {
    const Nodes space = {3, {length, 0.0, 0.25 * length, 0.0, -0.5 * length, 0.0}, {1.0, 2.0, 0.0, -1.0, 0.5, 4.0}};
    const Nodes plane = {2, {length, 0.25 * length, 0.0, 0.0}, {1.0, 2.0, 0.0, -1.0}};
    const Nodes line = {1, {length, 0.0}, {1.0, 2.0}};
    for (const Nodes& nodes : {space, plane, line}) {
      SCOPED_TRACE(std::to_string(length));
      expectOfOneSpring(nodes, {0, 1, 2.0, 0.0, 0.0, 0.0}, 1e-14);
      if (length < 1.0) expectOfOneSpring(nodes, {0, 1, 1e10, 1.0, 0.0, 0.0}, 1e-14);
      expectOfOneSpring(nodes, {0, 1, 0.0, 1.0, 0.0, 3.0}, 1e-14);
      expectOfOneSpring(nodes, {0, 1, 2.0, 0.0, 3.0, 0.0}, 1e-14);
    }
  }
  // The quotient of force and length is no double, the force is one.
  const Nodes close = {3, {1e-130, 0.0, 0.0, 0.0, 0.0, 0.0}, {0.0, 0.0, 0.0, 0.0, 0.0, 0.0}};
  expectOfOneSpring(close, {0, 1, 1e200, 1.0, 0.0, 0.0}, 1e-14);
  // A coordinate of 1e200 and one of 1 in a register: the careful lane does not touch its neighbours.
  const Nodes mixed = {3, {1e200, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0}, {0, 0, 0, 0, 0, 0, 0, 0, 0}};
  const std::vector<SpringData> springs = {{0, 1, 1.0, 0.0}, {1, 2, 1.0, 0.5}};
  onEveryInstructionSet([&](const std::string& set) {
    const std::vector<double> f = generalForces(mixed, springs);
    EXPECT_EQ(f[0], -1e200) << set;
    EXPECT_EQ(f[6], -0.5) << set;
  });
}

TEST(Springs, OfPositionsThatAreNoNumbersHaveForcesThatAreNone) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, infinity}) {
    const Nodes nodes = {3, {bad, 0.0, 0.0, 0.0, 1.0, 0.0}, {0.0, 0.0, 0.0, 0.0, 0.0, 0.0}};
    onEveryInstructionSet([&](const std::string& set) {
      for (const Damping damping : everyDamping) {
        Dice dice(19);
        const std::vector<SpringData> springs = {springOf(0, 1, damping, dice)};
        EXPECT_FALSE(std::isfinite(generalForces(nodes, springs)[0])) << set;
        EXPECT_FALSE(std::isfinite(gridForces(nodes, springs)[0])) << set;
      }
    });
  }
}

TEST(NodePass, OfPlanesGivesAccelerationsWithDragAndGravity) {
  Dice dice(20);
  const Nodes chain = randomNodes(3, 21, dice);
  std::vector<SpringData> springs;
  for (int i = 0; i + 1 < 21; ++i) springs.push_back(springOf(i, i + 1, Damping::None, dice));
  const GridSearch found = findRuns(3, 21, springs);
  const GridSprings grid(3, 21, found.runs);
  onEveryInstructionSet([&](const std::string& set) {
    const std::vector<double> F = gridForces(chain, springs);
    PlanarCase planar(chain);
    std::vector<double> inverse(planar.plane), mass(planar.plane), drag(planar.plane), added(3 * planar.plane);
    for (std::size_t i = 0; i < 21; ++i) {
      inverse[i] = i % 5 == 0 ? 0.0 : 0.5;  // every fifth is held
      mass[i] = 2.0;
      drag[i] = 0.25 * static_cast<double>(i);
      added[planar.plane + i] = 8.0;
    }
    PlanarFinish finish = {planar.out.data(), planar.plane,   added.data(), planar.v.data(),
                           drag.data(),       inverse.data(), nullptr,      {0.5, 0.0, -9.5}};
    grid.evaluate(planar.state(), finish);
    for (std::size_t i = 0; i < 21; ++i) {
      for (std::size_t c = 0; c < 3; ++c) {
        const double sum = (c == 1 ? 8.0 : 0.0) + F[3 * i + c] - drag[i] * chain.v[3 * i + c];
        EXPECT_EQ(planar.at(i, c), i % 5 == 0 ? 0.0 : sum * 0.5 + finish.gravity[c]) << set << ", node " << i;
      }
    }
    finish.inverseMass = nullptr;
    finish.mass = mass.data();
    finish.added = nullptr;
    grid.evaluate(planar.state(), finish);
    for (std::size_t i = 0; i < 21; ++i) {
      const double sum = F[3 * i + 2] - drag[i] * chain.v[3 * i + 2];
      EXPECT_EQ(planar.at(i, 2), sum + 2.0 * -9.5) << set << ", node " << i;
    }
  });
}

TEST(NodePass, OfPaddedLanesGivesAccelerationsWithDragAndGravity) {
  onEveryInstructionSet([](const std::string& set) {
    for (const int dimension : {1, 2, 3}) {
      Dice dice(21);
      const auto D = static_cast<std::size_t>(dimension), lanes = D == 3 ? 4 : D;
      const std::size_t nodes = 11;
      std::vector<double> f(lanes * nodes), v(f.size()), drag(f.size()), inverse(f.size()), a(f.size(), 7.0);
      for (std::size_t i = 0; i < f.size(); ++i) {
        if (i % lanes >= D) continue;
        f[i] = dice.number();
        v[i] = dice.number();
        drag[i] = 0.5;
        inverse[i] = i / lanes == 4 ? 0.0 : 4.0;
      }
      kernels().paddedPass[D - 1]({f.data(), a.data(), v.data(), drag.data(), inverse.data(), {1.0, 2.0, 3.0}},
                                  f.size());
      for (std::size_t i = 0; i < f.size(); ++i) {
        const std::size_t c = i % lanes;
        const bool isHeld = c >= D || i / lanes == 4;
        EXPECT_EQ(a[i], isHeld ? 0.0 : (f[i] - 0.5 * v[i]) * 4.0 + static_cast<double>(c + 1)) << set << ", lane " << i;
      }
    }
  });
}

}  // namespace
}  // namespace muelle::engine::kernels
