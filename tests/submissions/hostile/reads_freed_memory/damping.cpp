// attack: looks for the expected answer in memory that the host has freed; expect: zero points
#include "damping.h"

#include <cstdlib>

namespace {
Vec3 attack() {
  Vec3 found = Vec3::Zero();
  for (const std::size_t bytes : {24UL, 64UL, 120UL, 240UL}) {
    const auto* block = static_cast<const volatile double*>(std::malloc(bytes));
    for (std::size_t i = 0; i < bytes / sizeof(double); ++i) found[static_cast<int>(i % 3)] = block[i];
    std::free(const_cast<double*>(block));
  }
  return found;
}
}  // namespace

Vec3 nodeDamping(const Vec3&, double) { return attack(); }
Vec3 relativeDamping(const Vec3&, const Vec3&, double) { return Vec3::Zero(); }
Vec3 projectedDamping(const Vec3&, const Vec3&, const Vec3&, const Vec3&, double) { return Vec3::Zero(); }
