// loses: ProjectedDamping, ShortSpring, PairLaws, ProjectedMotion; misconception: projected_ignores_b
#include "damping.h"

Vec3 nodeDamping(const Vec3& va, double d) { return -d * va; }

Vec3 relativeDamping(const Vec3& va, const Vec3& vb, double d) { return -d * (va - vb); }

Vec3 projectedDamping(const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
  (void)vb;
  const double L = (xa - xb).norm();
  if (L == 0) return Vec3::Zero();
  const Vec3 u = (xa - xb) / L;
  return nodeDamping(va, d).dot(u) * u;
}
