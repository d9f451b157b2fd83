// loses: ShortSpring; misconception: stateful
// at L = 0 the direction of the call before is taken
#include "damping.h"

Vec3 nodeDamping(const Vec3& va, double d) { return -d * va; }

Vec3 relativeDamping(const Vec3& va, const Vec3& vb, double d) { return -d * (va - vb); }

Vec3 projectedDamping(const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
  static Vec3 u = Vec3::Zero();
  const double L = (xa - xb).norm();
  if (L > 0) u = (xa - xb) / L;
  return -d * (va - vb).dot(u) * u;
}
