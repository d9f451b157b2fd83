#include "base/text/lists.h"

#include <gtest/gtest.h>

#include <set>

namespace muelle {
namespace {

using Texts = std::vector<std::string>;

TEST(Lists, AreJoinedWithSeparatorsBetween) {
  EXPECT_EQ(joined(Texts{"a", "b", "c"}, ", "), "a, b, c");
  EXPECT_EQ(joined(std::set<std::string>{"b", "a"}, " "), "a b");
  EXPECT_EQ(joined(Texts{"alone"}, ", "), "alone");
  EXPECT_EQ(joined(Texts{}, ", "), "");
  EXPECT_EQ(joined(Texts{"", ""}, "-"), "-") << "an empty text stands in a list, too";
}

TEST(Lists, ArePartedWithoutTheBlanksAround) {
  EXPECT_EQ(parted("a,b ,  c d", ","), (Texts{"a", "b", "c d"}));
  EXPECT_EQ(parted("one or two", " or "), (Texts{"one", "two"}));
  EXPECT_EQ(parted("alone", ","), Texts{"alone"});
  EXPECT_EQ(parted("", ","), Texts{""});
  EXPECT_EQ(parted(",a,", ","), (Texts{"", "a", ""}));
}

TEST(Lists, ArePartedAsTheyWereJoined) {
  const Texts texts{"x", "", "two words", "z"};
  EXPECT_EQ(parted(joined(texts, ";"), ";"), texts);
}

}  // namespace
}  // namespace muelle
