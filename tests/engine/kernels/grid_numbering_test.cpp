#include "engine/kernels/grid_numbering.h"

#include "oracle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace muelle::engine::kernels {
namespace {

/// A block of nodes with springs along its edges and the diagonals of its x-y faces, `x` three numbers a node.
struct Block {
  std::vector<double> x;
  std::vector<SpringData> springs;
};

/// \param edges the three vectors from node to node
Block blockOf(int nx, int ny, int nz, const double (&edges)[3][3]) {
  Block block;
  for (int i = 0; i < nx * ny * nz; ++i) {
    const int at[3] = {i % nx, i / nx % ny, i / nx / ny};
    for (int c = 0; c < 3; ++c)
      block.x.push_back(at[0] * edges[0][c] + at[1] * edges[1][c] + at[2] * edges[2][c] + 0.3);
    if (at[0] + 1 < nx) block.springs.push_back({i, i + 1, 10.0, 1.0});
    if (at[1] + 1 < ny) block.springs.push_back({i, i + nx, 10.0, 1.0});
    if (at[2] + 1 < nz) block.springs.push_back({i, i + nx * ny, 10.0, 1.0});
    if (at[0] + 1 < nx && at[1] + 1 < ny) block.springs.push_back({i, i + nx + 1, 10.0, 1.0});
  }
  return block;
}

/// Another order of nodes and springs.
Block mixed(const Block& block) {
  Dice dice(51);
  const std::size_t nodes = block.x.size() / 3;
  std::vector<int> number(nodes);
  std::iota(number.begin(), number.end(), 0);
  for (std::size_t i = nodes; i-- > 1;)
    std::swap(number[i], number[static_cast<std::size_t>(dice.roll(static_cast<int>(i + 1)))]);
  Block result = block;
  for (std::size_t i = 0; i < block.x.size(); ++i)
    result.x[3 * static_cast<std::size_t>(number[i / 3]) + i % 3] = block.x[i];
  for (SpringData& s : result.springs)
    s = {number[static_cast<std::size_t>(s.a)], number[static_cast<std::size_t>(s.b)], s.k, s.L0};
  for (std::size_t i = block.springs.size(); i-- > 1;) {
    std::swap(result.springs[i], result.springs[static_cast<std::size_t>(dice.roll(static_cast<int>(i + 1)))]);
  }
  return result;
}

void expectOnePlaceEach(const GridNumbering& found) {
  EXPECT_EQ(std::set<int>(found.place.begin(), found.place.end()).size(), found.place.size());
  for (const int place : found.place) EXPECT_LT(static_cast<std::size_t>(place), found.places);
}

constexpr double upright[3][3] = {{0.1, 0.0, 0.0}, {0.0, 0.1, 0.0}, {0.0, 0.0, 0.1}};
constexpr double turned[3][3] = {{0.06, 0.08, 0.0}, {-0.08, 0.06, 0.0}, {0.0, 0.0, 0.1}};
constexpr double sheared[3][3] = {{0.1, 0.0, 0.0}, {0.05, 0.0866, 0.0}, {0.03, 0.02, 0.12}};

TEST(GridNumbering, KeepsTheOrderOfAGenerator) {
  const Block block = blockOf(12, 9, 1, upright);
  const GridNumbering found = findGrid(3, block.x, block.springs);
  EXPECT_EQ(found.order, GridOrder::AsGiven);
  EXPECT_EQ(found.place[17], 17);
}

TEST(GridNumbering, FindsALatticeInAnyOrderTurnedOrSheared) {
  for (const auto* edges : {&upright, &turned, &sheared}) {
    for (const int depth : {1, 6}) {
      const Block block = mixed(blockOf(13, 8, depth, *edges));
      const GridNumbering found = findGrid(3, block.x, block.springs);
      ASSERT_EQ(found.order, GridOrder::Lattice) << found.search.refusal;
      expectOnePlaceEach(found);
      EXPECT_TRUE(found.search.loose.empty());
      EXPECT_EQ(found.search.runs.size(), depth == 1 ? 3U : 4U);
    }
  }
}

TEST(GridNumbering, LeavesPlacesEmptyWhereALatticeHasHoles) {
  Block block = blockOf(20, 20, 1, upright);
  std::vector<int> kept(400, -1);
  std::vector<double> x;
  for (int i = 0, next = 0; i < 400; ++i) {
    if (i % 20 > 5 && i % 20 < 9 && i / 20 > 5 && i / 20 < 9) continue;
    kept[static_cast<std::size_t>(i)] = next++;
    x.insert(x.end(), block.x.begin() + 3 * i, block.x.begin() + 3 * i + 3);
  }
  std::vector<SpringData> springs;
  for (const SpringData& s : block.springs) {
    const int a = kept[static_cast<std::size_t>(s.a)], b = kept[static_cast<std::size_t>(s.b)];
    if (a >= 0 && b >= 0) springs.push_back({a, b, s.k, s.L0});
  }
  const Block shuffledBlock = mixed({x, springs});
  const GridNumbering found = findGrid(3, shuffledBlock.x, shuffledBlock.springs);
  ASSERT_EQ(found.order, GridOrder::Lattice) << found.search.refusal;
  EXPECT_EQ(found.places, 400U);
  expectOnePlaceEach(found);
}

TEST(GridNumbering, FollowsChainsFromEndToEnd) {
  Block block;
  for (int i = 0; i < 60; ++i) {
    block.x.insert(block.x.end(), {std::cos(0.1 * i), std::sin(0.1 * i), 0.01 * i * i});
    if (i % 30) block.springs.push_back({i - 1, i, 10.0, 0.1});
  }
  const Block chain = mixed(block);
  const GridNumbering found = findGrid(3, chain.x, chain.springs);
  ASSERT_EQ(found.order, GridOrder::AlongChains) << found.search.refusal;
  expectOnePlaceEach(found);
  ASSERT_EQ(found.search.runs.size(), 1U);
  EXPECT_EQ(found.search.runs[0].springs(), 58U);
}

TEST(GridNumbering, RefusesALatticeWithTwoNodesInOnePlace) {
  Block twice = blockOf(13, 8, 1, upright);
  const std::size_t numbers = twice.x.size(), springs = twice.springs.size();
  for (std::size_t i = 0; i < numbers; ++i) twice.x.push_back(twice.x[i]);
  for (std::size_t i = 0; i < springs; ++i) {
    const SpringData s = twice.springs[i];
    twice.springs.push_back({s.a + 104, s.b + 104, s.k, s.L0});
  }
  const Block sheets = mixed(twice);
  EXPECT_EQ(findGrid(3, sheets.x, sheets.springs).order, GridOrder::None);
}

TEST(GridNumbering, SaysWhyARandomNetIsNoGrid) {
  Dice dice(52);
  Block block;
  for (int i = 0; i < 600; ++i) block.x.push_back(dice.number());
  for (int i = 0; i < 900; ++i) block.springs.push_back({dice.roll(200), dice.roll(200), 1.0, 1.0});
  const GridNumbering found = findGrid(3, block.x, block.springs);
  EXPECT_EQ(found.order, GridOrder::None);
  EXPECT_FALSE(found.search.refusal.empty());
}

}  // namespace
}  // namespace muelle::engine::kernels
