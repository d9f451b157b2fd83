#include "damping.h"

// normalized() gives back a zero vector for a zero vector: the force vanishes there by itself.

Vec3 nodeDamping(const Vec3& va, double d) { return va * -d; }

Vec3 relativeDamping(const Vec3& va, const Vec3& vb, double d) { return nodeDamping(va - vb, d); }

Vec3 projectedDamping(const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
  const Vec3 n = (xa - xb).normalized();
  return n * n.dot(relativeDamping(va, vb, d));
}
