// loses: ShortSpring; misconception: divides_by_zero or missing_guard
#include "damping.h"

Vec3 nodeDamping(const Vec3& va, double d) { return -d * va; }

Vec3 relativeDamping(const Vec3& va, const Vec3& vb, double d) { return d * (vb - va); }

Vec3 projectedDamping(const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
  Vec3 u = (xa - xb) / (xa - xb).norm();
  double rate = (va - vb).transpose() * u;
  return -d * rate * u;
}
