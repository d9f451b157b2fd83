// loses: ProjectedDamping, ProjectedMotion; misconception: projected_stretching_only or one_sided
#include "damping.h"

Vec3 nodeDamping(const Vec3& va, double d) { return -d * va; }

Vec3 relativeDamping(const Vec3& va, const Vec3& vb, double d) { return -d * (va - vb); }

Vec3 projectedDamping(const Vec3& xa, const Vec3& xb, const Vec3& va, const Vec3& vb, double d) {
  const double L = (xa - xb).norm();
  if (L == 0) return Vec3::Zero();
  const Vec3 u = (xa - xb) / L;
  const double rate = std::max(0.0, (va - vb).dot(u));
  return -d * rate * u;
}
