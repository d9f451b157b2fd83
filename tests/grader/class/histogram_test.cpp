#include "grader/class/histogram.h"

#include <gtest/gtest.h>

namespace muelle::grader {
namespace {

using Counts = std::vector<int>;

TEST(Histogram, EachIntervalHoldsItsLowerEndAndTheLastBoth) {
  const Histogram histogram = histogramOf({0.0, 1.99, 2.0, 9.5, 10.0}, 10.0, 5);
  EXPECT_EQ(histogram.step, 2.0);
  EXPECT_EQ(histogram.counts, (Counts{2, 1, 0, 0, 2}));
}

TEST(Histogram, RoundOffDoesNotMoveASum) {
  EXPECT_EQ(histogramOf({4.0 - 1e-15}, 10.0, 5).counts, (Counts{0, 0, 1, 0, 0}));
}

TEST(Histogram, IntervalsAreAsNarrowAsTheirNumberAllows) {
  EXPECT_EQ(histogramOf({}, 60.0, 20).counts.size(), 12u);
  EXPECT_EQ(histogramOf({}, 34.0, 20).counts.size(), 17u);
  EXPECT_EQ(histogramOf({}, 1.0, 20).counts.size(), 20u);
  const Histogram uneven = histogramOf({}, 7.5, 4);
  EXPECT_EQ(uneven.counts.size(), 4u);
  EXPECT_EQ(uneven.high(3), 7.5);
}

TEST(Histogram, WithoutPointsThereIsNone) { EXPECT_TRUE(histogramOf({0.0}, 0.0, 20).counts.empty()); }

TEST(Histogram, IsDrawnWithItsCountsItsAxesAndItsMedian) {
  const std::string svg = drawn(histogramOf({1.0, 1.5, 9.0}, 10.0, 5), 1.5);
  for (const char* part : {"0 to below 2: 2<", "8 to 10: 1<", ">median 1.5<", ">points, of 10<", ">students<"})
    EXPECT_NE(svg.find(part), std::string::npos) << part << '\n' << svg;
}

}  // namespace
}  // namespace muelle::grader
