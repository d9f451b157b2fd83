// loses: ShortSpring; misconception: small_threshold or threshold
#include "damping.h"

Vec3 nodeDamping(const Vec3& va, double d) {
  Vec3 force = va;
  force *= -d;
  return force;
}

Vec3 relativeDamping(const Vec3& va, const Vec3& vb, double d) {
  const Vec3 seenFromB = va - vb;
  return -d * seenFromB;
}

Vec3 projectedDamping(const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
  const Vec3 r = xa - xb;
  if (r.isZero()) return Vec3::Zero();
  const Vec3 u = r.normalized();
  return -d * u.dot(va - vb) * u;
}
