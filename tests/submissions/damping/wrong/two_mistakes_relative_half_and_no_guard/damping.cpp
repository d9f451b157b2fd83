// loses: RelativeDamping, ShortSpring, RelativeMotion; misconception: relative_half or halved or divides_by_zero or missing_guard
#include "damping.h"

Vec3 nodeDamping(const Vec3& va, double d) {
  return -d * va;
}

Vec3 relativeDamping(const Vec3& va, const Vec3& vb, double d) {
  return -0.5 * d * (va - vb);
}

Vec3 projectedDamping(const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
  Vec3 u = (xa - xb) / (xa - xb).norm();
  return -d * (va - vb).dot(u) * u;
}
