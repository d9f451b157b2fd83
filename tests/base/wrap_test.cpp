#include "base/text/wrap.h"
#include "base/text/utf8.h"

#include <gtest/gtest.h>

namespace muelle {
namespace {

using Lines = std::vector<std::string>;

TEST(Wrap, PartsAtBlanksAndInsideOfWordsThatAreTooLong) {
  EXPECT_EQ(wrap("the force is right", 9), (Lines{"the force", "is right"}));
  EXPECT_EQ(wrap("abcdefgh ij", 3), (Lines{"abc", "def", "gh", "ij"}));
  EXPECT_EQ(wrap("", 5), Lines{});
}

TEST(Wrap, TakesAtLeastOneCharacterALine) {
  EXPECT_EQ(wrap("日本", 1), (Lines{"日", "本"}));
  EXPECT_EQ(wrap("ab", 0), (Lines{"a", "b"}));
}

TEST(Fitted, FillsOrCutsToTheColumns) {
  EXPECT_EQ(fitted("ab", 4), "ab  ");
  EXPECT_EQ(fitted("abcd", 4), "abcd");
  EXPECT_EQ(fitted("abcde", 4), "abc…");
  EXPECT_EQ(fitted("日本語", 4), "日… ");
  for (int width = 1; width < 9; ++width) EXPECT_EQ(columns(fitted("Núñez 日本", width)), width);
}

}  // namespace
}  // namespace muelle
