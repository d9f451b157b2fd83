#include "course/testing/random.h"

#include "base/text/fnv1a.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <array>
#include <cmath>
#include <string>

namespace muelle {

namespace {

std::uint64_t& testSeed() {
  static std::uint64_t seed = 20090906;  // the date of the lecture
  return seed;
}

}  // namespace

double threeDigits(double number) { return std::stod(fmt::format("{:.3g}", number)); }

Vec3 threeDigits(const Vec3& vector) {
  return {threeDigits(vector.x()), threeDigits(vector.y()), threeDigits(vector.z())};
}

double Random::number(double low, double high) {
  constexpr double ulp = 1.0 / 9007199254740992.0;  // 2^-53: 53 random bits make a double in [0, 1)
  return low + (high - low) * static_cast<double>(engine_() >> 11) * ulp;
}

double Random::positive(double low, double high) { return std::exp(number(std::log(low), std::log(high))); }

double Random::rounded(double low, double high) { return threeDigits(number(low, high)); }

int Random::integer(int low, int high) {
  return low + static_cast<int>(engine_() % static_cast<std::uint64_t>(high - low + 1));
}

Vec3 Random::vector3(double scale) {
  const double x = number(-scale, scale);
  const double y = number(-scale, scale);
  const double z = number(-scale, scale);
  return {x, y, z};
}

double Random::normal() {  // Box and Muller (1958)
  const double radius = std::sqrt(-2.0 * std::log(1.0 - number(0, 1)));
  return radius * std::cos(number(0, 2 * M_PI));
}

Vec3 Random::direction() {
  const double x = normal();
  const double y = normal();
  const double z = normal();
  return Vec3(x, y, z).normalized();
}

Vec3 Random::roundedDirection() {
  // Squares that sum to 1 in decimals.
  static constexpr std::array<std::array<double, 3>, 4> units{
      {{0.48, 0.6, 0.64}, {0.36, 0.48, 0.8}, {0.28, 0.576, 0.768}, {0.224, 0.6, 0.768}}};
  const std::array<double, 3>& unit = units[static_cast<std::size_t>(integer(0, 3))];
  const int first = integer(0, 2);
  const int step = integer(1, 2);
  Vec3 direction;
  for (int i = 0; i < 3; ++i) {
    const double size = unit[static_cast<std::size_t>((first + step * i) % 3)];
    direction[i] = integer(0, 1) == 0 ? size : -size;
  }
  return direction;
}

Mat3 Random::rotation() {
  // A unit quaternion uniform on the 3-sphere is a rotation uniform over SO(3) (Shoemake 1992).
  Eigen::Vector4d q(normal(), normal(), normal(), normal());
  q.normalize();
  const double w = q[0];
  const Vec3 u = q.tail<3>();
  Mat3 cross;
  cross << 0, -u[2], u[1], u[2], 0, -u[0], -u[1], u[0], 0;
  return (w * w - u.squaredNorm()) * Mat3::Identity() + 2 * u * u.transpose() + 2 * w * cross;
}

Random testRandom() {
  std::uint64_t seed = testSeed();
  if (const auto* info = ::testing::UnitTest::GetInstance()->current_test_info()) {
    seed = fnv1a(info->name(), fnv1a(info->test_suite_name(), seed));
  }
  return Random(seed);
}

void setTestSeed(std::uint64_t seed) { testSeed() = seed; }

}  // namespace muelle
