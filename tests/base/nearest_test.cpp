#include "base/text/nearest.h"

#include <gtest/gtest.h>

namespace muelle {
namespace {

TEST(Nearest, CountsEdits) {
  EXPECT_EQ(editDistance("points", "points"), 0);
  EXPECT_EQ(editDistance("pionts", "points"), 1);  // two neighbours swapped
  EXPECT_EQ(editDistance("point", "points"), 1);
  EXPECT_EQ(editDistance("", "abc"), 3);
  EXPECT_EQ(editDistance("kitten", "sitting"), 3);
}

TEST(Nearest, SuggestsOnlyWhatIsNear) {
  const std::vector<std::string> names{"spring_1d", "spring_3d", "damping"};
  EXPECT_EQ(nearest("sprng_3d", names), "spring_3d");
  EXPECT_EQ(nearest("damp", names), "damping");
  EXPECT_EQ(nearest("zebra", names), "");
  EXPECT_EQ(nearest("x", names), "");
  EXPECT_EQ(didYouMean("dampping", names), "; did you mean 'damping'?");
  EXPECT_EQ(didYouMean("zebra", names), "");
}

}  // namespace
}  // namespace muelle
