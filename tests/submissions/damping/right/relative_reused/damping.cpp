#include "damping.h"

Vec3 nodeDamping(const Vec3& va, double d) { return -d * va; }

// a is braked, b drags a along
Vec3 relativeDamping(const Vec3& va, const Vec3& vb, double d) { return nodeDamping(va, d) - nodeDamping(vb, d); }

Vec3 projectedDamping(const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
  const Vec3 all = relativeDamping(va, vb, d);
  const Vec3 r = xa - xb;
  const double L = r.norm();
  if (L != 0.0) {
    const double part = all.dot(r / L);
    return part * (r / L);
  }
  return Vec3::Zero();
}
