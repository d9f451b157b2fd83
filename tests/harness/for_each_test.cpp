#include "harness/for_each.h"

#include <gtest/gtest.h>

namespace muelle {
namespace {

#define COUNT_(x) +1
#define APPEND_(x) text += #x " ";
#define MULTIPLY_(by, x) +(by) * (x)
#define TEN_(x) x##0, x##1, x##2, x##3, x##4, x##5, x##6, x##7, x##8, x##9

TEST(ForEach, ExpandsOnceForEachArgument) {
  EXPECT_EQ(0 MUELLE_FOR_EACH(COUNT_), 0);
  EXPECT_EQ(0 MUELLE_FOR_EACH(COUNT_, a), 1);
  EXPECT_EQ(0 MUELLE_FOR_EACH(COUNT_, a, b), 2);
  EXPECT_EQ(0 MUELLE_FOR_EACH(COUNT_, TEN_(1), TEN_(2), TEN_(3), TEN_(4)), 40);
  EXPECT_EQ(0 MUELLE_FOR_EACH(COUNT_, TEN_(1), TEN_(2), TEN_(3), TEN_(4), TEN_(5), TEN_(6), TEN_(7), TEN_(8)), 80);
}

TEST(ForEach, KeepsTheOrder) {
  std::string text;
  MUELLE_FOR_EACH(APPEND_, a, b, c)
  EXPECT_EQ(text, "a b c ");
}

TEST(ForEachWith, PassesTheExtraArgumentAlong) {
  EXPECT_EQ(0 MUELLE_FOR_EACH_WITH(MULTIPLY_, 3), 0);
  EXPECT_EQ(0 MUELLE_FOR_EACH_WITH(MULTIPLY_, 3, 5), 15);
  EXPECT_EQ(0 MUELLE_FOR_EACH_WITH(MULTIPLY_, 1, TEN_(1), TEN_(2), TEN_(3), TEN_(4)), 145 + 245 + 345 + 445);
  EXPECT_EQ(
      0 MUELLE_FOR_EACH_WITH(MULTIPLY_, 1, TEN_(1), TEN_(1), TEN_(1), TEN_(1), TEN_(1), TEN_(1), TEN_(1), TEN_(1)),
      8 * 145);
}

}  // namespace
}  // namespace muelle
