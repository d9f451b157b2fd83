#include "damping.h"

Vec3 nodeDamping(const Vec3& va, double d) { return va * -d; }

Vec3 relativeDamping(const Vec3& va, const Vec3& vb, double d) {
  return nodeDamping(va - vb, d);  // the node's velocity as b sees it
}

Vec3 projectedDamping(const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
  Vec3 u = xa - xb;
  double L = u.norm();
  if (L == 0) return Vec3::Zero();
  u /= L;
  return u.dot(relativeDamping(va, vb, d)) * u;
}
