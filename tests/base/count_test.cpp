#include "base/text/count.h"

#include <gtest/gtest.h>

namespace muelle {
namespace {

TEST(Count, AgreesWithItsNoun) {
  EXPECT_EQ(counted(0, "node"), "0 nodes");
  EXPECT_EQ(counted(1, "node"), "1 node");
  EXPECT_EQ(counted(2, "node"), "2 nodes");
  EXPECT_EQ(counted(1, "vertex", "vertices"), "1 vertex");
  EXPECT_EQ(counted(8, "vertex", "vertices"), "8 vertices");
  EXPECT_EQ(counted(-1, "step"), "-1 steps");
  EXPECT_EQ(nounFor(1, "face"), "face");
}

TEST(Count, GroupsItsDigits) {
  EXPECT_EQ(grouped(999), "999");
  EXPECT_EQ(grouped(1000), "1,000");
  EXPECT_EQ(grouped(1234567), "1,234,567");
  EXPECT_EQ(grouped(-123456), "-123,456");
  EXPECT_EQ(countedInGroups(16649, "spring"), "16,649 springs");
  EXPECT_EQ(countedInGroups(1, "property", "properties"), "1 property");
}

}  // namespace
}  // namespace muelle
