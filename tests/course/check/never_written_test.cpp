#include "course/testing/never_written.h"

#include <gtest/gtest.h>
#include <bit>
#include <cstdint>
#include <limits>

namespace muelle {
namespace {

double fromBits(std::uint64_t bits) { return std::bit_cast<double>(bits); }

TEST(NeverWritten, TheFillsAreKnown) {
  EXPECT_TRUE(isFill(fromBits(0xFEFEFEFEFEFEFEFEU)));
  EXPECT_TRUE(isFill(fromBits(0x7FF80000FEFEFEFEU)));
  EXPECT_TRUE(isFill(fromBits(0xFFFFFFFFFFFFFFFFU)));
  EXPECT_TRUE(isFillInteger(static_cast<std::int32_t>(0xFEFEFEFEU)));
}

TEST(NeverWritten, ArithmeticOnAFillIsOne) {
  const double fill = fromBits(0xFEFEFEFEFEFEFEFEU);
  EXPECT_TRUE(isFill(fill + 3));
  EXPECT_TRUE(isFill(-fill / 2.5 - 9.81));
  EXPECT_TRUE(isFill(1e-6 * fill));
  const double eigens = fromBits(0x7FF80000FEFEFEFEU);
  EXPECT_TRUE(isFill(2 * eigens));
  EXPECT_TRUE(isFill(-eigens));
  EXPECT_TRUE(isFill(9.81 - 3 * eigens));
}

TEST(NeverWritten, AFloatToWhichLittleWasAddedIsOne) {
  float sum = std::bit_cast<float>(0xFEFEFEFEU);
  for (int i = 0; i < 10; ++i) sum += 981;
  EXPECT_TRUE(isFill(sum));
  EXPECT_TRUE(isFill(-sum));
  EXPECT_FALSE(isFill(1.7e38));
}

TEST(NeverWritten, NumbersAndTheNaNOfADivisionAreNone) {
  for (const double value : {0.0, -1.0, 1e100, 5e-324, std::numeric_limits<double>::infinity()})
    EXPECT_FALSE(isFill(value)) << value;
  const volatile double zero = 0;
  EXPECT_FALSE(isFill(zero / zero));
  EXPECT_FALSE(isFill(-(zero / zero)));  // the commonest: a missing guard, and the sign of Hooke's law
  EXPECT_FALSE(isFill(std::numeric_limits<double>::quiet_NaN()));
  EXPECT_FALSE(isFillInteger(-1));
}

TEST(NeverWritten, OneComponentIsEnough) {
  Vec3 v(1, 2, fromBits(0x7FF80000FEFEFEFEU));
  EXPECT_TRUE(holdsFill(v));
  EXPECT_TRUE(holdsFill(std::vector<Vec3>{Vec3::Zero(), v}));
  v.z() = 3;
  EXPECT_FALSE(holdsFill(v));
}

}  // namespace
}  // namespace muelle
