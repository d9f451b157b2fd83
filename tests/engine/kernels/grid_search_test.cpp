#include "engine/kernels/grid_search.h"

#include "engine/kernels/grid_springs.h"
#include "oracle.h"

#include <gtest/gtest.h>

namespace muelle::engine::kernels {
namespace {

std::vector<SpringData> rows(int n) {
  std::vector<SpringData> springs;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      if (j + 1 < n) springs.push_back({i * n + j + 1, i * n + j, 10.0, 1.0});
      if (i + 1 < n) springs.push_back({i * n + j, (i + 1) * n + j, 20.0, 1.0});
    }
  }
  return springs;
}

TEST(GridSearch, FindsEachStrideOfASheetWithGapsAtItsBorder) {
  const GridSearch found = findRuns(3, 100, rows(10));
  ASSERT_TRUE(found.isGrid()) << found.refusal;
  ASSERT_EQ(found.runs.size(), 2U);
  EXPECT_EQ(found.runs[0].stride, 1U);
  EXPECT_EQ(found.runs[0].gaps, (std::vector<std::size_t>{9, 19, 29, 39, 49, 59, 69, 79, 89}));
  EXPECT_EQ(found.runs[0].end, 99U);
  EXPECT_EQ(found.runs[0].springs(), 90U);
  EXPECT_TRUE(found.runs[0].isConstant);
  EXPECT_EQ(found.runs[0].k, std::vector<double>{10.0});
  EXPECT_EQ(found.runs[1].stride, 10U);
  EXPECT_TRUE(found.runs[1].gaps.empty());
  EXPECT_TRUE(found.loose.empty());
}

TEST(GridSearch, MakesASecondRunOfSpringsBetweenTheSameNodes) {
  std::vector<SpringData> springs = rows(10);
  for (const SpringData& s : rows(10)) springs.push_back({s.a, s.b, 5.0, 2.0});
  const GridSearch found = findRuns(3, 100, springs);
  ASSERT_TRUE(found.isGrid()) << found.refusal;
  ASSERT_EQ(found.runs.size(), 4U);
  EXPECT_EQ(found.runs[0].stride, found.runs[1].stride);
  EXPECT_EQ(found.runs[0].k.front() + found.runs[1].k.front(), 15.0);
}

TEST(GridSearch, TakesMaterialsOfEachSpringWhereTheyDiffer) {
  std::vector<SpringData> springs = rows(10);
  springs[2].L0 = 1.0 + 1e-15;
  EXPECT_FALSE(findRuns(3, 100, springs).runs[0].isConstant && findRuns(3, 100, springs).runs[1].isConstant);
  const GridSearch alike = findRuns(3, 100, springs, 1e-14);
  EXPECT_TRUE(alike.runs[0].isConstant && alike.runs[1].isConstant);
}

TEST(GridSearch, LeavesAFewSpringsLoose) {
  std::vector<SpringData> springs = rows(40);
  springs.push_back({0, 777, 1.0, 1.0});
  const GridSearch found = findRuns(3, 1600, springs);
  EXPECT_TRUE(found.isGrid());
  ASSERT_EQ(found.loose.size(), 1U);
  EXPECT_EQ(found.loose[0].b, 777);
}

TEST(GridSearch, RefusesWhatIsNone) {
  Dice dice(41);
  std::vector<SpringData> springs;
  for (int i = 0; i < 3000; ++i) springs.push_back({dice.roll(1000), dice.roll(1000), 1.0, 1.0});
  const GridSearch found = findRuns(3, 1000, springs);
  EXPECT_FALSE(found.isGrid());
  EXPECT_NE(found.refusal.find("springs are in no run"), std::string::npos) << found.refusal;
}

TEST(GridSearch, OfNoSpringsIsAGridWithoutRuns) {
  const GridSearch found = findRuns(3, 10, {});
  EXPECT_TRUE(found.isGrid());
  EXPECT_TRUE(found.runs.empty());
}

TEST(Planes, HaveRoomForAllNodesAndComponentsInDifferentSets) {
  for (const std::size_t nodes : {1UL, 8UL, 9UL, 500UL, 512UL, 1024UL, 1025UL, 65536UL, 65600UL, 1048576UL}) {
    const std::size_t plane = planeFor(nodes);
    EXPECT_GE(plane, nodes);
    EXPECT_EQ(plane % 8, 0U);
    EXPECT_LE(plane, nodes + 8 + (nodes < 512 ? 0 : 512));
    EXPECT_TRUE(nodes < 512 || plane % 512 == 168) << plane;
  }
}

}  // namespace
}  // namespace muelle::engine::kernels
