#include "figures/data_block.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>

namespace muelle {
namespace {

std::string block(std::vector<double> x, std::vector<double> y, bool logY = false) {
  return dataBlock({"", std::move(x), std::move(y)}, false, logY);
}

std::ptrdiff_t lineCount(const std::string& text) { return std::count(text.begin(), text.end(), '\n'); }

TEST(DataBlock, HasALineForEachPoint) {
  EXPECT_EQ(block({0, 0.5, 1}, {1, 2, 1.0 / 3.0}), "0 1\n0.5 2\n1 0.333333333333\n");
}

TEST(DataBlock, MakesOneGapOfWhatCannotBeDrawn) {
  EXPECT_EQ(block({0, 1, 2, 3, 4, 5, 6}, {NAN, 1, HUGE_VAL, -HUGE_VAL, 1e101, 5, NAN}), "1 1\n\n5 5\n");
  EXPECT_EQ(block({0, NAN, 2}, {0, 1, 2}), "0 0\n\n2 2\n");
  EXPECT_EQ(block({0, 1, 2}, {1, 0, 2}, true), "0 1\n\n2 2\n");
  EXPECT_EQ(block({0, 1}, {NAN, NAN}), "");
  EXPECT_EQ(block({}, {}), "");
}

TEST(DataBlock, ThinsALongCurveAndKeepsItsExtremes) {
  std::vector<double> x, y;
  for (int i = 0; i < 100000; ++i) {
    x.push_back(i);
    y.push_back(i == 54321 ? 7.0 : (i == 77777 ? -8.0 : 1e-3 * std::sin(i)));
  }
  const std::string text = block(x, y);
  EXPECT_LE(lineCount(text), 4 * 801);
  EXPECT_NE(text.find("\n54321 7\n"), std::string::npos);
  EXPECT_NE(text.find("\n77777 -8\n"), std::string::npos);
  EXPECT_EQ(text.substr(0, 4), "0 0\n");
  EXPECT_NE(text.find("\n99999 "), std::string::npos);
}

TEST(DataBlock, ThinsALongPathWithoutMovingItFar) {
  std::vector<double> x, y;
  const int n = 100000;
  for (int i = 0; i <= n; ++i) {
    x.push_back(std::cos(2 * M_PI * i / n));
    y.push_back(std::sin(2 * M_PI * i / n));
  }
  const std::ptrdiff_t lines = lineCount(block(x, y));
  EXPECT_LT(lines, 10000);  // 2 pi / (2 / 2000) steps of the allowed distance, up to sqrt(2) for its two directions
  EXPECT_GT(lines, 3000);
}

TEST(DataBlock, KeepsGapsInALongCurve) {
  std::vector<double> x, y;
  for (int i = 0; i < 20000; ++i) {
    x.push_back(i);
    y.push_back(i > 9000 && i < 9100 ? NAN : 1.0);
  }
  const std::string text = block(x, y);
  EXPECT_NE(text.find("9000 1\n\n9100 1\n"), std::string::npos);
}

TEST(DataBlock, ShowsALongConstantOnOneSpot) {
  EXPECT_NE(block(std::vector<double>(10000, 1.0), std::vector<double>(10000, 2.0)), "");
}

}  // namespace
}  // namespace muelle
