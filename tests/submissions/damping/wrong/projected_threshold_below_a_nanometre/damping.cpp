// loses: ShortSpring; misconception: threshold
#include "damping.h"

Vec3 nodeDamping(const Vec3& va, double d) {
  return Vec3(-d * va[0], -d * va[1], -d * va[2]);
}

Vec3 relativeDamping(const Vec3& va, const Vec3& vb, double d) {
  return Vec3(d * (vb[0] - va[0]), d * (vb[1] - va[1]), d * (vb[2] - va[2]));
}

Vec3 projectedDamping(const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
  const double x = xa[0] - xb[0], y = xa[1] - xb[1], z = xa[2] - xb[2];
  const double L = std::sqrt(x * x + y * y + z * z);
  if (L <= 5e-10) return Vec3(0, 0, 0);
  const double size = -d * ((va[0] - vb[0]) * x + (va[1] - vb[1]) * y + (va[2] - vb[2]) * z) / L;
  return Vec3(size * x / L, size * y / L, size * z / L);
}
