#include "figures/ranges.h"

#include <gtest/gtest.h>
#include <cmath>

namespace muelle::figures {
namespace {

TEST(Ranges, OfStackedPanelsShareTheXAxis) {
  Figure figure("id", "title", "x");
  figure.panel("a").line("", {0, 1}, {0, 1});
  figure.panel("b").line("", {2, 5}, {0, NAN});  // x = 5 is not drawn
  const std::vector<PanelRanges> ranges = rangesOf(figure);
  ASSERT_EQ(ranges.size(), 2U);
  for (const PanelRanges& panel : ranges) {
    EXPECT_DOUBLE_EQ(panel.x.low, 0.0);
    EXPECT_DOUBLE_EQ(panel.x.high, 2.0);
  }
}

TEST(Ranges, OfASlideAreEachPanelsOwn) {
  Figure figure("id", "title", "x");
  figure.slide(2);
  figure.panel("a").line("", {0, 1}, {0, 1});
  figure.panel("b").line("", {2, 5}, {0, 1}).xRange(-1, 9);
  const std::vector<PanelRanges> ranges = rangesOf(figure);
  ASSERT_EQ(ranges.size(), 2U);
  EXPECT_DOUBLE_EQ(ranges[0].x.high, 1.0);
  EXPECT_DOUBLE_EQ(ranges[1].x.low, -1.0);
  EXPECT_DOUBLE_EQ(ranges[1].x.high, 9.0);
}

TEST(Ranges, HoldTipsOfArrowsCornersOfCellsAndFields) {
  Figure figure("id", "title", "x");
  figure.slide(3);
  figure.panel("arrows").arrows("", {0, 1}, {0, 1}, {5, 0}, {0, -7});
  figure.panel("cells").cells("", {0, 1}, {0, 2}).yNames({"a", "b", "c"});
  figure.panel("field").field({{0, 1, 2}, {5, 6}, {1, 2, 3, 4, 5, 6}, "E"});
  const std::vector<PanelRanges> ranges = rangesOf(figure);
  ASSERT_EQ(ranges.size(), 3U);
  EXPECT_GT(ranges[0].x.high, 5.0);  // with a margin
  EXPECT_LT(ranges[0].y.low, -6.0);
  EXPECT_DOUBLE_EQ(ranges[1].x.low, -0.5);
  EXPECT_DOUBLE_EQ(ranges[1].y.high, 2.5);
  EXPECT_DOUBLE_EQ(ranges[2].x.high, 2.0);  // a field fills its plot
  EXPECT_DOUBLE_EQ(ranges[2].y.low, 5.0);
}

}  // namespace
}  // namespace muelle::figures
