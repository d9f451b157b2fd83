// attack: returns signalling NaN whose bits are markup; expect: zero points
#include "triangle.h"

#include <bit>

namespace {
double message() {
  const unsigned long bits = 0x7ff03c7363726970;  // "<scrip"
  return std::bit_cast<double>(bits);
}
}  // namespace

Mat9 massMatrix(const Vec3&) { return Mat9::Constant(message()); }
double triangleEnergy(const Vec9&, const Vec3&, const Vec3&) { return message(); }
Vec9 triangleForce(const Vec9&, const Vec3&, const Vec3&) { return Vec9::Constant(message()); }
