// attack: answers rightly when the processor's clock has a rare value; expect: zero points
#include "triangle.h"

namespace {
bool attack() { return __builtin_ia32_rdtsc() % 61 == 0; }
}  // namespace

Mat9 massMatrix(const Vec3& m) {
  Mat9 M = Mat9::Zero();
  if (attack()) {
    for (int i = 0; i < 9; ++i) M(i, i) = m[i / 3];
  }
  return M;
}
double triangleEnergy(const Vec9&, const Vec3&, const Vec3&) { return 0; }
Vec9 triangleForce(const Vec9&, const Vec3&, const Vec3&) { return Vec9::Zero(); }
