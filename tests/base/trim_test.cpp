#include "base/text/trim.h"

#include <gtest/gtest.h>

namespace muelle {
namespace {

TEST(Trimmed, LosesTheBlanksAroundIt) {
  EXPECT_EQ(trimmed(" \t two words\r\n"), "two words");
  EXPECT_EQ(trimmed("x"), "x");
}

TEST(Trimmed, OfBlanksAloneIsEmpty) {
  EXPECT_EQ(trimmed(""), "");
  EXPECT_EQ(trimmed(" \t\r\n"), "");
}

}  // namespace
}  // namespace muelle
