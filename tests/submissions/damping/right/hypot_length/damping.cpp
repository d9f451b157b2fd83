#include "damping.h"

static double lengthOf(const Vec3& v) { return std::hypot(v.x(), v.y(), v.z()); }

Vec3 nodeDamping(const Vec3& va, double d) { return -(d * va); }

Vec3 relativeDamping(const Vec3& va, const Vec3& vb, double d) { return -(d * va - d * vb); }

Vec3 projectedDamping(const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
  const Vec3 r = xa - xb;
  const double L = lengthOf(r);
  if (L == 0.0) return Vec3::Zero();
  const Vec3 e(r.x() / L, r.y() / L, r.z() / L);
  const double growth = e.x() * (va.x() - vb.x()) + e.y() * (va.y() - vb.y()) + e.z() * (va.z() - vb.z());
  return (-d * growth) * e;
}
