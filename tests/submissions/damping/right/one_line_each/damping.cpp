#include "damping.h"

Vec3 nodeDamping(const Vec3& va, double d) { return va * -d; }

Vec3 relativeDamping(const Vec3& va, const Vec3& vb, double d) { return nodeDamping(va - vb, d); }

// normalized() leaves a zero vector as it is.
Vec3 projectedDamping(const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
  const Vec3 u = (xa - xb).normalized();
  return u.dot(relativeDamping(va, vb, d)) * u;
}
