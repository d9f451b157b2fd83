#include "damping.h"

// Each end has its own speed along the spring; the length grows at their difference.

Vec3 nodeDamping(const Vec3& va, double d) { return -d * va; }

Vec3 relativeDamping(const Vec3& va, const Vec3& vb, double d) { return d * vb - d * va; }

Vec3 projectedDamping(const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
  const double L = (xa - xb).norm();
  if (L == 0.0) return Vec3::Zero();
  const Vec3 u = (xa - xb) / L;
  const double speedA = va.dot(u);
  const double speedB = vb.dot(u);
  return d * (speedB - speedA) * u;
}
