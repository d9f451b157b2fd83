// loses: ShortSpring; misconception: small_threshold or threshold
// thought: relative to the positions
#include "damping.h"

Vec3 nodeDamping(const Vec3& va, double d) {
  return -d * va;
}

Vec3 relativeDamping(const Vec3& va, const Vec3& vb, double d) {
  Vec3 v = va - vb;
  return -d * v;
}

Vec3 projectedDamping(const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
  if (xa.isApprox(xb, 1e-6)) return Vec3::Zero();
  Vec3 u = (xa - xb).normalized();
  double rate = (va - vb).dot(u);
  return -d * rate * u;
}
