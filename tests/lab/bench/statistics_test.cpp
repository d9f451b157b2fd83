#include "lab/bench/statistics.h"

#include "lab/bench/stopwatch.h"

#include <gtest/gtest.h>
#include <numeric>
#include <stdexcept>

namespace muelle::bench {
namespace {

std::vector<double> upTo(int n) {
  std::vector<double> values(static_cast<std::size_t>(n));
  std::iota(values.rbegin(), values.rend(), 1.0);  // n ... 1: the order must not matter
  return values;
}

TEST(Statistics, OfFifteenValuesTheMedianAndItsInterval) {
  // P(at most 3 of 15 below the median) = (1 + 15 + 105 + 455) / 2^15 = 1.76 %, at most 4: 5.92 %. So three are cut
  // off at each end, and the 4th and the 12th are left.
  const Statistics s = statisticsOf(upTo(15));
  EXPECT_EQ(s.count, 15);
  EXPECT_EQ(s.least, 1.0);
  EXPECT_EQ(s.median, 8.0);
  EXPECT_EQ(s.percentile95, 15.0);  // the 15th is the first that 95 % of 15 (14.25) do not exceed
  EXPECT_EQ(s.low, 4.0);
  EXPECT_EQ(s.high, 12.0);
}

TEST(Statistics, OfEightValuesNoneIsCutOff) {
  // One below the median at most: (1 + 8) / 2^8 = 3.5 % at one end, 7 % at both, more than the 5 % that may be missed.
  EXPECT_EQ(statisticsOf(upTo(8)).low, 1.0);
  EXPECT_EQ(statisticsOf(upTo(8)).high, 8.0);
  EXPECT_EQ(statisticsOf(upTo(9)).low, 2.0);  // (1 + 9) / 2^9 = 2 %
}

TEST(Statistics, OfFewValuesTheIntervalIsAllOfThem) {
  const Statistics s = statisticsOf({3.0, 1.0, 2.0, 10.0});
  EXPECT_EQ(s.median, 2.5);
  EXPECT_EQ(s.low, 1.0);
  EXPECT_EQ(s.high, 10.0);
}

TEST(Statistics, OfAHundredValuesThe95thPercentileIsThe95th) { EXPECT_EQ(statisticsOf(upTo(100)).percentile95, 95.0); }

TEST(Statistics, OfNothingAreRefused) { EXPECT_THROW(statisticsOf({}), std::invalid_argument); }

/// A clock that work moves on.
struct FakeClock {
  double time = 100.0;
  Clock read() {
    return [this] { return time; };
  }
};

TEST(Stopwatch, ALongRunIsTimedOnce) {
  FakeClock clock;
  int calls = 0;
  const auto work = [&] {
    ++calls;
    clock.time += 0.5;
  };
  EXPECT_DOUBLE_EQ(secondsOf(work, clock.read(), 0.25), 0.5);
  EXPECT_EQ(calls, 1);
}

TEST(Stopwatch, AShortRunIsRepeatedAndItsTimeIsTheMean) {
  FakeClock clock;
  int calls = 0;
  const auto work = [&] { clock.time += ++calls % 2 == 0 ? 0.25 : 0.125; };  // binary fractions: sums are exact
  // Looked at after 1, 2, 4 and 8 calls: 0.125, 0.375, 0.75 and 1.5, the first that is not below 1.
  EXPECT_DOUBLE_EQ(secondsOf(work, clock.read(), 1.0), 1.5 / 8.0);
  EXPECT_EQ(calls, 8);
}

TEST(Stopwatch, TheProcessorsTimeGrowsWithWork) {
  const double before = processorTime();
  volatile double sum = 0.0;
  while (processorTime() - before < 1e-3) sum = sum + 1.0;
  EXPECT_GE(processorTime() - before, 1e-3);
}

}  // namespace
}  // namespace muelle::bench
