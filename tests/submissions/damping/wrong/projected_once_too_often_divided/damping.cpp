// loses: ProjectedDamping, ProjectedMotion; misconception: projected_divided_thrice
#include "damping.h"

Vec3 nodeDamping(const Vec3& va, double d) {
  return Vec3(-d * va[0], -d * va[1], -d * va[2]);
}

Vec3 relativeDamping(const Vec3& va, const Vec3& vb, double d) {
  return Vec3(d * (vb[0] - va[0]), d * (vb[1] - va[1]), d * (vb[2] - va[2]));
}

Vec3 projectedDamping(const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
  const Vec3 r = xa - xb;
  const double L = r.norm();
  if (L == 0.0) return Vec3(0, 0, 0);
  const Vec3 u = r / L;
  return -d * ((va - vb).dot(u) / L) * u;
}
