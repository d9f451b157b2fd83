#include "damping.h"

Vec3 nodeDamping(const Vec3& va, double d) {
  Vec3 force = va;
  force *= -d;
  return force;
}

Vec3 relativeDamping(const Vec3& va, const Vec3& vb, double d) {
  Vec3 force = vb;
  force -= va;
  return force * d;
}

Vec3 projectedDamping(const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
  if (xa == xb) return Vec3::Zero();
  const Vec3 axis = (xa - xb).stableNormalized();
  const Vec3 seenFromB = va - vb;
  return -d * (seenFromB.dot(axis) * axis);
}
